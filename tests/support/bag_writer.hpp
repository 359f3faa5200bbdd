#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rmap::test {

struct TestTopic {
  std::string name;
  std::string type;
  std::string encoding = "cdr";
};

struct TestMessage {
  std::size_t topic;  ///< of TestBag::topics
  std::int64_t recorded;
  std::string data;
};

/// What is in a bag, however it is written.
struct TestBag {
  std::vector<TestTopic> topics = {};
  std::vector<TestMessage> messages = {};

  /// Adds a message, and its topic where that is new.
  void add(std::string_view topic, std::string_view type, std::int64_t recorded, std::string data);
};

enum class TestCompression { none, lz4, zstd };

struct McapStyle {
  std::size_t messages_per_chunk = 4;  ///< 0: no chunks
  TestCompression compression = TestCompression::none;
  bool summary = true;    ///< schemas, channels, chunk indexes and counts behind the messages
  bool checksums = true;  ///< of chunks, messages and the summary
  std::string schema_encoding = "ros2msg";
};

/// The bytes of an MCAP file.
std::string mcap_bytes(const TestBag& bag, const McapStyle& style = {});

// Records one by one, for files that are wrong.

std::string mcap_record(std::uint8_t opcode, std::string_view content);
/// A chunk's record around what is packed already.
std::string mcap_chunk(std::string_view compression, std::string_view packed,
                       std::uint64_t unpacked_size, std::uint32_t crc);
std::string pack(TestCompression compression, std::string_view content);

/// The CRC-32 of the bytes, bit by bit.
std::uint32_t plain_crc32(std::string_view bytes);

/// A `.db3` file of rosbag2 with pages of so many bytes. `file` must not exist.
void write_db3(const TestBag& bag, const std::filesystem::path& file, int page_size = 4096);

/// A folder of rosbag2 with its metadata and the messages dealt out to `files` files one after
/// another, as MCAP or as `.db3`.
void write_rosbag2(const TestBag& bag, const std::filesystem::path& folder, bool mcap,
                   std::size_t files = 1);

}  // namespace rmap::test
