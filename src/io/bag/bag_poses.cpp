#include "io/bag/bag_poses.hpp"

#include "io/pose_math.hpp"
#include "io/text.hpp"

#include <string_view>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr std::string_view kPoseTypes =
    "nav_msgs/Odometry, geometry_msgs/PoseStamped, geometry_msgs/PoseWithCovarianceStamped";
constexpr std::size_t kMostListed = 20;

bool is_cloud(MessageType type) { return type == MessageType::cloud; }

Error problem(const Bag& bag, std::string_view text) {
  return {ErrorKind::input, fmt::format("{}: {}", bag.path().string(), text)};
}

// "/a (type), /b (type)".
std::string list_of(const std::vector<const SurveyedTopic*>& topics) {
  std::string list;
  for (std::size_t i = 0; i < topics.size() && i < kMostListed; ++i) {
    list +=
        fmt::format("{}{} ({})", i == 0 ? "" : ", ", topics[i]->topic.name, topics[i]->topic.type);
  }
  if (topics.size() > kMostListed) list += fmt::format(" and {} more", topics.size() - kMostListed);
  return topics.empty() ? "none" : list;
}

std::string all_topics(const BagSurvey& survey) {
  return list_of(survey.all([](MessageType) { return true; }));
}

// What a cut-off file has lost may be what is asked for.
std::string cut_note(const Bag& bag) {
  std::string note;
  for (const std::string& warning : bag.warnings()) note += " (" + warning + ")";
  return note;
}

const SurveyedTopic& require_encoding(const Bag& bag, const SurveyedTopic& topic) {
  if (topic.topic.encoding == "cdr") return topic;
  throw problem(bag, fmt::format("the messages of {} are encoded as {}, where cdr, that of ROS 2, "
                                 "is allowed{}",
                                 topic.topic.name, in_quotes(topic.topic.encoding),
                                 topic.topic.encoding == "ros1"
                                     ? ": rosbags-convert makes a bag of ROS 2 of one of ROS 1"
                                     : ""));
}

std::string only_frame(const Bag& bag, const SurveyedTopic& topic,
                       const std::vector<std::string>& frames, std::string_view what) {
  if (frames.size() > 1) {
    throw problem(bag, fmt::format("the {} of {} are {} and {}, where one is allowed", what,
                                   topic.topic.name, in_quotes(frames[0]), in_quotes(frames[1])));
  }
  return frames.empty() ? std::string() : frames.front();
}

void require_frames_sound(const BagSurvey& survey) {
  if (survey.frames_problem) throw Error(*survey.frames_problem);
}

}  // namespace

struct BagPoses::Request {
  const Bag& bag;
  const BagSurvey& survey;
  const SurveyedTopic& clouds;
  const ScanReadOptions& options;
};

const SurveyedTopic& choose_clouds(const Bag& bag, const BagSurvey& survey,
                                   const BagReadOptions& options) {
  if (!options.topic.empty()) {
    const SurveyedTopic* topic = survey.find(options.topic, is_cloud);
    if (topic == nullptr) {
      throw problem(bag, fmt::format("there is no topic {} in it: its topics are {}{}",
                                     in_quotes(options.topic), all_topics(survey), cut_note(bag)));
    }
    if (topic->type != MessageType::cloud) {
      throw problem(bag, fmt::format("the topic {} is of type {}, where sensor_msgs/PointCloud2 is "
                                     "allowed",
                                     topic->topic.name, in_quotes(topic->topic.type)));
    }
    return require_encoding(bag, *topic);
  }
  const auto topics = survey.all(is_cloud);
  if (topics.empty()) {
    throw problem(bag, fmt::format("there are no clouds (sensor_msgs/PointCloud2) in it: its "
                                   "topics are {}{}",
                                   all_topics(survey), cut_note(bag)));
  }
  if (topics.size() > 1) {
    throw problem(bag, fmt::format("there are several topics of clouds in it, {}: choose one "
                                   "(--topic)",
                                   list_of(topics)));
  }
  return require_encoding(bag, *topics.front());
}

BagPoses::BagPoses(const Bag& bag, const BagSurvey& survey, const SurveyedTopic& clouds,
                   const ScanReadOptions& options)
    : chains_(clouds.frames.size()) {
  const Request request{bag, survey, clouds, options};
  if (!options.trajectory.empty()) {
    trajectory_ = read_trajectory(options.trajectory, options.times, options.quaternion);
    words_ = "file " + options.trajectory.string();
    return;
  }
  if (!options.bag.pose_topic.empty()) {
    const SurveyedTopic* topic = survey.find(options.bag.pose_topic, is_pose);
    if (topic == nullptr || !is_pose(topic->type)) {
      throw problem(bag,
                    fmt::format("there is no topic {} of poses ({}) in it: its topics are {}",
                                in_quotes(options.bag.pose_topic), kPoseTypes, all_topics(survey)));
    }
    use_topic(request, *topic);
    return;
  }
  // Transforms tell of the clouds' frame, which then is the map's and not the sensor's.
  const bool in_map = options.frame == Frame::map;
  if (!in_map && try_transforms(request)) return;
  const auto topics = survey.all(is_pose);
  if (topics.size() == 1) {
    use_topic(request, *topics.front());
    return;
  }
  if (clouds.frames.empty()) {
    throw problem(bag, fmt::format("none of the {} clouds of {} can be read{}",
                                   clouds.clouds.size(), clouds.topic.name, cut_note(bag)));
  }
  const std::string& frame = clouds.frames.front();
  throw problem(
      bag,
      topics.empty()
          ? fmt::format("nothing in it says where the clouds of {} were seen from: no "
                        "transforms that move lead to their frame {}, and there is no topic of "
                        "poses ({}); poses in a file (--trajectory) are needed",
                        clouds.topic.name, in_quotes(frame), kPoseTypes)
          : fmt::format("no transforms that move lead to the frame {} of the clouds of {}, and "
                        "there are several topics of poses, {}: choose one (--pose-topic)",
                        in_quotes(frame), clouds.topic.name, list_of(topics)));
}

