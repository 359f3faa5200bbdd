#include "io/rmap_writer.hpp"

#include <algorithm>
#include <cassert>

namespace rmap {

using wire::ChunkHeader;

RmapWriter::RmapWriter(const std::filesystem::path& file, const wire::Header& header)
    : file_(file) {
  write(encoded(header));
  write_checksum();
}

void RmapWriter::add(const wire::ChunkType& type, std::span<const std::byte> content,
                     std::uint64_t least_size) {
  assert(content.size() <= wire::kMaxContentSize);
  ChunkHeader header{.type = type, .flags = wire::kRequired, .raw_size = content.size()};
  if (const auto frame = compressor_.compress(content)) {
    header.stored_size = std::max<std::uint64_t>(frame->size(), least_size);
    if (header.stored_size < content.size()) {
      header.flags |= wire::kCompressed;
      write_chunk(header, *frame, static_cast<std::size_t>(header.stored_size) - frame->size());
      return;
    }
  }
  header.stored_size = content.size();
  write_chunk(header, content, 0);
}

void RmapWriter::commit() {
  std::vector<std::byte> content;
  wire::append(content, chunks_);
  write_chunk({.type = wire::kEnd,
               .flags = wire::kRequired,
               .raw_size = content.size(),
               .stored_size = content.size()},
              content, 0);
  file_.commit();
}

void RmapWriter::write_chunk(const ChunkHeader& header, std::span<const std::byte> stored,
                             std::size_t padding) {
  write(encoded(header));
  write(stored);
  write(std::vector<std::byte>(padding));
  write_checksum();
  ++chunks_;
}

void RmapWriter::write(std::span<const std::byte> bytes) {
  checksum_.update(bytes);
  file_.write(bytes);
}

void RmapWriter::write_checksum() { file_.write(little_endian(checksum_.close())); }

}  // namespace rmap
