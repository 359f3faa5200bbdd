#include "io/bag/mcap_storage.hpp"

#include "io/bag/crc32.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr std::size_t kBlock = std::size_t{1} << 20;
// What stands before the compressed bytes of a chunk but for the name of the compression, which
// is short where it is one that we know.
constexpr std::uint64_t kMostChunkHead = 8 + 8 + 8 + 4 + 4 + 16 + 8;

std::string shown(const std::string& compression) {
  return compression.empty() ? "none" : compression;
}

}  // namespace

McapStorage::McapStorage(InputFile file) : file_(std::move(file)) {}

Error McapStorage::damaged(std::uint64_t offset, std::string_view problem) const {
  return {ErrorKind::input,
          fmt::format("{} is damaged at byte {}: {}", file_.path().string(), offset, problem)};
}

void McapStorage::check_sum(std::string_view what, std::uint64_t begin, std::uint64_t end,
                            std::uint32_t expected) const {
  if (expected == 0) return;  // the writer did not know it
  Crc32 crc;
  std::vector<std::byte> block;
  for (std::uint64_t offset = begin; offset < end; offset += block.size()) {
    block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, end - offset)));
    file_.read_at(offset, block);
    crc.add(block);
  }
  if (crc.value() == expected) return;
  throw Error(
      ErrorKind::input,
      fmt::format("{} is damaged between bytes {} and {}: the checksum of {} is {:08x}, and "
                  "must be {:08x}",
                  file_.path().string(), begin, end, what, crc.value(), expected));
}

void McapStorage::visit(Use use) {
  const std::uint64_t begin = kMcapMagic.size();
  const auto first = record_at(begin, file_.size());
  if (!first || !first->head.is(McapOpcode::header)) {
    throw damaged(begin, "an MCAP file begins with a header, and there is none");
  }
  const auto end = read_end(file_);
  closed_ = end.has_value();
  if (end) {
    check_sum("the summary", end->summary_start, end->summary_stop, end->summary_crc);
    check_sum("the messages", 0, end->data_end, end->data_crc);
  }
  const std::uint64_t stop = end ? end->data_end : file_.size();
  const std::uint64_t kept = visit_records(stop, use);
  if (!closed_) warn_of_cut(kept);
}

void McapStorage::warn_of_cut(std::uint64_t kept) {
  warnings_.push_back(
      data_ended_
          ? fmt::format("{} is cut off behind its messages: all {} of them were recovered, and the "
                        "{} bytes after them lack their end",
                        file_.path().string(), messages_, file_.size() - kept)
          : fmt::format("{} is cut off: {} messages were recovered, and {} bytes from byte {} on "
                        "hold nothing complete and are lost",
                        file_.path().string(), messages_, file_.size() - kept, kept));
}

// Nothing where a file that is cut off holds no record's head any more.
std::optional<McapStorage::Record> McapStorage::record_at(std::uint64_t offset,
                                                          std::uint64_t stop) const {
  std::array<std::byte, McapRecordHead::kSize> bytes{};
  if (stop - offset < bytes.size()) {
    if (closed_) throw damaged(offset, fmt::format("{} bytes are no record", stop - offset));
    return std::nullopt;
  }
  file_.read_at(offset, bytes);
  Record record{.head = record_head(bytes.data()), .offset = offset + bytes.size()};
  record.present = std::min(record.head.size, stop - record.offset);
  if (closed_ && (record.head.opcode == 0 || !record.complete())) {
    throw damaged(offset, fmt::format("a record ({}) takes {} bytes, and {} are left",
                                      opcode_name(record.head.opcode), record.head.size,
                                      stop - record.offset));
  }
  // What a file system fills up a file with whose last blocks it never wrote.
  if (record.head.opcode == 0) return std::nullopt;
  return record;
}

// Returns the offset behind the last thing that was complete.
std::uint64_t McapStorage::visit_records(std::uint64_t stop, Use use) {
  std::uint64_t offset = kMcapMagic.size();
  while (offset < stop) {
    const auto record = record_at(offset, stop);
    if (!record) break;
    if (record->head.is(McapOpcode::data_end) && record->complete()) {
      if (closed_) throw damaged(offset, "the messages end before the place that the footer names");
      data_ended_ = true;
      return record->end();
    }
    if (!record->complete() && !record->head.is(McapOpcode::chunk)) break;
    const std::uint64_t end = visit_record(*record, use);
    if (!record->complete()) return std::max(offset, end);
    offset = record->end();
  }
  return offset;
}

