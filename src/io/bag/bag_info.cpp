#include "io/bag/bag.hpp"
#include "io/bag/bag_poses.hpp"
#include "io/bag/survey.hpp"
#include "io/memory.hpp"

#include <string>

#include <rmap/bag_info.hpp>
#include <rmap/error.hpp>

namespace rmap {

namespace {

std::string sentence(const std::optional<Error>& problem) {
  return problem ? problem->what() : std::string();
}

BagTopicInfo info_of(const SurveyedTopic& topic) {
  return {.name = topic.topic.name,
          .type = topic.topic.type,
          .encoding = topic.topic.encoding,
          .messages = topic.messages,
          .frames = topic.frames,
          .child_frames = topic.children,
          .problem = sentence(topic.problem)};
}

std::vector<BagFrameInfo> frames_of(const FrameTree& tree) {
  std::vector<BagFrameInfo> frames;
  for (const auto& [name, link] : tree.links()) {
    frames.push_back({.name = name,
                      .parent = link.parent,
                      .moves = link.moves,
                      .poses = link.motion.poses().size()});
  }
  return frames;
}

BagCloudsInfo clouds_of(const Bag& bag, const BagSurvey& found, const SurveyedTopic& topic) {
  BagCloudsInfo info{.topic = topic.topic.name};
  try {
    const SurveyedTopic& clouds = choose_clouds(bag, found, {.topic = topic.topic.name});
    const BagPoses poses(bag, found, clouds, {});
    info.poses = poses.words();
    for (const RecordedCloud& cloud : clouds.clouds) {
      const bool posed = cloud.readable && poses.at(cloud.stamp, cloud.frame).has_value();
      ++(posed ? info.scans : info.without_pose);
    }
  } catch (const Error& error) {
    info.problem = error.what();
  }
  return info;
}

BagInfo info_of(const std::filesystem::path& path) {
  Bag bag(path);
  const BagSurvey found = survey(bag);
  BagInfo info{.format = bag.format(),
               .files = bag.file_count(),
               .compressions = bag.compressions(),
               .messages = found.messages,
               .first = found.first,
               .last = found.last,
               .frames = frames_of(found.frames),
               .frames_problem = sentence(found.frames_problem),
               .warnings = bag.warnings()};
  for (const SurveyedTopic& topic : found.topics) info.topics.push_back(info_of(topic));
  for (const auto* topic : found.all([](MessageType type) { return type == MessageType::cloud; })) {
    info.clouds.push_back(clouds_of(bag, found, *topic));
  }
  return info;
}

}  // namespace

BagInfo read_bag_info(const std::filesystem::path& path) {
  return with_memory_for(path, [&] { return info_of(path); });
}

}  // namespace rmap
