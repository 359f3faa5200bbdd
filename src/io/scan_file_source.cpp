#include "io/scan_file_source.hpp"

#include "io/point_formats.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace rmap {

namespace {

class ScanFileSource final : public ScanSource {
 public:
  ScanFileSource(std::vector<ScanFile> files, const ScanReadOptions& options, ScanNotes notes)
      : files_(std::move(files)), options_(options), notes_(std::move(notes)) {
    const auto without = std::count_if(files_.begin(), files_.end(),
                                       [](const ScanFile& file) { return !file.map_from_sensor; });
    notes_.without_pose += static_cast<std::uint64_t>(without);
    std::erase_if(files_, [](const ScanFile& file) { return !file.map_from_sensor; });
  }

  bool next(Scan& scan) override {
    if (next_ == files_.size()) return false;
    const ScanFile& file = files_[next_++];
    std::swap(cloud_.points, scan.points);
    const PointReadOptions reading{
        .in_map = file.frame == Frame::map, .offset = options_.offset, .columns = options_.columns};
    const double quantum = read_cloud(file.path, reading, cloud_);
    if (quantum > quantum_) {
      quantum_ = quantum;
      coarse_file_ = file.path;
    }
    scan.map_from_sensor = *file.map_from_sensor;
    scan.frame = cloud_.origins.empty() ? file.frame : Frame::map;
    scan.origins.assign(cloud_.origins.begin(), cloud_.origins.end());
    scan.no_returns.clear();
    scan.sensor_range = std::numeric_limits<double>::infinity();
    scan.name = file.path.string();
    std::swap(cloud_.points, scan.points);
    if (file.end_points) {
      take_as_ends(scan);
    } else {
      drop_lost_origins(scan);
    }
    return true;
  }

  void rewind() override { next_ = 0; }
  std::optional<std::size_t> size() const override { return files_.size(); }

  ScanNotes notes() const override {
    ScanNotes notes = notes_;
    if (quantum_ > 0) {
      notes.remarks.push_back(fmt::format(
          "coordinates of {} are so large that float32 keeps them in steps of {:.3g} m: an offset "
          "near them keeps the digits of files that store more",
          coarse_file_.string(), quantum_));
    }
    return notes;
  }

 private:
  // Beams of no length: they end where they begin, and clear nothing.
  static void take_as_ends(Scan& scan) {
    scan.origins.clear();
    // An origin must be finite, and a point that is not is skipped whatever its origin.
    for (const Vector3f& point : scan.points) {
      scan.origins.push_back(point.allFinite() ? Vector3d(point.cast<double>()) : Vector3d::Zero());
    }
  }

  // A beam that began nowhere is no beam: its point is skipped with those that are not finite.
  static void drop_lost_origins(Scan& scan) {
    for (std::size_t i = 0; i < scan.origins.size(); ++i) {
      if (scan.origins[i].allFinite()) continue;
      scan.origins[i].setZero();
      scan.points[i].setConstant(std::numeric_limits<float>::quiet_NaN());
    }
  }

  std::vector<ScanFile> files_;
  ScanReadOptions options_;
  ScanNotes notes_;
  PointCloud cloud_;
  std::size_t next_ = 0;
  double quantum_ = 0;  // the largest so far, in metres
  std::filesystem::path coarse_file_;
};

}  // namespace

std::unique_ptr<ScanSource> open_scan_files(std::vector<ScanFile> files,
                                            const ScanReadOptions& options, ScanNotes notes) {
  return std::make_unique<ScanFileSource>(std::move(files), options, std::move(notes));
}

}  // namespace rmap
