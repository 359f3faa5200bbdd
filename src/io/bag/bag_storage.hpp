#pragma once

#include "io/bag/message_type.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <rmap/function_ref.hpp>

namespace rmap {

/// What a bag says of a topic.
struct BagTopic {
  std::string name = {};
  std::string type = {};      ///< as in the bag: sensor_msgs/msg/PointCloud2
  std::string encoding = {};  ///< "cdr" for ROS 2

  bool operator==(const BagTopic&) const = default;
};

/// Where a message lies in its file; what the numbers mean is the storage's own affair.
struct BagPlace {
  std::uint64_t unit = 0;
  std::uint64_t offset = 0;
  std::uint64_t size = 0;
};

struct BagMessage {
  const BagTopic* topic = nullptr;  ///< lives as long as the storage
  std::int64_t recorded = 0;        ///< nanoseconds
  std::span<const std::byte> data;  ///< lives as long as the visit of it
  BagPlace place = {};
};

/// One file of recorded messages.
class BagStorage {
 public:
  BagStorage() = default;
  BagStorage(const BagStorage&) = delete;
  BagStorage& operator=(const BagStorage&) = delete;
  virtual ~BagStorage() = default;

  /// Calls `use` with each message, in the order of the file, and checks all that can be
  /// checked. Throws Error(input) where the file is damaged, Error(limit) where it asks for too
  /// much, and what `use` throws. One call, before all others.
  virtual void visit(FunctionRef<void(const BagMessage&)> use) = 0;

  /// The bytes of a message that was visited, until the next call.
  virtual std::span<const std::byte> read(const BagPlace& place) = 0;

  /// Topics that the file announces, those without messages too.
  virtual std::vector<BagTopic> topics() const = 0;
  /// How its messages are kept, for people: "mcap" or "sqlite3".
  virtual std::string format() const = 0;
  /// The compressions met, "none" too; empty where the format knows none.
  virtual std::vector<std::string> compressions() const { return {}; }
  /// What people should know of the file, a sentence each: that it is cut off, say.
  virtual std::vector<std::string> warnings() const { return {}; }
};

/// Throws Error(limit) when a file has more topics than any recording, which cost more than their
/// bytes.
void check_topic_count(const std::filesystem::path& file, std::size_t topics);

/// Opens a file by its content. Throws Error(input) when it is neither MCAP nor SQLite.
std::unique_ptr<BagStorage> open_bag_storage(const std::filesystem::path& file);

}  // namespace rmap
