#include "io/rmap_format.hpp"

#include <fmt/format.h>

namespace rmap::wire {

namespace {

constexpr std::uint32_t kReserved = 0;

}  // namespace

std::string name_of(const ChunkType& type) {
  std::string name;
  for (const char character : type) {
    const bool printable = character >= ' ' && character <= '~';
    name += printable ? std::string(1, character)
                      : fmt::format("\\x{:02x}", static_cast<unsigned char>(character));
  }
  while (!name.empty() && name.back() == ' ') name.pop_back();
  return name;
}

std::vector<std::byte> encoded(const Header& header) {
  std::vector<std::byte> bytes;
  for (const unsigned char byte : kMagic) append(bytes, byte);
  append(bytes, header.version);
  append(bytes, kReserved);
  append(bytes, header.scans);
  append(bytes, header.blocks);
  append(bytes, header.cells);
  return bytes;
}

std::vector<std::byte> encoded(const ChunkHeader& header) {
  std::vector<std::byte> bytes;
  for (const char character : header.type) append(bytes, character);
  append(bytes, header.flags);
  append(bytes, header.version);
  append(bytes, header.raw_size);
  append(bytes, header.stored_size);
  return bytes;
}

Header decoded_header(std::span<const std::byte, kHeaderSize> bytes) {
  return {.version = load_little<std::uint32_t>(&bytes[8]),
          .scans = load_little<std::uint64_t>(&bytes[16]),
          .blocks = load_little<std::uint64_t>(&bytes[24]),
          .cells = load_little<std::uint64_t>(&bytes[32])};
}

ChunkHeader decoded_chunk_header(std::span<const std::byte, kChunkHeaderSize> bytes) {
  ChunkHeader header{.flags = load_little<std::uint16_t>(&bytes[4]),
                     .version = load_little<std::uint16_t>(&bytes[6]),
                     .raw_size = load_little<std::uint64_t>(&bytes[8]),
                     .stored_size = load_little<std::uint64_t>(&bytes[16])};
  for (std::size_t i = 0; i < header.type.size(); ++i) {
    header.type[i] = load_little<char>(&bytes[i]);
  }
  return header;
}

}  // namespace rmap::wire
