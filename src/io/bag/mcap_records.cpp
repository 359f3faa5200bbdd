#include "io/bag/mcap_records.hpp"

#include "io/text.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr std::uint64_t kFooterSize = 8 + 8 + 4;
constexpr std::uint64_t kDataEndSize = 4;

std::string read_text(ByteReader& reader, std::string_view what) {
  const auto size = reader.number<std::uint32_t>(what);
  return std::string(as_text(reader.take(size, what)));
}

// The content of a record of known kind and size at `offset`; nothing when another one is there.
template <std::uint64_t size>
std::optional<std::array<std::byte, size>> record_at(const InputFile& file, std::uint64_t offset,
                                                     McapOpcode opcode) {
  std::array<std::byte, McapRecordHead::kSize + size> bytes{};
  if (offset > file.size() || bytes.size() > file.size() - offset) return std::nullopt;
  file.read_at(offset, bytes);
  const McapRecordHead head = record_head(bytes.data());
  // A later version may make records longer, but not shorter.
  if (!head.is(opcode) || head.size != size) return std::nullopt;
  std::array<std::byte, size> content{};
  std::copy(bytes.begin() + McapRecordHead::kSize, bytes.end(), content.begin());
  return content;
}

bool ends_with_magic(const InputFile& file) {
  std::array<std::byte, kMcapMagic.size()> bytes{};
  if (file.size() < 2 * bytes.size()) return false;
  file.read_at(file.size() - bytes.size(), bytes);
  return as_text(bytes) == kMcapMagic;
}

}  // namespace

std::string opcode_name(std::uint8_t opcode) {
  constexpr std::array<std::string_view, 16> kNames = {
      "",           "header",           "footer",
      "schema",     "channel",          "message",
      "chunk",      "message index",    "chunk index",
      "attachment", "attachment index", "statistics",
      "metadata",   "metadata index",   "summary offset",
      "data end"};
  if (opcode >= 1 && opcode < kNames.size()) return std::string(kNames[opcode]);
  return fmt::format("unknown (0x{:02x})", opcode);
}

McapRecordHead record_head(const std::byte* bytes) {
  return {.opcode = load_little<std::uint8_t>(bytes),
          .size = load_little<std::uint64_t>(bytes + 1)};
}

McapSchema read_schema(ByteReader reader) {
  McapSchema schema;
  schema.id = reader.number<std::uint16_t>("a schema");
  schema.name = read_text(reader, "the name of a schema");
  return schema;
}

McapChannel read_channel(ByteReader reader) {
  McapChannel channel;
  channel.id = reader.number<std::uint16_t>("a channel");
  channel.schema = reader.number<std::uint16_t>("a channel");
  channel.topic = read_text(reader, "the topic of a channel");
  channel.encoding = read_text(reader, "the encoding of a channel");
  return channel;
}

McapMessage message_of(std::span<const std::byte> content) {
  assert(content.size() >= McapMessage::kHeadSize);
  // A number in a sequence lies behind the channel, and the time of publishing before the data.
  return {.channel = load_little<std::uint16_t>(content.data()),
          .log_time = load_little<std::uint64_t>(content.data() + 6),
          .data = content.subspan(McapMessage::kHeadSize)};
}

McapChunkHead read_chunk_head(ByteReader& reader) {
  McapChunkHead head;
  reader.number<std::uint64_t>("a chunk");  // times of its messages
  reader.number<std::uint64_t>("a chunk");
  head.unpacked_size = reader.number<std::uint64_t>("a chunk");
  head.unpacked_crc = reader.number<std::uint32_t>("a chunk");
  head.compression = read_text(reader, "the compression of a chunk");
  head.packed_size = reader.number<std::uint64_t>("a chunk");
  return head;
}

std::optional<McapEnd> read_end(const InputFile& file) {
  if (!ends_with_magic(file)) return std::nullopt;
  const auto broken = [&](std::string_view what, std::uint64_t offset) {
    return Error(ErrorKind::input,
                 fmt::format("{} is damaged: it is closed by the magic at its end, and there is no "
                             "{} at byte {}",
                             file.path().string(), what, offset));
  };
  constexpr std::uint64_t kFooter = McapRecordHead::kSize + kFooterSize;
  constexpr std::uint64_t kDataEnd = McapRecordHead::kSize + kDataEndSize;
  const std::uint64_t magic = file.size() - kMcapMagic.size();
  if (magic < kFooter) throw broken("footer", 0);
  const std::uint64_t footer = magic - kFooter;
  const auto footer_bytes = record_at<kFooterSize>(file, footer, McapOpcode::footer);
  if (!footer_bytes) throw broken("footer", footer);
  ByteReader reader(file.path(), *footer_bytes, footer + McapRecordHead::kSize);
  McapEnd end;
  end.summary_start = reader.number<std::uint64_t>("the footer");
  reader.number<std::uint64_t>("the footer");  // where the offsets of the summary start
  end.summary_stop = reader.offset();
  end.summary_crc = reader.number<std::uint32_t>("the footer");
  if (end.summary_start == 0) end.summary_start = footer;

  if (end.summary_start < kDataEnd || end.summary_start > footer) {
    throw broken("summary", end.summary_start);
  }
  end.data_end = end.summary_start - kDataEnd;
  const auto data_end = record_at<kDataEndSize>(file, end.data_end, McapOpcode::data_end);
  if (!data_end) throw broken("end of the messages", end.data_end);
  end.data_crc = load_little<std::uint32_t>(data_end->data());
  return end;
}

}  // namespace rmap
