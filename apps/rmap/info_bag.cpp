#include "info.hpp"
#include "words.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <rmap/bag_info.hpp>

namespace rmap::command {

namespace {

constexpr std::size_t kMostFrames = 30;
constexpr double kNanosecondsPerSecond = 1e9;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

// As a shell takes it for one word.
std::string shell_word(const std::string& text) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("/._-+=:,@%").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

double seconds(const BagInfo& bag) {
  return static_cast<double>(static_cast<std::uint64_t>(bag.last) -
                             static_cast<std::uint64_t>(bag.first)) /
         kNanosecondsPerSecond;
}

// The command that builds from a topic of clouds. Only one of several has to be named.
std::string command_for(const std::filesystem::path& path, const BagInfo& bag,
                        const BagCloudsInfo& clouds) {
  const std::string topic =
      bag.clouds.size() == 1 ? "" : fmt::format(" --topic {}", shell_word(clouds.topic));
  return fmt::format("rmap build {}{} -o map.rmap --resolution 0.1", shell_word(path.string()),
                     topic);
}

bool is_buildable(const BagCloudsInfo& clouds) {
  return clouds.problem.empty() && clouds.scans > 0;
}

// Why a topic of clouds gives no map by itself.
std::string hindrance(const BagCloudsInfo& clouds) {
  if (!clouds.problem.empty()) return clouds.problem;
  return fmt::format("no cloud of {} has a pose: {} do not cover their times", clouds.topic,
                     clouds.poses);
}

Json json_of(const std::filesystem::path& path, const BagInfo& bag) {
  Json topics = Json::array();
  for (const BagTopicInfo& topic : bag.topics) {
    topics.push_back({{"name", topic.name},
                      {"type", topic.type},
                      {"encoding", topic.encoding},
                      {"messages", topic.messages},
                      {"frames", topic.frames},
                      {"child_frames", topic.child_frames},
                      {"problem", topic.problem.empty() ? Json(nullptr) : Json(topic.problem)}});
  }
  Json frames = Json::array();
  for (const BagFrameInfo& frame : bag.frames) {
    frames.push_back({{"name", frame.name},
                      {"parent", frame.parent},
                      {"moves", frame.moves},
                      {"poses", frame.poses}});
  }
  Json clouds = Json::array();
  for (const BagCloudsInfo& topic : bag.clouds) {
    const bool buildable = is_buildable(topic);
    clouds.push_back({{"topic", topic.topic},
                      {"poses", topic.poses.empty() ? Json(nullptr) : Json(topic.poses)},
                      {"scans", topic.scans},
                      {"without_pose", topic.without_pose},
                      {"command", buildable ? Json(command_for(path, bag, topic)) : Json(nullptr)},
                      {"problem", buildable ? Json(nullptr) : Json(hindrance(topic))}});
  }
  return {{"file", path.string()},
          {"kind", "bag"},
          {"format", bag.format},
          {"files", bag.files},
          {"compressions", bag.compressions},
          {"messages", bag.messages},
          {"first_ns", bag.first},
          {"last_ns", bag.last},
          {"topics", std::move(topics)},
          {"frames", std::move(frames)},
          {"frames_problem", bag.frames_problem.empty() ? Json(nullptr) : Json(bag.frames_problem)},
          {"clouds", std::move(clouds)},
          {"warnings", bag.warnings}};
}

std::string topic_lines(const BagInfo& bag) {
  std::size_t name = 0;
  std::size_t type = 0;
  for (const BagTopicInfo& topic : bag.topics) {
    name = std::max(name, topic.name.size());
    type = std::max(type, topic.type.size());
  }
  std::string lines;
  for (const BagTopicInfo& topic : bag.topics) {
    std::string rest;
    if (!topic.frames.empty()) rest = "  in " + joined(topic.frames);
    if (!topic.child_frames.empty()) rest += ", of " + joined(topic.child_frames);
    if (topic.encoding != "cdr") rest += "  encoded as " + topic.encoding;
    lines += fmt::format("  topic       {:{}}  {:{}}  {:>9}{}\n", topic.name, name, topic.type,
                         type, grouped(topic.messages), rest);
  }
  return lines;
}

std::string frame_lines(const BagInfo& bag) {
  std::string lines;
  for (std::size_t i = 0; i < bag.frames.size() && i < kMostFrames; ++i) {
    const BagFrameInfo& frame = bag.frames[i];
    lines += fmt::format(
        "  frame       {} in {}, {}\n", frame.name, frame.parent,
        frame.moves ? fmt::format("moving, {}", counted(frame.poses, "pose")) : "fixed");
  }
  if (bag.frames.size() > kMostFrames) {
    lines += fmt::format("  frame       and {} more\n", bag.frames.size() - kMostFrames);
  }
  return lines;
}

// What to type next.
std::string advice(const std::filesystem::path& path, const BagInfo& bag) {
  if (bag.clouds.empty()) {
    return "  next        nothing: there are no clouds (sensor_msgs/PointCloud2) to build from\n";
  }
  std::string lines;
  for (const BagCloudsInfo& clouds : bag.clouds) {
    if (is_buildable(clouds)) {
      lines +=
          fmt::format("  next        {}\n              {} by {}{}\n",
                      command_for(path, bag, clouds), counted(clouds.scans, "scan"), clouds.poses,
                      clouds.without_pose == 0
                          ? ""
                          : fmt::format("; {} without a pose", grouped(clouds.without_pose)));
    } else {
      lines += fmt::format("  next        {} needs more: {}\n", clouds.topic, hindrance(clouds));
    }
  }
  return lines;
}

// A bag may come from a stranger, whose names are not to write to a terminal what they like.
BagInfo fit_for_a_terminal(BagInfo bag) {
  const auto clean = [](std::string& text) { text = printable(text); };
  const auto clean_all = [&](std::vector<std::string>& texts) {
    for (std::string& text : texts) clean(text);
  };
  for (BagTopicInfo& topic : bag.topics) {
    for (std::string* text : {&topic.name, &topic.type, &topic.encoding, &topic.problem})
      clean(*text);
    clean_all(topic.frames);
    clean_all(topic.child_frames);
  }
  for (BagFrameInfo& frame : bag.frames) {
    clean(frame.name);
    clean(frame.parent);
  }
  for (BagCloudsInfo& clouds : bag.clouds) {
    for (std::string* text : {&clouds.topic, &clouds.poses, &clouds.problem}) clean(*text);
  }
  clean(bag.format);
  clean(bag.frames_problem);
  clean_all(bag.compressions);
  clean_all(bag.warnings);
  return bag;
}

std::string words_of(const std::filesystem::path& path, const BagInfo& bag) {
  std::string text = fmt::format(
      "{}: bag with {}\n"
      "  format      {}, {}{}\n"
      "  time        {:.3f} s\n",
      path.string(), counted(bag.messages, "message"), bag.format, counted(bag.files, "file"),
      bag.compressions.empty() ? "" : ", compression " + joined(bag.compressions), seconds(bag));
  text += topic_lines(bag) + frame_lines(bag);
  if (!bag.frames_problem.empty()) text += fmt::format("  problem     {}\n", bag.frames_problem);
  for (const BagTopicInfo& topic : bag.topics) {
    if (topic.problem.empty() || topic.problem == bag.frames_problem) continue;
    text += fmt::format("  problem     {}\n", topic.problem);
  }
  for (const std::string& warning : bag.warnings)
    text += fmt::format("  warning     {}\n", warning);
  return text + advice(path, bag);
}

}  // namespace

Description describe_bag(const std::filesystem::path& path) {
  const BagInfo bag = read_bag_info(path);
  return {.json = json_of(path, bag), .words = words_of(path, fit_for_a_terminal(bag))};
}

}  // namespace rmap::command
