#pragma once

#include "io/bag/bag_storage.hpp"
#include "io/bag/unpack.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rmap {

/// The files of a bag as one.
class Bag {
 public:
  /// Throws Error(input) when a file is none of a bag, Error(io) when it cannot be read.
  explicit Bag(const std::filesystem::path& path);

  struct Place {
    std::size_t file = 0;
    BagPlace place = {};
  };
  struct Message {
    const BagTopic& topic;
    std::int64_t recorded;  ///< nanoseconds
    std::span<const std::byte> data;
    Place place;
  };

  const std::filesystem::path& path() const { return path_; }
  std::size_t file_count() const { return storages_.size(); }

  /// The message itself where rosbag2 compressed it alone, else `message`; until the next call.
  /// Throws Error without the message's name.
  std::span<const std::byte> unpacked(std::span<const std::byte> message, UnpackBudget& budget);

  // As those of BagStorage.

  void visit(FunctionRef<void(const Message&)> use);
  std::span<const std::byte> read(const Place& place);
  std::vector<BagTopic> topics() const;
  std::string format() const { return storages_.front()->format(); }
  std::vector<std::string> compressions() const;
  std::vector<std::string> warnings() const;

 private:
  std::filesystem::path path_;
  std::vector<std::unique_ptr<BagStorage>> storages_;
  std::vector<std::byte> unpacked_;
  bool messages_packed_ = false;
};

}  // namespace rmap
