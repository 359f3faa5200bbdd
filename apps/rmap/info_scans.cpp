#include "info.hpp"
#include "progress.hpp"
#include "words.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include <rmap/pose.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap::command {

namespace {

// Smallest and largest of the numbers and vectors that it has seen.
class Extent {
 public:
  void add(const Vector3d& point) {
    box_.min = box_.min.cwiseMin(point);
    box_.max = box_.max.cwiseMax(point);
    ++count_;
  }

  std::uint64_t count() const { return count_; }
  Json json() const { return count_ == 0 ? Json(nullptr) : json_of(box_); }
  std::string words() const { return count_ == 0 ? "none" : readable_box(box_) + " m"; }

 private:
  Box box_{.min = Vector3d::Constant(std::numeric_limits<double>::infinity()),
           .max = Vector3d::Constant(-std::numeric_limits<double>::infinity())};
  std::uint64_t count_ = 0;
};

struct ScansSummary {
  std::uint64_t scans = 0;
  std::uint64_t points = 0;
  std::uint64_t points_min = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t points_max = 0;
  std::uint64_t not_finite = 0;
  double range_min = std::numeric_limits<double>::infinity();
  double range_max = 0;
  double path_length = 0;  // metres
  Extent bounds;

  void add(const Scan& scan) {
    ++scans;
    points += scan.points.size();
    points_min = std::min<std::uint64_t>(points_min, scan.points.size());
    points_max = std::max<std::uint64_t>(points_max, scan.points.size());
    for (const Vector3f& point : scan.points) {
      if (!point.allFinite()) {
        ++not_finite;
        continue;
      }
      const double range = point.cast<double>().norm();
      range_min = std::min(range_min, range);
      range_max = std::max(range_max, range);
      bounds.add(transformed(scan.map_from_sensor, point));
    }
    const Vector3d position = scan.map_from_sensor.translation();
    if (last_position_) path_length += (position - *last_position_).norm();
    last_position_ = position;
  }

 private:
  std::optional<Vector3d> last_position_;
};

}  // namespace

Description describe_scans(const std::filesystem::path& folder, const ScanReadOptions& options) {
  const auto source = open_scans(folder, options);
  ScansSummary sum;
  Progress progress("reading", source->size());
  Scan scan;
  while (source->next(scan)) {
    sum.add(scan);
    progress.advance();
  }
  const bool any_finite = sum.bounds.count() > 0;
  return {.json = {{"file", folder.string()},
                   {"kind", "scans"},
                   {"scans", sum.scans},
                   {"points",
                    {{"min", sum.points_min}, {"max", sum.points_max}, {"total", sum.points}}},
                   {"not_finite", sum.not_finite},
                   {"ranges", any_finite ? Json{{"min", sum.range_min}, {"max", sum.range_max}}
                                         : Json(nullptr)},
                   {"path_length", sum.path_length},
                   {"bounds", sum.bounds.json()}},
          .words = fmt::format(
              "{}: {} with {}\n"
              "  a scan      {} to {} points\n"
              "  not finite  {}\n"
              "  ranges      {}\n"
              "  bounds      {}\n"
              "  path        {:.6g} m\n",
              folder.string(), counted(sum.scans, "scan"), counted(sum.points, "point"),
              grouped(sum.points_min), grouped(sum.points_max), grouped(sum.not_finite),
              any_finite ? fmt::format("{:.6g} to {:.6g} m", sum.range_min, sum.range_max) : "none",
              sum.bounds.words(), sum.path_length)};
}

Description describe_cloud(const std::filesystem::path& file, const ScanReadOptions& options) {
  const std::vector<Vector3f> points = read_points(file, options);
  Extent bounds;
  for (const Vector3f& point : points) {
    if (point.allFinite()) bounds.add(point.cast<double>());
  }
  const double step = coordinate_step(points);
  const std::string note =
      step == 0 ? ""
                : fmt::format(
                      "  note        float32 keeps the largest in steps of {:.3g} m: "
                      "--offset keeps their digits\n",
                      step);
  return {.json = {{"file", file.string()},
                   {"kind", "cloud"},
                   {"points", points.size()},
                   {"finite", bounds.count()},
                   {"coordinate_step", step},
                   {"bounds", bounds.json()}},
          .words = fmt::format("{}: cloud of {}\n"
                               "  finite      {}\n"
                               "  bounds      {}\n{}",
                               file.string(), counted(points.size(), "point"),
                               grouped(bounds.count()), bounds.words(), note)};
}

}  // namespace rmap::command