// Returns the offset behind the last thing that was complete, 0 for none.
std::uint64_t McapStorage::visit_record(const Record& record, Use use) {
  if (record.head.is(McapOpcode::schema)) {
    learn(read_schema(ByteReader(file_.path(), load(record), record.offset)));
  } else if (record.head.is(McapOpcode::channel)) {
    learn(read_channel(ByteReader(file_.path(), load(record), record.offset)), record.offset);
  } else if (record.head.is(McapOpcode::message)) {
    const std::uint64_t data = record.offset + McapMessage::kHeadSize;
    give(load(record), record.offset,
         {.unit = 0, .offset = data, .size = record.head.size - McapMessage::kHeadSize}, use);
  } else if (record.head.is(McapOpcode::chunk)) {
    return visit_chunk(record, use);
  }
  return record.end();  // attachments, metadata, indexes, and what later versions add
}

std::span<const std::byte> McapStorage::load(const Record& record) {
  if (record.present > kMostUnpacked) {
    throw Error(ErrorKind::limit,
                fmt::format("{}, byte {}: a record ({}) takes {} bytes, and {} are allowed",
                            file_.path().string(), record.offset, opcode_name(record.head.opcode),
                            record.present, kMostUnpacked));
  }
  loaded_ = 0;
  content_.resize(static_cast<std::size_t>(record.present));
  file_.read_at(record.offset, content_);
  return content_;
}

// Nothing where a file is cut off within the head.
std::optional<McapStorage::Chunk> McapStorage::chunk_at(const Record& record) const {
  std::array<std::byte, kMostChunkHead> bytes{};
  const auto head_bytes = std::span(bytes).first(
      static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), record.present)));
  file_.read_at(record.offset, head_bytes);
  ByteReader reader(file_.path(), head_bytes, record.offset);
  Chunk chunk;
  try {
    chunk.head = read_chunk_head(reader);
  } catch (const Error&) {
    if (record.complete()) throw damaged(record.offset, "a chunk has no sound head");
    return std::nullopt;
  }
  chunk.offset = reader.offset();
  chunk.present = std::min(chunk.head.packed_size, record.end() - chunk.offset);
  if (record.complete() && chunk.head.packed_size != chunk.present) {
    throw damaged(record.offset, fmt::format("a chunk of {} bytes says that {} are packed in it",
                                             record.head.size, chunk.head.packed_size));
  }
  const std::string& compression = chunk.head.compression;
  if (!compression.empty() && compression != "lz4" && compression != "zstd") {
    throw damaged(record.offset, fmt::format("a chunk is compressed by {}, where lz4, zstd and "
                                             "none are allowed",
                                             in_quotes(compression)));
  }
  return chunk;
}

// Returns as visit_record.
std::uint64_t McapStorage::visit_chunk(const Record& record, Use use) {
  const auto chunk = chunk_at(record);
  if (!chunk) return 0;
  const bool packed = !chunk->head.compression.empty();
  if (packed && !record.complete()) return 0;
  const std::string name = shown(chunk->head.compression);
  if (std::find(compressions_.begin(), compressions_.end(), name) == compressions_.end()) {
    compressions_.push_back(name);
  }
  try {
    if (packed) budget_.take(chunk->head.packed_size, chunk->head.unpacked_size);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}, the chunk at byte {}: {}", file_.path().string(),
                                          record.offset, error.what()));
  }
  if (packed) chunks_.emplace(chunk->offset, *chunk);
  unpack(*chunk);
  return chunk->offset + visit_content(*chunk, use);
}

// Brings the content of a chunk, or what is there of it, into content_.
void McapStorage::unpack(const Chunk& chunk) {
  const McapChunkHead& head = chunk.head;
  if (head.unpacked_size > kMostUnpacked || chunk.present > kMostUnpacked) {
    throw Error(ErrorKind::limit,
                fmt::format("{}, the chunk at byte {}: it holds {} bytes, and {} "
                            "are allowed",
                            file_.path().string(), chunk.offset,
                            std::max(head.unpacked_size, chunk.present), kMostUnpacked));
  }
  loaded_ = 0;
  const bool packed = !head.compression.empty();
  const bool complete = chunk.present == head.packed_size;
  if (!packed && complete && head.packed_size != head.unpacked_size) {
    throw damaged(chunk.offset, fmt::format("a chunk that is not compressed says that its {} bytes "
                                            "unpack to {}",
                                            head.packed_size, head.unpacked_size));
  }
  std::vector<std::byte>& stored = packed ? packed_ : content_;
  stored.resize(static_cast<std::size_t>(chunk.present));
  file_.read_at(chunk.offset, stored);
  if (packed) {
    content_.resize(static_cast<std::size_t>(head.unpacked_size));
    const bool sound =
        head.compression == "zstd" ? unpack_zstd(packed_, content_) : unpack_lz4(packed_, content_);
    if (!sound) {
      throw damaged(chunk.offset, fmt::format("a chunk compressed by {} does not unpack to the {} "
                                              "bytes that it announces",
                                              head.compression, head.unpacked_size));
    }
  }
  if (complete && head.unpacked_crc != 0 && crc32(content_) != head.unpacked_crc) {
    throw damaged(chunk.offset, fmt::format("the checksum of a chunk is {:08x}, and must be {:08x}",
                                            crc32(content_), head.unpacked_crc));
  }
}

