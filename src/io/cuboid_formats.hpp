#pragma once

#include "io/atomic_file.hpp"

#include <filesystem>

#include <rmap/cuboids.hpp>

/// The formats of cuboid_files.cpp, each in a file of its own. Writers are given lists that
/// check_cuboids has passed; readers throw as read_cuboids.
namespace rmap {

void write_cuboid_rcs(AtomicFile& file, const CuboidList& list);
CuboidList read_cuboid_rcs(const std::filesystem::path& file);

void write_cuboid_csv(AtomicFile& file, const CuboidList& list);
CuboidList read_cuboid_csv(const std::filesystem::path& file);

void write_cuboid_json(AtomicFile& file, const CuboidList& list);

/// Meshes, coloured by height.
void write_cuboid_ply(AtomicFile& file, const CuboidList& list);
void write_cuboid_glb(AtomicFile& file, const CuboidList& list);

void write_cuboid_urdf(AtomicFile& file, const CuboidList& list);
void write_cuboid_sdf(AtomicFile& file, const CuboidList& list);
void write_cuboid_mjcf(AtomicFile& file, const CuboidList& list);
void write_cuboid_scene(AtomicFile& file, const CuboidList& list);

/// Throws Error(input) when the resolution, the frame or a cuboid is not what a file may hold.
void check_cuboids(const CuboidList& list);

}  // namespace rmap
