#include "io/graph_file.hpp"

#include "io/bytes.hpp"
#include "io/input_file.hpp"
#include "io/memory.hpp"
#include "io/option_meaning.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

// A vector is its length, a u32, and as many doubles.
constexpr std::size_t kPointSize = 4 + 3 * 8;
constexpr std::size_t kPoseSize = kPointSize + 4 + 4 * 8;
constexpr std::size_t kEdgeSize = 4 + 4 + kPoseSize + 8;  // two scans, a pose, a weight
constexpr std::size_t kPointsPerPiece = 8192;

class GraphSource final : public ScanSource {
 public:
  GraphSource(const std::filesystem::path& file, const ScanReadOptions& options)
      : path_(file), options_(options), file_(file) {
    scans_ = number();
    if (scans_ > file_.size() / (4 + kPoseSize + 4)) {
      fail(fmt::format("it announces {} scans and has {} bytes", scans_, file_.size()));
    }
  }

  bool next(Scan& scan) override {
    if (failed_ || ended_) return false;
    if (next_ == scans_) {
      ended_ = true;
      check_end();
      return false;
    }
    // Behind an error it is not known where the next scan begins.
    failed_ = true;
    with_memory_for(path_, [&] { read(scan); });
    failed_ = false;
    ++next_;
    return true;
  }

  void rewind() override {
    file_ = InputFile(path_);
    position_ = 0;
    next_ = 0;
    failed_ = false;
    ended_ = false;
    number();
  }

  std::optional<std::size_t> size() const override { return scans_; }

 private:
  // Behind the scans stand their edges, and nothing else.
  void check_end() {
    const std::uint64_t edges = number();
    const std::uint64_t left = file_.size() - position_;
    if (left / kEdgeSize == edges && left % kEdgeSize == 0) return;
    fail(fmt::format(
        "it announces {} edges of {} bytes each behind its scans, and {} bytes are left", edges,
        kEdgeSize, left));
  }

  void read(Scan& scan) {
    const std::uint64_t count = number();
    if (count > (file_.size() - position_) / kPointSize) {
      fail(fmt::format("scan {} announces {} points of {} bytes each and {} bytes are left", next_,
                       count, kPointSize, file_.size() - position_));
    }
    if (count > kMaxPointsPerFile) {
      throw Error(ErrorKind::limit,
                  fmt::format("{}: scan {} holds {} points: {} are allowed in a scan",
                              path_.string(), next_, count, kMaxPointsPerFile));
    }
    const bool in_map = options_.frame == Frame::map;
    read_points(static_cast<std::size_t>(count), in_map ? options_.offset : Vector3d::Zero(),
                scan.points);
    scan.map_from_sensor = read_pose();
    scan.map_from_sensor.translation() -= options_.offset;
    scan.frame = in_map ? Frame::map : Frame::sensor;
    scan.origins.clear();
    scan.no_returns.clear();
    scan.sensor_range = std::numeric_limits<double>::infinity();
    scan.name = fmt::format("{}, scan {}", path_.string(), number());
  }

  void read_points(std::size_t count, const Vector3d& offset, std::vector<Vector3f>& points) {
    points.clear();
    points.reserve(count);
    piece_.resize(std::min(count, kPointsPerPiece) * kPointSize);
    while (points.size() < count) {
      const std::size_t most = std::min(count - points.size(), kPointsPerPiece);
      const auto bytes = std::span(piece_).first(most * kPointSize);
      read(bytes);
      for (std::size_t i = 0; i < most; ++i) {
        const auto point = vector<3>(bytes.subspan(i * kPointSize));
        points.emplace_back((Vector3d(point[0], point[1], point[2]) - offset).cast<float>());
      }
    }
  }

  Pose read_pose() {
    std::array<std::byte, kPoseSize> bytes;
    read(bytes);
    const auto place = vector<3>(bytes);
    const auto turn = vector<4>(std::span(bytes).subspan(kPointSize));
    try {
      return make_pose({place[0], place[1], place[2]},
                       Eigen::Quaterniond(turn[0], turn[1], turn[2], turn[3]));
    } catch (const Error& error) {
      fail(fmt::format("the pose of scan {} is none: {}", next_, error.what()));
    }
  }

  template <std::size_t size>
  std::array<double, size> vector(std::span<const std::byte> bytes) const {
    const auto length = load_little<std::uint32_t>(bytes.data());
    if (length != size) {
      fail(fmt::format("in scan {} a vector of {} numbers stands where {} must be", next_, length,
                       size));
    }
    std::array<double, size> numbers;
    for (std::size_t i = 0; i < size; ++i) {
      numbers[i] = load_little<double>(bytes.data() + 4 + 8 * i);
    }
    return numbers;
  }

  std::uint32_t number() {
    std::array<std::byte, 4> bytes;
    read(bytes);
    return load_little<std::uint32_t>(bytes.data());
  }

  void read(std::span<std::byte> bytes) {
    if (bytes.size() > file_.size() - position_) {
      fail(fmt::format("it is cut off in scan {} of {}", next_, scans_));
    }
    file_.read(bytes);
    position_ += bytes.size();
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(ErrorKind::input,
                fmt::format("{} is no sound scan graph of OctoMap: {}", path_.string(), problem));
  }

  std::filesystem::path path_;
  ScanReadOptions options_;
  InputFile file_;
  std::uint64_t position_ = 0;
  std::uint32_t scans_ = 0;
  std::uint32_t next_ = 0;
  bool failed_ = false;
  bool ended_ = false;
  std::vector<std::byte> piece_;
};

}  // namespace

std::unique_ptr<ScanSource> open_scan_graph(const std::filesystem::path& file,
                                            const ScanReadOptions& options) {
  constexpr std::string_view kWhy = "its scans have poses of their own";
  refuse_bag_options(file, options.bag);
  refuse_place_of_lone_file(file, options, kWhy);
  refuse_trajectory(file, options, kWhy);
  refuse_columns(file, file, options);
  return std::make_unique<GraphSource>(file, options);
}

}  // namespace rmap
