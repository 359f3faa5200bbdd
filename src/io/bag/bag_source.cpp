#include "io/bag/bag_source.hpp"

#include "io/bag/bag_poses.hpp"
#include "io/bag/point_cloud.hpp"
#include "io/decimal_time.hpp"
#include "io/memory.hpp"
#include "io/option_meaning.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr double kNanosecondsPerSecond = 1e9;

void check_options(const std::filesystem::path& path, const ScanReadOptions& options) {
  refuse_place_of_lone_file(path, options, "the poses of its scans say where beams began");
  refuse_option(!options.columns.empty(), "columns (--columns)", path,
                "its clouds name their fields");
  refuse_lone_times(path, options);
  const bool trajectory = !options.trajectory.empty();
  refuse_option(trajectory && !options.bag.pose_topic.empty(), "pose_topic (--pose-topic)", path,
                "the poses come from a trajectory (--trajectory)");
  refuse_option(trajectory && !options.bag.map_frame.empty(), "map_frame (--map-frame)", path,
                "the frame of the map is that of the trajectory (--trajectory)");
  const auto& from = options.bag.from;
  const auto& to = options.bag.to;
  if ((from && std::isnan(*from)) || (to && std::isnan(*to)) || (from && to && *from > *to)) {
    throw Error(ErrorKind::usage,
                fmt::format("from (--from) is {} and to (--to) {}: from must not be the later one",
                            from.value_or(0), to.value_or(0)));
  }
}

// Seconds after the first message of the bag at which a cloud was recorded.
double seconds_after(std::int64_t first, std::int64_t recorded) {
  return static_cast<double>(static_cast<std::uint64_t>(recorded) -
                             static_cast<std::uint64_t>(first)) /
         kNanosecondsPerSecond;
}

class BagSource : public ScanSource {
 public:
  BagSource(const std::filesystem::path& path, const ScanReadOptions& options)
      : bag_(path), frame_(options.frame.value_or(Frame::sensor)), offset_(options.offset) {
    const BagSurvey found = survey(bag_);
    const SurveyedTopic& clouds = choose_clouds(bag_, found, options.bag);
    topic_ = clouds.topic.name;
    notes_.warnings = bag_.warnings();
    choose_scans(found, clouds, options);
  }

  bool next(Scan& scan) override {
    if (next_ == scans_.size()) return false;
    const PosedCloud& cloud = scans_[next_++];
    scan.map_from_sensor = cloud.pose;
    scan.frame = frame_;
    scan.origins.clear();
    scan.no_returns.clear();
    scan.sensor_range = std::numeric_limits<double>::infinity();
    scan.name = fmt::format("{}, message {} of {}", bag_.path().string(), cloud.number, topic_);
    with_memory_for(bag_.path(), [&] { read_points(cloud, scan.points); });
    if (frame_ == Frame::map && !offset_.isZero(0)) {
      for (Vector3f& point : scan.points) point = (point.cast<double>() - offset_).cast<float>();
    }
    return true;
  }

  void rewind() override { next_ = 0; }
  std::optional<std::size_t> size() const override { return scans_.size(); }
  ScanNotes notes() const override { return notes_; }

 private:
  struct PosedCloud {
    Bag::Place place;
    std::uint64_t number;  ///< of the message in its topic
    Pose pose;
  };

  void choose_scans(const BagSurvey& found, const SurveyedTopic& clouds,
                    const ScanReadOptions& options) {
    const BagPoses poses(bag_, found, clouds, options);
    const double from = options.bag.from.value_or(-std::numeric_limits<double>::infinity());
    const double to = options.bag.to.value_or(std::numeric_limits<double>::infinity());
    const RecordedCloud* without = nullptr;
    for (const RecordedCloud& cloud : clouds.clouds) {
      const double time = seconds_after(found.first, cloud.recorded);
      if (time < from || time > to) continue;
      // A cloud that cannot be read stays: its turn is where the error belongs.
      const auto pose = cloud.readable ? poses.at(cloud.stamp, cloud.frame)
                                       : std::optional<Pose>(Pose::Identity());
      if (!pose) {
        ++notes_.without_pose;
        without = &cloud;
        continue;
      }
      scans_.push_back({.place = cloud.place, .number = cloud.number, .pose = *pose});
      scans_.back().pose.translation() -= options.offset;
    }
    if (scans_.empty() && without != nullptr) {
      throw Error(ErrorKind::input,
                  fmt::format("{}: none of the {} clouds of {} has a pose: the last of them is of "
                              "{} s, and the {} does not cover it",
                              bag_.path().string(), notes_.without_pose, topic_,
                              time_text(without->stamp), poses.words()));
    }
  }

  void read_points(const PosedCloud& cloud, std::vector<Vector3f>& points) {
    const auto message = bag_.read(cloud.place);
    try {
      // The survey has seen to it that a bag as a whole does not unpack to too much.
      UnpackBudget budget;
      decode_cloud(bag_.unpacked(message, budget), points);
    } catch (const Error& error) {
      throw message_error(bag_, topic_, cloud.number, error);
    }
  }

  Bag bag_;
  Frame frame_;
  Vector3d offset_;
  std::string topic_;
  std::vector<PosedCloud> scans_;
  ScanNotes notes_;
  std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<ScanSource> open_bag_scans(const std::filesystem::path& path,
                                           const ScanReadOptions& options) {
  check_options(path, options);
  return with_memory_for(path, [&] { return std::make_unique<BagSource>(path, options); });
}

}  // namespace rmap
