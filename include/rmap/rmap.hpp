#pragma once

/// The whole library, for programs. Its own parts name the headers that they need.

#include <rmap/beam.hpp>
#include <rmap/block.hpp>
#include <rmap/box.hpp>
#include <rmap/box_query.hpp>
#include <rmap/cast_ray.hpp>
#include <rmap/cell.hpp>
#include <rmap/cell_files.hpp>
#include <rmap/cells.hpp>
#include <rmap/changes.hpp>
#include <rmap/compare.hpp>
#include <rmap/crop.hpp>
#include <rmap/error.hpp>
#include <rmap/function_ref.hpp>
#include <rmap/grid.hpp>
#include <rmap/lattice.hpp>
#include <rmap/leaf.hpp>
#include <rmap/map_file.hpp>
#include <rmap/multiresolution.hpp>
#include <rmap/options.hpp>
#include <rmap/packed_block.hpp>
#include <rmap/pose.hpp>
#include <rmap/report.hpp>
#include <rmap/rtree.hpp>
#include <rmap/scan.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_filter.hpp>
#include <rmap/scan_source.hpp>
#include <rmap/simulation.hpp>
#include <rmap/value.hpp>
