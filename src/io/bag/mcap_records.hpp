#pragma once

#include "io/byte_reader.hpp"
#include "io/input_file.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rmap {

// The records of an MCAP file (https://mcap.dev/spec), as far as we read them.

inline constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";

enum class McapOpcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  data_end = 0x0F,
};

/// The name of an opcode, for messages.
std::string opcode_name(std::uint8_t opcode);

/// Opcode and length: what each record begins with.
struct McapRecordHead {
  static constexpr std::uint64_t kSize = 9;

  std::uint8_t opcode = 0;
  std::uint64_t size = 0;  ///< of what follows

  bool is(McapOpcode wanted) const { return opcode == static_cast<std::uint8_t>(wanted); }
};

/// Of McapRecordHead::kSize bytes.
McapRecordHead record_head(const std::byte* bytes);

struct McapSchema {
  std::uint16_t id = 0;
  std::string name = {};
};
McapSchema read_schema(ByteReader reader);

struct McapChannel {
  std::uint16_t id = 0;
  std::uint16_t schema = 0;  ///< 0: none
  std::string topic = {};
  std::string encoding = {};
};
McapChannel read_channel(ByteReader reader);

struct McapMessage {
  /// Bytes before the data.
  static constexpr std::uint64_t kHeadSize = 22;

  std::uint16_t channel = 0;
  std::uint64_t log_time = 0;
  std::span<const std::byte> data;
};
/// Of at least McapMessage::kHeadSize bytes.
McapMessage message_of(std::span<const std::byte> content);

struct McapChunkHead {
  std::uint64_t unpacked_size = 0;
  std::uint32_t unpacked_crc = 0;  ///< 0: not known
  std::string compression = {};
  std::uint64_t packed_size = 0;
};
McapChunkHead read_chunk_head(ByteReader& reader);

/// What closes a file that was written to its end.
struct McapEnd {
  std::uint64_t data_end = 0;       ///< offset of the record that ends the messages
  std::uint32_t data_crc = 0;       ///< of all before it; 0: not known
  std::uint64_t summary_start = 0;  ///< what the checksum of the summary covers, first byte
  std::uint64_t summary_stop = 0;   ///< and the one behind its last
  std::uint32_t summary_crc = 0;    ///< 0: not known
};

/// Nothing for a file that does not end as it should: one that is cut off. Throws Error(input)
/// when the end is there and contradicts itself.
std::optional<McapEnd> read_end(const InputFile& file);

}  // namespace rmap
