#pragma once

#include <cstdint>
#include <filesystem>

#include <rmap/box.hpp>
#include <rmap/function_ref.hpp>

namespace rmap {

/// A cell as it leaves for other programs.
struct CellRow {
  Vector3d center = Vector3d::Zero();  ///< metres, map's frame
  double size = 0;                     ///< edge, metres
  double probability = 0;              ///< of being occupied
  bool occupied = false;               ///< else free
};

/// Takes cells one at a time.
using CellSink = FunctionRef<void(const CellRow&)>;

/// Writes cells to `file` in the form of its ending:
///
/// - `.csv`: the header `x,y,z,size,probability,state`, numbers with as many digits as
///   give the same double back, state `occupied` or `free`;
/// - `.ply`: binary little-endian vertices x y z probability (float), state (uchar:
///   1 occupied, 0 free);
/// - `.pcd`: binary x y z probability (float32).
///
/// `cells` is called once with a sink and passes it every cell, so no list of them is
/// ever in memory:
///
///     write_cells("map.ply", [&](rmap::CellSink sink) { for (...) sink({.center = ...}); });
///
/// Returns the number of cells. Complete or not at all: when `cells` throws or the disk
/// is full, a former file is untouched. Throws Error(input) for another ending, Error(io)
/// when writing fails.
std::uint64_t write_cells(const std::filesystem::path& file, FunctionRef<void(CellSink)> cells);

}  // namespace rmap
