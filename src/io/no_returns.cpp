#include "io/no_returns.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr double kTolerance = 1e-6;

class NoReturnSource final : public ScanSource {
 public:
  NoReturnSource(std::unique_ptr<ScanSource> source, double range)
      : source_(std::move(source)), range_(range) {}

  bool next(Scan& scan) override {
    if (!source_->next(scan)) return false;
    if (!scan.origins.empty()) {
      throw Error(ErrorKind::usage,
                  fmt::format("{} has an origin for each point: directions without return begin "
                              "at the sensor's one place and cannot be told there",
                              scan.name));
    }
    const Vector3d origin =
        scan.frame == Frame::map ? Vector3d(scan.map_from_sensor.translation()) : Vector3d::Zero();
    std::erase_if(scan.points, [&](const Vector3f& point) {
      const Vector3d direction = point.cast<double>() - origin;
      if (!(std::abs(direction.norm() - range_) <= kTolerance * range_)) return false;
      scan.no_returns.push_back(direction.cast<float>());
      return true;
    });
    scan.sensor_range = range_;
    return true;
  }

  void rewind() override { source_->rewind(); }
  std::optional<std::size_t> size() const override { return source_->size(); }
  ScanNotes notes() const override { return source_->notes(); }

 private:
  std::unique_ptr<ScanSource> source_;
  double range_;
};

}  // namespace

std::unique_ptr<ScanSource> with_no_returns(std::unique_ptr<ScanSource> source, double range) {
  if (!(range > 0) || !std::isfinite(range)) {
    throw Error(ErrorKind::usage,
                fmt::format("the range of points without return is {} m: it must be above zero and "
                            "finite",
                            range));
  }
  return std::make_unique<NoReturnSource>(std::move(source), range);
}

}  // namespace rmap
