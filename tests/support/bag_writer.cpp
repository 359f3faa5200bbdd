#include "support/bag_writer.hpp"

#include <algorithm>
#include <fstream>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <lz4frame.h>
#include <sqlite3.h>
#include <zstd.h>

namespace rmap::test {

namespace {

constexpr std::string_view kMagic = "\x89MCAP0\r\n";

template <class T>
std::string raw(T number) {
  return {reinterpret_cast<const char*>(&number), sizeof(T)};
}

std::string text(std::string_view text) {
  return raw(static_cast<std::uint32_t>(text.size())) + std::string(text);
}

std::uint16_t id_of(std::size_t topic) { return static_cast<std::uint16_t>(topic + 1); }

// A schema and a channel for each topic.
std::string descriptions(const TestBag& bag, const McapStyle& style) {
  std::string records;
  for (std::size_t i = 0; i < bag.topics.size(); ++i) {
    const TestTopic& topic = bag.topics[i];
    records += mcap_record(
        3, raw(id_of(i)) + text(topic.type) + text(style.schema_encoding) + text("# nothing"));
    records += mcap_record(
        4, raw(id_of(i)) + raw(id_of(i)) + text(topic.name) + text(topic.encoding) + raw(0U));
  }
  return records;
}

std::string message_record(const TestMessage& message, std::uint32_t number) {
  return mcap_record(5, raw(id_of(message.topic)) + raw(number) +
                            raw(static_cast<std::uint64_t>(message.recorded)) +
                            raw(static_cast<std::uint64_t>(message.recorded)) + message.data);
}

std::string name_of(TestCompression compression) {
  switch (compression) {
    case TestCompression::lz4:
      return "lz4";
    case TestCompression::zstd:
      return "zstd";
    default:
      return "";
  }
}

std::string statistics(const TestBag& bag, std::size_t chunks) {
  std::uint64_t first = ~std::uint64_t{0};
  std::uint64_t last = 0;
  for (const TestMessage& message : bag.messages) {
    first = std::min(first, static_cast<std::uint64_t>(message.recorded));
    last = std::max(last, static_cast<std::uint64_t>(message.recorded));
  }
  const auto topics = static_cast<std::uint32_t>(bag.topics.size());
  return mcap_record(11, raw(static_cast<std::uint64_t>(bag.messages.size())) +
                             raw(static_cast<std::uint16_t>(topics)) + raw(topics) + raw(0U) +
                             raw(0U) + raw(static_cast<std::uint32_t>(chunks)) + raw(first) +
                             raw(last) + raw(0U));
}

struct ChunkPlace {
  std::uint64_t offset;
  std::uint64_t size;
  std::uint64_t packed;
  std::uint64_t unpacked;
};

std::string chunk_index(const ChunkPlace& place, const McapStyle& style) {
  return mcap_record(8, raw(std::uint64_t{0}) + raw(~std::uint64_t{0}) + raw(place.offset) +
                            raw(place.size) + raw(0U) + raw(std::uint64_t{0}) +
                            text(name_of(style.compression)) + raw(place.packed) +
                            raw(place.unpacked));
}

class Database {
 public:
  Database(const std::filesystem::path& file, int page_size) {
    sqlite3_open(file.c_str(), &database_);
    run(fmt::format("PRAGMA page_size={}; PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; BEGIN",
                    page_size));
  }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database() { sqlite3_close(database_); }

  void run(const std::string& sql) {
    if (sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
      throw std::runtime_error(sqlite3_errmsg(database_));
    }
  }

  void add(std::size_t id, const TestMessage& message) {
    sqlite3_stmt* row = nullptr;
    sqlite3_prepare_v2(database_, "INSERT INTO messages VALUES(?1, ?2, ?3, ?4)", -1, &row, nullptr);
    sqlite3_bind_int64(row, 1, static_cast<sqlite3_int64>(id));
    sqlite3_bind_int64(row, 2, static_cast<sqlite3_int64>(message.topic + 1));
    sqlite3_bind_int64(row, 3, message.recorded);
    sqlite3_bind_blob64(row, 4, message.data.data(), message.data.size(), SQLITE_STATIC);
    const int code = sqlite3_step(row);
    sqlite3_finalize(row);
    if (code != SQLITE_DONE) throw std::runtime_error(sqlite3_errmsg(database_));
  }

