#include "cuboid_input.hpp"

#include "arguments.hpp"
#include "octomap_maps.hpp"
#include "progress.hpp"
#include "stopwatch.hpp"

#include <array>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/map_file.hpp>
#include <rmap/octomap_file.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap::command {

namespace {

constexpr double kDefaultResolution = 0.1;

// Cells keep the axes that they have.
void refuse_other_lattice(const std::filesystem::path& file, double resolution,
                          const CuboidInputOptions& options) {
  if (options.resolution && *options.resolution != resolution) {
    throw Error(ErrorKind::input,
                fmt::format("{} has a resolution of {} m, not {} m: leave --resolution out, or "
                            "build the map anew",
                            file.string(), resolution, *options.resolution));
  }
  const bool turned = !options.frame.given.matrix().isIdentity(0);
  if (turned || options.frame.phase != CuboidPhase::zero) {
    throw Error(ErrorKind::input,
                fmt::format("{} is a map, whose cells keep their axes: --frame and --phase are "
                            "for points",
                            file.string()));
  }
}

CuboidInput read_map(const std::filesystem::path& file, bool octomap,
                     const CuboidInputOptions& options) {
  CuboidInput input;
  Stopwatch watch;
  if (octomap) {
    const OctomapCells map = read_octomap(file, {.max_cells = options.max_cells});
    input.resolution = map.resolution;
    for (const Cell& cell : map.occupied) input.cells.push_back({cell, 1});
    input.seconds_read = watch.lap();
    input.cells = sorted_cells(std::move(input.cells));
  } else {
    const Grid grid = load(file);
    input.resolution = grid.lattice().resolution();
    input.seconds_read = watch.lap();
    input.cells = occupied_cells(grid);
  }
  input.seconds_quantise = watch.lap();
  refuse_other_lattice(file, input.resolution, options);
  input.why_frame = "the cells of a map keep their axes";
  return input;
}

// Points of all scans in the map's frame, or of one cloud.
std::vector<Vector3f> read_all_points(const std::filesystem::path& file) {
  std::error_code missing;
  if (!std::filesystem::is_directory(file, missing)) return read_points(file);
  std::vector<Vector3f> points;
  const auto scans = read_ahead(open_scans(file));
  Progress progress("reading", scans->size());
  for (Scan scan; scans->next(scan); progress.advance()) {
    for (const Vector3f& point : scan.points) {
      points.push_back(transformed(scan.map_from_sensor, point).cast<float>());
    }
  }
  return points;
}

CuboidInput read_cloud(const std::filesystem::path& file, const CuboidInputOptions& options) {
  CuboidInput input;
  input.resolution = options.resolution.value_or(kDefaultResolution);
  const Lattice lattice(input.resolution);
  Stopwatch watch;
  const std::vector<Vector3f> points = read_all_points(file);
  input.seconds_read = watch.lap();
  input.frame = options.frame.given;
  input.why_frame = "it was asked for";
  if (options.frame.estimate) {
    const FrameEstimate estimate = estimate_frame(
        points,
        {.resolution = input.resolution, .outer = options.outer, .threads = options.threads});
    input.frame = estimate.frame;
    input.why_frame = estimate.why;
  }
  input.frame.pretranslate(phase_shift(points, input.frame, input.resolution, options.frame.phase));
  input.seconds_frame = watch.lap();
  QuantizedPoints quantized = quantize(points, lattice, input.frame);
  input.cells = std::move(quantized.cells);
  input.not_finite = quantized.not_finite;
  input.beyond_limits = quantized.beyond_limits;
  input.seconds_quantise = watch.lap();
  return input;
}

}  // namespace

CuboidInput read_cuboid_input(const std::filesystem::path& file,
                              const CuboidInputOptions& options) {
  const std::string ending = ending_of(file);
  std::error_code missing;
  const bool folder = std::filesystem::is_directory(file, missing);
  const bool octomap = is_octomap(file);
  if (!folder && (ending == ".rmap" || octomap)) return read_map(file, octomap, options);
  if (!folder && !is_point_file(file)) {
    throw Error(ErrorKind::input,
                fmt::format("{} is no map (.rmap, .bt, .ot), no cloud (.pcd, .ply, .las and so on) "
                            "and no folder of scans",
                            file.string()));
  }
  return read_cloud(file, options);
}

FrameChoice frame_argument(const std::string& text) {
  if (text == "identity") return {};
  if (text == "estimate") return {.estimate = true};
  std::array<double, 4> numbers;
  if (!parse_numbers(text, numbers)) {
    throw UsageError(
        fmt::format("--frame is \"{}\": it must be identity, estimate or a "
                    "quaternion qx,qy,qz,qw",
                    text));
  }
  try {
    const Eigen::Quaterniond rotation(numbers[3], numbers[0], numbers[1], numbers[2]);
    return {.given = make_pose(Vector3d::Zero(), rotation)};
  } catch (const Error& error) {
    throw UsageError(fmt::format("--frame is \"{}\": {}", text, error.what()));
  }
}

}  // namespace rmap::command
