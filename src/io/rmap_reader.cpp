#include "io/rmap_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rmap {

namespace {

constexpr std::size_t kSkipPiece = std::size_t{1} << 16;

bool starts_with(std::span<const std::byte> bytes, std::span<const unsigned char> start) {
  return bytes.size() >= start.size() &&
         std::equal(start.begin(), start.end(), bytes.begin(),
                    [](unsigned char a, std::byte b) { return std::byte{a} == b; });
}

void require_magic(const InputFile& file) {
  const std::vector<std::byte> head = file.head(wire::kMagic.size());
  if (starts_with(head, wire::kMagic)) return;
  const std::string name = file.path().string();
  constexpr std::size_t kUnchangedByText = 5;
  if (starts_with(head, std::span(wire::kMagic).first(kUnchangedByText))) {
    throw Error(ErrorKind::input,
                fmt::format("{} is a damaged rmap file: bytes {} to {} are not what they must be, "
                            "as when a transfer in text mode rewrites the ends of lines",
                            name, kUnchangedByText, wire::kMagic.size() - 1));
  }
  throw Error(ErrorKind::input,
              fmt::format("{} is not an rmap file: its first {} bytes are not those that every "
                          "rmap file begins with",
                          name, wire::kMagic.size()));
}

std::string place_of(const RmapReader::Chunk& chunk) {
  return fmt::format("chunk {} at byte {}", wire::name_of(chunk.header.type), chunk.offset);
}

}  // namespace

RmapReader::RmapReader(const std::filesystem::path& file) : file_(file) {
  require_magic(file_);
  read_header();
}

void RmapReader::read_header() {
  constexpr std::size_t kSize = wire::kHeaderSize + wire::kChecksumSize;
  if (remaining() < kSize) {
    throw Error(ErrorKind::input, fmt::format("{} is cut off: it has {} bytes, and the header of "
                                              "an rmap file alone takes {}",
                                              file_.path().string(), file_.size(), kSize));
  }
  std::array<std::byte, wire::kHeaderSize> bytes;
  read_bytes(bytes);
  verify_checksum("the header");
  header_ = wire::decoded_header(bytes);
  if (header_.version != wire::kFormatVersion) {
    throw Error(ErrorKind::input,
                fmt::format("{} is in version {} of the rmap format: this release of rmap reads "
                            "version {}",
                            file_.path().string(), header_.version, wire::kFormatVersion));
  }
}

RmapReader::Chunk RmapReader::next() {
  Chunk chunk{.header = {}, .offset = position_};
  if (remaining() < wire::kChunkHeaderSize) {
    throw Error(ErrorKind::input,
                fmt::format("{} is cut off: at byte {} a chunk must follow, up to the END chunk, "
                            "and {} bytes are left",
                            file_.path().string(), position_, remaining()));
  }
  std::array<std::byte, wire::kChunkHeaderSize> bytes;
  read_bytes(bytes);
  chunk.header = wire::decoded_chunk_header(bytes);
  if (remaining() < wire::kChecksumSize ||
      chunk.header.stored_size > remaining() - wire::kChecksumSize) {
    throw Error(
        ErrorKind::input,
        fmt::format("{} is cut off or damaged: {} takes {} bytes and a checksum, and {} "
                    "bytes are left",
                    file_.path().string(), place_of(chunk), chunk.header.stored_size, remaining()));
  }
  ++chunks_;
  return chunk;
}

std::span<const std::byte> RmapReader::read(const Chunk& chunk) {
  read_stored(chunk);
  try {
    return decoder_.decode(chunk.header, stored_);
  } catch (const Error& wrong) {
    throw error(chunk, wrong.what());
  }
}

void RmapReader::read_stored(const Chunk& chunk) {
  if (chunk.header.stored_size > wire::kMaxContentSize) {
    throw error(chunk, fmt::format("takes {} bytes: at most {} are allowed",
                                   chunk.header.stored_size, wire::kMaxContentSize));
  }
  stored_.resize(static_cast<std::size_t>(chunk.header.stored_size));
  read_bytes(stored_);
  verify_checksum(place_of(chunk));
}

void RmapReader::skip(const Chunk& chunk) {
  stored_.resize(kSkipPiece);
  for (std::uint64_t left = chunk.header.stored_size; left > 0;) {
    const auto piece = std::span(stored_).first(
        static_cast<std::size_t>(std::min<std::uint64_t>(left, kSkipPiece)));
    read_bytes(piece);
    left -= piece.size();
  }
  verify_checksum(place_of(chunk));
}

void RmapReader::finish(const Chunk& end) {
  const auto content = read(end);
  if (content.size() != sizeof(std::uint64_t) ||
      load_little<std::uint64_t>(content.data()) != chunks_ - 1) {
    throw error(
        end, fmt::format("must hold 8 bytes with the number of chunks before it, {}", chunks_ - 1));
  }
  if (remaining() != 0) {
    throw Error(ErrorKind::input,
                fmt::format("{} goes on for {} bytes behind its END chunk, which ends at byte {}",
                            file_.path().string(), remaining(), position_));
  }
}

void RmapReader::verify_checksum(std::string_view whose) {
  const std::uint64_t expected = checksum_.close();
  std::array<std::byte, wire::kChecksumSize> stored;
  file_.read(stored);
  position_ += stored.size();
  if (load_little<std::uint64_t>(stored.data()) == expected) return;
  throw Error(ErrorKind::input,
              fmt::format("{} is damaged: the checksum of {} does not fit its bytes",
                          file_.path().string(), whose));
}

void RmapReader::read_bytes(std::span<std::byte> bytes) {
  file_.read(bytes);
  position_ += bytes.size();
  checksum_.update(bytes);
}

Error RmapReader::error(const Chunk& chunk, std::string_view wrong) const {
  return {ErrorKind::input,
          fmt::format("{}: {} {}", file_.path().string(), place_of(chunk), wrong)};
}

}  // namespace rmap
