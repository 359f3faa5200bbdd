#include "io/bag/bag.hpp"

#include "io/bag/mcap_storage.hpp"
#include "io/bag/metadata.hpp"
#include "io/bag/sqlite_storage.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <rmap/bag_info.hpp>
#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

constexpr std::string_view kSqliteMagic("SQLite format 3\0", 16);

// Adds those that are not there yet.
template <class T>
void add_new(std::vector<T>& all, const std::vector<T>& some) {
  for (const T& value : some) {
    if (std::find(all.begin(), all.end(), value) == all.end()) all.push_back(value);
  }
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return read_bag_files(path);
  if (ending_of(path) == ".bag") {
    throw Error(ErrorKind::input,
                fmt::format("{} is a bag of ROS 1, which cannot be read: mcap convert IN.bag "
                            "OUT.mcap keeps its encoding, rosbags-convert makes one of ROS 2",
                            path.string()));
  }
  return {path};
}

}  // namespace

void check_topic_count(const std::filesystem::path& file, std::size_t topics) {
  constexpr std::size_t kMostTopics = 4096;
  if (topics < kMostTopics) return;
  throw Error(ErrorKind::limit, fmt::format("{} has more than {} topics, which are allowed",
                                            file.string(), kMostTopics));
}

std::unique_ptr<BagStorage> open_bag_storage(const std::filesystem::path& path) {
  InputFile file(path);
  const std::vector<std::byte> head = file.head(kSqliteMagic.size());
  if (as_text(head).starts_with(kMcapMagic)) return std::make_unique<McapStorage>(std::move(file));
  if (as_text(head) == kSqliteMagic) return std::make_unique<SqliteStorage>(path);
  throw Error(ErrorKind::input,
              fmt::format("{} is no bag: it begins with {}, where files of MCAP begin with {} and "
                          "those of SQLite with {}",
                          path.string(), in_quotes(as_text(head)), in_quotes(kMcapMagic),
                          in_quotes(kSqliteMagic)));
}

bool is_bag(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return std::filesystem::exists(path / kMetadataName, ignored);
  }
  const std::string ending = ending_of(path);
  return ending == ".mcap" || ending == ".db3" || ending == ".bag";
}

Bag::Bag(const std::filesystem::path& path) : path_(path) {
  for (const auto& file : files_of(path)) storages_.push_back(open_bag_storage(file));
}

std::span<const std::byte> Bag::unpacked(std::span<const std::byte> message, UnpackBudget& budget) {
  if (!is_packed_message(message)) return message;
  messages_packed_ = true;
  unpack_message(message, budget, unpacked_);
  return unpacked_;
}

void Bag::visit(FunctionRef<void(const Message&)> use) {
  for (std::size_t i = 0; i < storages_.size(); ++i) {
    storages_[i]->visit([&](const BagMessage& message) {
      use({.topic = *message.topic,
           .recorded = message.recorded,
           .data = message.data,
           .place = {.file = i, .place = message.place}});
    });
  }
}

std::span<const std::byte> Bag::read(const Place& place) {
  return storages_[place.file]->read(place.place);
}

std::vector<BagTopic> Bag::topics() const {
  std::vector<BagTopic> topics;
  for (const auto& storage : storages_) add_new(topics, storage->topics());
  return topics;
}

std::vector<std::string> Bag::compressions() const {
  std::vector<std::string> compressions;
  for (const auto& storage : storages_) add_new(compressions, storage->compressions());
  if (messages_packed_) add_new(compressions, {std::string("zstd by message")});
  return compressions;
}

std::vector<std::string> Bag::warnings() const {
  std::vector<std::string> warnings;
  for (const auto& storage : storages_) add_new(warnings, storage->warnings());
  return warnings;
}

}  // namespace rmap
