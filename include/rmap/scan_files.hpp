#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <rmap/pose.hpp>
#include <rmap/scan.hpp>
#include <rmap/scan_read_options.hpp>

namespace rmap {

/// Most points that a file may hold: 2^28, 3 GiB in memory.
inline constexpr std::size_t kMaxPointsPerFile = std::size_t{1} << 28;

/// The ending of a file's name in lower case, with its dot: what tells formats apart. Empty
/// without one.
std::string ending_of(const std::filesystem::path& file);

/// Whether `file` is named as a file of points that `read_points` reads; nothing is opened.
bool is_point_file(const std::filesystem::path& file);

/// The points of one file, metres, in the order of the file; the formats are those of
/// `open_scans`. Points that are not finite stay in; coordinates beyond float32 become
/// infinite. No poses are needed or used; `options.columns` says what a `.bin` holds,
/// `options.offset` is taken off the points unless `options.frame` is the sensor's. Throws
/// Error(input) for content that the format does not allow, Error(limit) for more than
/// `kMaxPointsPerFile`, Error(io) for a file that cannot be read.
std::vector<Vector3f> read_points(const std::filesystem::path& file,
                                  const ScanReadOptions& options = {});

/// Metres from the largest finite coordinate to its neighbour, as float32 keeps it: 0.5 at
/// 5,600,000. 0 where no coordinate is beyond 1e5.
double coordinate_step(std::span<const Vector3f> points);

/// Writes points as `.bin` (intensity 0) or `.pcd` (binary x y z), by the ending of
/// `file`; reading gives the same bits back. An empty `.bin` cannot be told from a
/// failed copy: no points are an Error(input) there, and fine in a `.pcd`. Complete
/// or not at all: on Error(io) a former file is untouched.
void write_points(const std::filesystem::path& file, std::span<const Vector3f> points);

/// The poses (sensor's frame to the map's) of a text file, one a line: 12 numbers
/// (3x4 matrix, row by row), 16 (4x4), 7 (tx ty tz qx qy qz qw, unless `order` says
/// qw first) or 8 (time, then these 7; the time is not kept), the same form in all lines, separated
/// by blanks.
/// `#` starts a comment; blank lines are skipped. Matrices must pass `check_pose` and
/// are kept as they are; quaternions are normalised. Throws Error(input) with the line.
std::vector<Pose> read_poses(const std::filesystem::path& file,
                             QuaternionOrder order = QuaternionOrder::xyzw);

/// Writes one line of 12 numbers a pose, 17 significant digits: reading gives the same
/// poses back. Complete or not at all, as `write_points`.
void write_poses(const std::filesystem::path& file, std::span<const Pose> poses);

/// Writes a folder that `open_scans` reads: `000000.bin`, `000001.bin`, ... and at the
/// end `poses.txt`, so a folder that was broken off cannot pass for a complete one.
class ScanFolderWriter {
 public:
  /// Creates `folder` where it is missing. `ending` is ".bin" or ".pcd". Throws
  /// Error(input) when the folder holds scans or poses already, or for another ending.
  explicit ScanFolderWriter(std::filesystem::path folder, std::string ending = ".bin");

  /// Writes the scan's points and keeps its pose; directions without return have no
  /// place in the files. Throws Error(usage) for a scan in the map's frame, Error as
  /// `write_points`.
  void add(const Scan& scan);

  /// Writes the poses. Nothing may be added after it.
  void finish();

 private:
  std::filesystem::path folder_;
  std::string ending_;
  std::vector<Pose> poses_;
  bool finished_ = false;
};

}  // namespace rmap
