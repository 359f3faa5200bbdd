#pragma once

#include <filesystem>

#include <rmap/cuboids.hpp>

namespace rmap {

/// Writes cuboids to `file` in the form of its ending:
///
/// - `.rcs`: ours, compressed, versioned and checksummed: docs/formats/rcs.md;
/// - `.csv`: a comment line with resolution and frame (3x4, so that it comes back as it was), the
///   header `min_x,min_y,min_z,max_x,max_y,max_z,points,density`, one cuboid a line, metres in the
///   frame of the cells, numbers with as many digits as give the same double back;
/// - `.json`: the same as an object;
/// - `.ply`, `.glb`: meshes to look at, in the input's frame, coloured by height;
/// - `.urdf`, `.sdf`, `.xml` (MuJoCo), `.scene` (MoveIt): one box for each cuboid, in the input's
///   frame.
///
/// docs/formats/cuboids.md says what each of them holds. Complete or not at all: when the disk is
/// full a former file is untouched. Throws Error(input) for another ending, and when resolution or
/// frame are not sound or a cuboid is empty or beyond the limits; Error(limit) for more cuboids
/// than the format can hold (.glb: 4.7 million, .ply: 268 million); Error(io) when writing fails.
void write_cuboids(const std::filesystem::path& file, const CuboidList& list);

/// Reads a `.rcs` or a `.csv` file that write_cuboids made: the same list. Throws Error(io) when it
/// cannot be read, Error(input) when it is not such a file or damaged.
CuboidList read_cuboids(const std::filesystem::path& file);

}  // namespace rmap
