#pragma once

#include "io/bag/survey.hpp"
#include "io/trajectory.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rmap/scan_read_options.hpp>

namespace rmap {

/// Where the sensor of a topic of clouds was in the course of time. Refers to the survey that it
/// was made of.
class BagPoses {
 public:
  /// Chooses by the options: the trajectory, the topic of poses, the transforms where they
  /// lead to the clouds over a link that moves, the only topic of poses. Throws Error(input)
  /// when none of these is there or fits, with the option that is missing.
  BagPoses(const Bag& bag, const BagSurvey& survey, const SurveyedTopic& clouds,
           const ScanReadOptions& options);

  /// map_from_sensor of a cloud whose header names that frame of the topic. Nothing when it is
  /// not known at that time.
  std::optional<Pose> at(std::int64_t stamp, std::size_t frame) const;

  /// For people: "transforms from odom", "topic /odom", "file poses.txt".
  const std::string& words() const { return words_; }

 private:
  struct Request;
  bool try_transforms(const Request& request);
  void use_transforms(const Request& request, const std::string& map_frame);
  void use_topic(const Request& request, const SurveyedTopic& topic);

  std::string words_;
  /// Where there is none, the chains alone lead to the map's frame.
  std::optional<Trajectory> trajectory_;
  /// For each frame of the clouds, from the frame that the trajectory is of; nothing where that
  /// is the same.
  std::vector<std::optional<FrameChain>> chains_;
};

/// The topic of clouds that the options choose, or the only one. Throws Error(input) with those
/// that there are.
const SurveyedTopic& choose_clouds(const Bag& bag, const BagSurvey& survey,
                                   const BagReadOptions& options);

}  // namespace rmap