// Whether transforms are the poses: they are asked for, or lead to the clouds over a moving link.
bool BagPoses::try_transforms(const Request& request) {
  const BagSurvey& survey = request.survey;
  require_frames_sound(survey);
  const std::string& wanted = request.options.bag.map_frame;
  const auto& frames = request.clouds.frames;
  const std::string map_frame =
      !wanted.empty() || frames.empty() ? wanted : survey.frames.root_of(frames.front());
  if (!wanted.empty() && !survey.frames.knows(wanted)) {
    if (!survey.all(is_pose).empty() && survey.frames.links().empty()) return false;
    throw problem(
        request.bag,
        fmt::format("no transform in it names the frame {} of the map (--map-frame); the "
                    "clouds of {} hang in {}",
                    in_quotes(wanted), request.clouds.topic.name,
                    frames.empty() ? "none" : in_quotes(survey.frames.root_of(frames[0]))));
  }
  bool connected = !frames.empty();
  bool moves = false;
  for (const std::string& frame : frames) {
    if (survey.frames.root_of(frame) != survey.frames.root_of(map_frame)) {
      connected = false;
      continue;
    }
    moves = moves || FrameChain(survey.frames, map_frame, frame).moves();
  }
  if (wanted.empty() && (!moves || !connected)) return false;
  // With a frame that was asked for, what does not fit is an error of its own.
  if (connected && !moves) {
    throw problem(request.bag,
                  fmt::format("no transform between the frame {} of the map (--map-frame) and the "
                              "clouds of {} moves: it is on the robot itself; they hang in {}",
                              in_quotes(wanted), request.clouds.topic.name,
                              in_quotes(survey.frames.root_of(frames.front()))));
  }
  use_transforms(request, map_frame);
  return true;
}

void BagPoses::use_transforms(const Request& request, const std::string& map_frame) {
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    try {
      chains_[i].emplace(request.survey.frames, map_frame, request.clouds.frames[i]);
    } catch (const Error& error) {
      throw problem(request.bag, error.what());
    }
  }
  words_ = "transforms from " + map_frame;
}

void BagPoses::use_topic(const Request& request, const SurveyedTopic& topic) {
  require_encoding(request.bag, topic);
  if (topic.problem) throw Error(*topic.problem);
  const std::string frame = only_frame(request.bag, topic, topic.frames, "frames");
  const std::string child = only_frame(request.bag, topic, topic.children, "child frames");
  const std::string& wanted = request.options.bag.map_frame;
  if (!wanted.empty() && wanted != frame) {
    throw problem(request.bag, fmt::format("the poses of {} are in the frame {}, and the map must "
                                           "be in {} (--map-frame)",
                                           topic.topic.name, in_quotes(frame), in_quotes(wanted)));
  }
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    const std::string& cloud = request.clouds.frames[i];
    // Without a child, poses are the sensor's; clouds in the map's frame do not name theirs.
    if (child.empty() || child == cloud || request.options.frame == Frame::map) continue;
    require_frames_sound(request.survey);
    const FrameTree& frames = request.survey.frames;
    if (frames.root_of(child) != frames.root_of(cloud)) {
      throw problem(request.bag,
                    fmt::format("the poses of {} are of the frame {}, and no transforms lead from "
                                "it to the frame {} of the clouds of {}: a bag with /tf_static, or "
                                "poses of the sensor in a file (--trajectory), are needed; clouds "
                                "that are in the map already can be taken so (--frame world)",
                                topic.topic.name, in_quotes(child), in_quotes(cloud),
                                request.clouds.topic.name));
    }
    chains_[i].emplace(frames, child, cloud);
  }
  trajectory_ = Trajectory(topic.poses);
  words_ = "topic " + topic.topic.name;
}

std::optional<Pose> BagPoses::at(std::int64_t stamp, std::size_t frame) const {
  const auto& chain = chains_[frame];
  if (!trajectory_) return chain->at(stamp);
  const auto pose = trajectory_->at(stamp);
  if (!pose || !chain) return pose;
  const auto rest = chain->at(stamp);
  return rest ? std::optional(composed(*pose, *rest)) : std::nullopt;
}

}  // namespace rmap
