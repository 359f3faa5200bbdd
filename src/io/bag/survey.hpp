#pragma once

#include "io/bag/bag.hpp"
#include "io/bag/frame_tree.hpp"
#include "io/bag/message_type.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rmap/error.hpp>

namespace rmap {

/// A cloud of a bag before its points are read.
struct RecordedCloud {
  Bag::Place place = {};
  std::uint64_t number = 0;  ///< of the message among those of its topic, from 1
  std::int64_t recorded = 0;
  std::int64_t stamp = 0;
  std::size_t frame = 0;  ///< of SurveyedTopic::frames
  bool readable = false;  ///< whether its header is: stamp and frame hold then
};

/// What one pass over a bag finds out of a topic.
struct SurveyedTopic {
  BagTopic topic = {};
  MessageType type = MessageType::other;
  std::uint64_t messages = 0;
  std::vector<std::string> frames = {};    ///< of the headers, in order of appearance
  std::vector<std::string> children = {};  ///< child frames of odometry
  std::vector<RecordedCloud> clouds = {};
  std::vector<TimedPose> poses = {};
  /// What is wrong with the first message that cannot be used, of poses and transforms; those
  /// behind it were not looked at.
  std::optional<Error> problem = {};
};

/// All of a bag but the points: what fits into memory however long the bag is.
struct BagSurvey {
  std::vector<SurveyedTopic> topics = {};  ///< sorted by name
  FrameTree frames = {};
  /// Of the frames as a whole, as far as it is not one topic's.
  std::optional<Error> frames_problem = {};
  std::uint64_t messages = 0;
  std::int64_t first = 0;  ///< nanoseconds, times of recording; without messages 0
  std::int64_t last = 0;

  /// The topic of that name, of a type that is `wanted` where there are several; null for none.
  const SurveyedTopic* find(std::string_view name, bool (*wanted)(MessageType)) const;
  /// All topics of types that are `wanted`.
  std::vector<const SurveyedTopic*> all(bool (*wanted)(MessageType)) const;
};

/// The one pass. Throws Error where the files are damaged; what is wrong with single messages is
/// kept with their topic, as nobody may want them.
BagSurvey survey(Bag& bag);

/// "FILE, message 3 of /topic: <problem>", of the same kind.
Error message_error(const Bag& bag, std::string_view topic, std::uint64_t number,
                    const Error& error);

}  // namespace rmap
