#include "io/bag/survey.hpp"

#include "io/bag/point_cloud.hpp"

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace rmap {

namespace {

// Numbers names in the order in which they appear.
class Names {
 public:
  explicit Names(std::vector<std::string>& names) : names_(&names) {}

  std::size_t number_of(const std::string& name) {
    const auto [place, is_new] = numbers_.try_emplace(name, names_->size());
    if (is_new) names_->push_back(name);
    return place->second;
  }

 private:
  std::vector<std::string>* names_;
  std::map<std::string, std::size_t> numbers_;
};

// A topic's transforms hold for good when its name says so, in whatever namespace.
bool is_fixed(const std::string& topic) { return topic.ends_with("tf_static"); }

class Surveyor {
 public:
  explicit Surveyor(Bag& bag) : bag_(bag) {}

  BagSurvey run() {
    bag_.visit([this](const Bag::Message& message) { look_at(message); });
    for (const BagTopic& topic : bag_.topics()) entry_of(topic);
    for (auto& [topic, entry] : topics_) survey_.topics.push_back(std::move(*entry.surveyed));
    std::sort(survey_.topics.begin(), survey_.topics.end(), [](const auto& a, const auto& b) {
      return std::pair(a.topic.name, a.topic.type) < std::pair(b.topic.name, b.topic.type);
    });
    for (SurveyedTopic& topic : survey_.topics) {
      std::stable_sort(topic.clouds.begin(), topic.clouds.end(),
                       [](const auto& a, const auto& b) { return a.recorded < b.recorded; });
    }
    try {
      survey_.frames.finish();
    } catch (const Error& error) {
      if (!survey_.frames_problem) {
        survey_.frames_problem = Error(error.kind(), bag_.path().string() + ": " + error.what());
      }
    }
    return std::move(survey_);
  }

 private:
  struct Entry {
    std::unique_ptr<SurveyedTopic> surveyed;  // at a place of its own: the names refer to it
    Names frames;
    Names children;
  };
  struct ByAll {
    bool operator()(const BagTopic& a, const BagTopic& b) const {
      return std::tie(a.name, a.type, a.encoding) < std::tie(b.name, b.type, b.encoding);
    }
  };

  Entry& entry_of(const BagTopic& topic) {
    const auto found = topics_.find(topic);
    if (found != topics_.end()) return found->second;
    auto surveyed = std::make_unique<SurveyedTopic>();
    surveyed->topic = topic;
    surveyed->type = message_type_of(topic.type);
    Names frames(surveyed->frames);
    Names children(surveyed->children);
    return topics_
        .emplace(topic, Entry{std::move(surveyed), std::move(frames), std::move(children)})
        .first->second;
  }

  void look_at(const Bag::Message& message) {
    survey_.first =
        survey_.messages == 0 ? message.recorded : std::min(survey_.first, message.recorded);
    survey_.last =
        survey_.messages == 0 ? message.recorded : std::max(survey_.last, message.recorded);
    ++survey_.messages;
    if (last_topic_ != &message.topic) {
      last_topic_ = &message.topic;
      last_entry_ = &entry_of(message.topic);
    }
    SurveyedTopic& topic = *last_entry_->surveyed;
    ++topic.messages;
    if (topic.type == MessageType::other || topic.topic.encoding != "cdr") return;
    if (topic.type == MessageType::cloud) return look_at_cloud(message, *last_entry_);
    if (topic.problem) return;
    try {
      take(bag_.unpacked(message.data, budget_), *last_entry_);
    } catch (const Error& error) {
      topic.problem = message_error(bag_, topic.topic.name, topic.messages, error);
      if (topic.type == MessageType::transforms && !survey_.frames_problem) {
        survey_.frames_problem = topic.problem;
      }
    }
  }

  // What is wrong with a cloud is said when it is read, as with any other scan.
  void look_at_cloud(const Bag::Message& message, Entry& entry) {
    SurveyedTopic& topic = *entry.surveyed;
    RecordedCloud cloud{
        .place = message.place, .number = topic.messages, .recorded = message.recorded};
    try {
      const MessageHeader header = decode_cloud_header(bag_.unpacked(message.data, budget_));
      cloud.stamp = header.stamp;
      cloud.frame = entry.frames.number_of(header.frame);
      cloud.readable = true;
    } catch (const Error&) {
      cloud.readable = false;
    }
    topic.clouds.push_back(cloud);
  }

  void take(std::span<const std::byte> data, Entry& entry) {
    SurveyedTopic& topic = *entry.surveyed;
    if (topic.type == MessageType::transforms) {
      for (const StampedPose& transform : decode_transforms(data)) {
        survey_.frames.add(transform, is_fixed(topic.topic.name));
      }
      return;
    }
    const StampedPose pose = decode_pose(topic.type, data);
    entry.frames.number_of(pose.header.frame);
    if (!pose.child.empty()) entry.children.number_of(pose.child);
    topic.poses.push_back({.stamp = pose.header.stamp, .pose = pose.pose});
  }

  Bag& bag_;
  BagSurvey survey_;
  UnpackBudget budget_;
  std::map<BagTopic, Entry, ByAll> topics_;
  const BagTopic* last_topic_ = nullptr;
  Entry* last_entry_ = nullptr;
};

}  // namespace

const SurveyedTopic* BagSurvey::find(std::string_view name, bool (*wanted)(MessageType)) const {
  const SurveyedTopic* found = nullptr;
  for (const SurveyedTopic& topic : topics) {
    if (topic.topic.name != name) continue;
    if (found == nullptr || wanted(topic.type)) found = &topic;
  }
  return found;
}

std::vector<const SurveyedTopic*> BagSurvey::all(bool (*wanted)(MessageType)) const {
  std::vector<const SurveyedTopic*> found;
  for (const SurveyedTopic& topic : topics) {
    if (wanted(topic.type)) found.push_back(&topic);
  }
  return found;
}

BagSurvey survey(Bag& bag) { return Surveyor(bag).run(); }

Error message_error(const Bag& bag, std::string_view topic, std::uint64_t number,
                    const Error& error) {
  return {error.kind(), fmt::format("{}, message {} of {}: {}", bag.path().string(), number, topic,
                                    error.what())};
}

}  // namespace rmap