// Returns the number of bytes of the content that are complete records.
std::size_t McapStorage::visit_content(const Chunk& chunk, Use use) {
  const bool packed = !chunk.head.compression.empty();
  const bool complete = chunk.present == chunk.head.packed_size;
  const std::span<const std::byte> content = content_;
  std::size_t position = 0;
  while (position < content.size()) {
    const std::size_t left = content.size() - position;
    McapRecordHead head;
    if (left >= McapRecordHead::kSize) head = record_head(content.data() + position);
    if (left < McapRecordHead::kSize || head.size > left - McapRecordHead::kSize) {
      if (!complete) break;
      throw damaged(chunk.offset,
                    fmt::format("the record at byte {} of a chunk ends behind it", position));
    }
    const std::size_t begin = position + McapRecordHead::kSize;
    const auto record = content.subspan(begin, static_cast<std::size_t>(head.size));
    if (head.is(McapOpcode::schema)) {
      learn(read_schema(ByteReader(file_.path(), record, chunk.offset + begin)));
    } else if (head.is(McapOpcode::channel)) {
      learn(read_channel(ByteReader(file_.path(), record, chunk.offset + begin)), chunk.offset);
    } else if (head.is(McapOpcode::message)) {
      const std::uint64_t data = begin + McapMessage::kHeadSize;
      give(record, chunk.offset,
           {.unit = packed ? chunk.offset : 0,
            .offset = packed ? data : chunk.offset + data,
            .size = record.size() - McapMessage::kHeadSize},
           use);
    }
    position = begin + record.size();
  }
  return position;
}

void McapStorage::learn(McapSchema schema) {
  schemas_.insert_or_assign(schema.id, std::move(schema.name));
}

void McapStorage::learn(const McapChannel& channel, std::uint64_t offset) {
  BagTopic topic{.name = channel.topic, .type = {}, .encoding = channel.encoding};
  if (channel.schema != 0) {
    const auto schema = schemas_.find(channel.schema);
    if (schema == schemas_.end()) {
      throw damaged(offset, fmt::format("the channel of {} has schema {}, which no record before "
                                        "it describes",
                                        in_quotes(channel.topic), channel.schema));
    }
    topic.type = schema->second;
  }
  check_topic_count(file_.path(), channels_.size());
  const auto [known, is_new] = channels_.try_emplace(channel.id, topic);
  if (!is_new && known->second != topic) {
    throw damaged(offset,
                  fmt::format("channel {} is of topic {} here and was of {} before", channel.id,
                              in_quotes(topic.name), in_quotes(known->second.name)));
  }
}

void McapStorage::give(std::span<const std::byte> content, std::uint64_t offset, BagPlace place,
                       Use use) {
  if (content.size() < McapMessage::kHeadSize) {
    throw damaged(offset, fmt::format("a message has {} bytes, and must have {} at least",
                                      content.size(), McapMessage::kHeadSize));
  }
  const McapMessage message = message_of(content);
  const auto topic = channels_.find(message.channel);
  if (topic == channels_.end()) {
    throw damaged(offset, fmt::format("a message is of channel {}, which no record before it "
                                      "describes",
                                      message.channel));
  }
  constexpr auto kLatest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (message.log_time > kLatest) {
    throw damaged(offset, fmt::format("a message was recorded at {} ns, and {} is the latest time "
                                      "allowed",
                                      message.log_time, kLatest));
  }
  ++messages_;
  use({.topic = &topic->second,
       .recorded = static_cast<std::int64_t>(message.log_time),
       .data = message.data,
       .place = place});
}

std::span<const std::byte> McapStorage::read(const BagPlace& place) {
  if (place.unit == 0) {
    loaded_ = 0;
    content_.resize(static_cast<std::size_t>(place.size));
    file_.read_at(place.offset, content_);
    return content_;
  }
  if (loaded_ != place.unit) {
    unpack(chunks_.at(place.unit));
    loaded_ = place.unit;
  }
  return std::span<const std::byte>(content_).subspan(static_cast<std::size_t>(place.offset),
                                                      static_cast<std::size_t>(place.size));
}

std::vector<BagTopic> McapStorage::topics() const {
  std::vector<BagTopic> topics;
  for (const auto& [id, topic] : channels_) topics.push_back(topic);
  return topics;
}

}  // namespace rmap