 private:
  sqlite3* database_ = nullptr;
};

void write(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream << bytes;
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace

void TestBag::add(std::string_view topic, std::string_view type, std::int64_t recorded,
                  std::string data) {
  const auto found = std::find_if(topics.begin(), topics.end(),
                                  [&](const TestTopic& known) { return known.name == topic; });
  const auto index = static_cast<std::size_t>(found - topics.begin());
  if (found == topics.end()) topics.push_back({std::string(topic), std::string(type)});
  messages.push_back({index, recorded, std::move(data)});
}

std::uint32_t plain_crc32(std::string_view bytes) {
  std::uint32_t state = ~0U;
  for (const char byte : bytes) {
    state ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) state = (state >> 1) ^ ((state & 1) != 0 ? 0xEDB88320 : 0);
  }
  return ~state;
}

std::string pack(TestCompression compression, std::string_view content) {
  std::string packed;
  if (compression == TestCompression::zstd) {
    packed.resize(ZSTD_compressBound(content.size()));
    packed.resize(ZSTD_compress(packed.data(), packed.size(), content.data(), content.size(), 1));
  } else if (compression == TestCompression::lz4) {
    packed.resize(LZ4F_compressFrameBound(content.size(), nullptr));
    packed.resize(
        LZ4F_compressFrame(packed.data(), packed.size(), content.data(), content.size(), nullptr));
  } else {
    packed = content;
  }
  return packed;
}

std::string mcap_record(std::uint8_t opcode, std::string_view content) {
  return raw(opcode) + raw(static_cast<std::uint64_t>(content.size())) + std::string(content);
}

std::string mcap_chunk(std::string_view compression, std::string_view packed,
                       std::uint64_t unpacked_size, std::uint32_t crc) {
  return mcap_record(6, raw(std::uint64_t{0}) + raw(~std::uint64_t{0}) + raw(unpacked_size) +
                            raw(crc) + text(compression) +
                            raw(static_cast<std::uint64_t>(packed.size())) + std::string(packed));
}

std::string mcap_bytes(const TestBag& bag, const McapStyle& style) {
  std::string bytes(kMagic);
  bytes += mcap_record(1, text("ros2") + text("tests"));
  std::vector<ChunkPlace> chunks;
  const std::size_t step = style.messages_per_chunk;
  if (step == 0 || bag.messages.empty()) bytes += descriptions(bag, style);
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < bag.messages.size();) {
    // As recorders do, each chunk describes what is in it.
    std::string content = step == 0 ? std::string() : descriptions(bag, style);
    const std::size_t end = step == 0 ? i + 1 : std::min(i + step, bag.messages.size());
    for (; i < end; ++i) content += message_record(bag.messages[i], number++);
    if (step == 0) {
      bytes += content;
      continue;
    }
    const std::string packed = pack(style.compression, content);
    const std::string chunk = mcap_chunk(name_of(style.compression), packed, content.size(),
                                         style.checksums ? plain_crc32(content) : 0);
    chunks.push_back({bytes.size(), chunk.size(), packed.size(), content.size()});
    bytes += chunk;
  }
  bytes += mcap_record(15, raw(style.checksums ? plain_crc32(bytes) : 0U));
  std::string summary;
  if (style.summary) {
    summary = descriptions(bag, style) + statistics(bag, chunks.size());
    for (const ChunkPlace& chunk : chunks) summary += chunk_index(chunk, style);
  }
  // The footer without its checksum.
  const std::string footer = raw(std::uint8_t{2}) + raw(std::uint64_t{20}) +
                             raw(std::uint64_t{style.summary ? bytes.size() : 0}) +
                             raw(std::uint64_t{0});
  summary += footer;
  return bytes + summary + raw(style.checksums ? plain_crc32(summary) : 0U) + std::string(kMagic);
}

void write_db3(const TestBag& bag, const std::filesystem::path& file, int page_size) {
  Database database(file, page_size);
  database.run(
      "CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,"
      "serialization_format TEXT NOT NULL,offered_qos_profiles TEXT NOT NULL);"
      "CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,"
      "timestamp INTEGER NOT NULL,data BLOB NOT NULL);"
      "CREATE INDEX timestamp_idx ON messages (timestamp ASC);");
  for (std::size_t i = 0; i < bag.topics.size(); ++i) {
    database.run(fmt::format("INSERT INTO topics VALUES({}, '{}', '{}', '{}', '')", i + 1,
                             bag.topics[i].name, bag.topics[i].type, bag.topics[i].encoding));
  }
  for (std::size_t i = 0; i < bag.messages.size(); ++i) database.add(i + 1, bag.messages[i]);
  database.run("COMMIT");
}

void write_rosbag2(const TestBag& bag, const std::filesystem::path& folder, bool mcap,
                   std::size_t files) {
  std::filesystem::create_directories(folder);
  std::string metadata = fmt::format(
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: {}\n"
      "  compression_format: ''\n  compression_mode: ''\n  relative_file_paths:\n",
      mcap ? "mcap" : "sqlite3");
  const std::size_t step = (bag.messages.size() + files - 1) / files;
  for (std::size_t i = 0; i < files; ++i) {
    TestBag part{.topics = bag.topics};
    for (std::size_t k = i * step; k < std::min(bag.messages.size(), (i + 1) * step); ++k) {
      part.messages.push_back(bag.messages[k]);
    }
    const std::string name = fmt::format("bag_{}.{}", i, mcap ? "mcap" : "db3");
    if (mcap) {
      write(folder / name, mcap_bytes(part));
    } else {
      write_db3(part, folder / name);
    }
    metadata += "  - " + name + "\n";
  }
  write(folder / "metadata.yaml", metadata);
}

}  // namespace rmap::test
