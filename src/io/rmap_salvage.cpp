#include "io/rmap_salvage.hpp"

#include "io/rmap_checksum.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rmap {

namespace {

using wire::ChunkHeader;

constexpr std::size_t kHeaderSize = wire::kHeaderSize + wire::kChecksumSize;

// Bytes that a file has checksums made of, for each of its own and beyond: what looks like chunks
// by malice must not make the search take forever. Damage alone stays far below it.
constexpr std::uint64_t kChecksumsPerByte = 64;
constexpr std::uint64_t kChecksumsMore = std::uint64_t{1} << 26;

constexpr std::array kKnownTypes = {wire::kOptions, wire::kHistory, wire::kPoses, wire::kCells,
                                    wire::kEnd};

bool is_known(const wire::ChunkType& type) {
  return std::find(kKnownTypes.begin(), kKnownTypes.end(), type) != kKnownTypes.end();
}

bool could_be_type(const wire::ChunkType& type) {
  return std::all_of(type.begin(), type.end(), [](char character) {
    return (character >= 'A' && character <= 'Z') || (character >= '0' && character <= '9') ||
           character == ' ';
  });
}

class Search {
 public:
  Search(const std::filesystem::path& file, std::span<const std::byte> bytes)
      : file_(file), bytes_(bytes), budget_(kChecksumsPerByte * bytes.size() + kChecksumsMore) {}

  Salvage run() {
    read_header();
    // Of a damaged header it is not known where it ends.
    std::size_t at = found_.header ? kHeaderSize : wire::kChecksumSize;
    gap_ = std::min(kHeaderSize, bytes_.size());
    while (at < bytes_.size() && !ended_) {
      if (const auto end = chunk_at(at)) {
        at = *end;
        gap_ = at;
      } else {
        ++at;
      }
    }
    finish(at);
    return std::move(found_);
  }

 private:
  /// A chunk as its header says, with the checksum that it should have.
  struct Candidate {
    SoundChunk chunk;
    std::size_t end;  ///< of its checksum
    std::uint64_t checksum;
  };

  void read_header() {
    if (bytes_.size() < kHeaderSize) {
      problem(0, bytes_.size(), "",
              fmt::format("{} is cut off: it has {} bytes, and the header of an rmap file alone "
                          "takes {}",
                          file_.string(), bytes_.size(), kHeaderSize));
      return;
    }
    RmapChecksum checksum;
    checksum.update(bytes_.first(wire::kHeaderSize));
    before_ = checksum.close();
    std::array<std::byte, wire::kHeaderSize> header;
    std::copy_n(bytes_.begin(), header.size(), header.begin());
    const bool magic = std::equal(wire::kMagic.begin(), wire::kMagic.end(), header.begin(),
                                  [](unsigned char a, std::byte b) { return std::byte{a} == b; });
    if (magic && number_at(wire::kHeaderSize) == *before_) {
      found_.header = wire::decoded_header(header);
    } else {
      // Its checksum alone may be damaged: then the first chunk confirms the rest.
      pending_header_ = wire::decoded_header(header);
      problem(0, kHeaderSize, "",
              fmt::format("{} is damaged: the checksum of the header does not fit its bytes",
                          file_.string()));
    }
  }

  std::uint64_t number_at(std::size_t offset) const {
    return load_little<std::uint64_t>(&bytes_[offset]);
  }

  // The header of a chunk that would fit into the file.
  std::optional<ChunkHeader> header_at(std::size_t at) const {
    const std::size_t left = bytes_.size() - at;
    if (at < wire::kChecksumSize || left < wire::kChunkHeaderSize + wire::kChecksumSize) return {};
    std::array<std::byte, wire::kChunkHeaderSize> header;
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at), header.size(), header.begin());
    const ChunkHeader chunk = wire::decoded_chunk_header(header);
    if (!could_be_type(chunk.type) ||
        chunk.stored_size > left - wire::kChunkHeaderSize - wire::kChecksumSize ||
        (is_known(chunk.type) && chunk.stored_size > wire::kMaxContentSize)) {
      return {};
    }
    return chunk;
  }

  // What stands at `at`, behind the checksum `before`.
  Candidate candidate(std::size_t at, const ChunkHeader& header, std::uint64_t before) {
    const std::size_t size = wire::kChunkHeaderSize + static_cast<std::size_t>(header.stored_size);
    budget_ -= std::min<std::uint64_t>(budget_, size);
    RmapChecksum checksum;
    checksum.update(little_endian(before));
    checksum.update(bytes_.subspan(at, size));
    return {.chunk = {.header = header,
                      .offset = at,
                      .stored = bytes_.subspan(at + wire::kChunkHeaderSize,
                                               size - wire::kChunkHeaderSize)},
            .end = at + size + wire::kChecksumSize,
            .checksum = checksum.close()};
  }

  bool confirmed(const Candidate& candidate) const {
    return number_at(candidate.end - wire::kChecksumSize) == candidate.checksum;
  }

  // Takes the chunk at `at` when there is one that is confirmed; where it ends.
  std::optional<std::size_t> chunk_at(std::size_t at) {
    const auto header = header_at(at);
    if (!header || budget_ == 0) return {};
    // The checksum before it is what stands there. Where that is damaged, or bytes were added
    // behind it, it is that of the last sound chunk, or of a damaged one whose checksum only
    // is: this one then confirms that one.
    const std::uint64_t stands = number_at(at - wire::kChecksumSize);
    const Candidate as_it_stands = candidate(at, *header, stands);
    if (confirmed(as_it_stands)) return take(as_it_stands);
    if (before_ && *before_ != stands) {
      const Candidate behind_last = candidate(at, *header, *before_);
      if (confirmed(behind_last)) {
        if (pending_header_) found_.header = pending_header_;
        return take(behind_last);
      }
    }
    if (pending_ && pending_->checksum != stands) {
      const Candidate behind_pending = candidate(at, *header, pending_->checksum);
      if (confirmed(behind_pending)) {
        const Candidate first = *pending_;
        close_gap(first.chunk.offset);
        found_.chunks.push_back(first.chunk);
        gap_ = first.end;
        problem(first.end - wire::kChecksumSize, wire::kChecksumSize,
                wire::name_of(first.chunk.header.type),
                fmt::format("{} is damaged: the checksum of {} is not what it must be, though the "
                            "next chunk confirms its bytes",
                            file_.string(), first.chunk.place()));
        return take(behind_pending);
      }
    }
    if (at == gap_) {
      pending_ = before_ ? candidate(at, *header, *before_) : as_it_stands;
    }
    return {};
  }

  std::size_t take(const Candidate& candidate) {
    close_gap(candidate.chunk.offset);
    found_.chunks.push_back(candidate.chunk);
    before_ = candidate.checksum;
    pending_.reset();
    pending_header_.reset();
    ended_ = candidate.chunk.header.type == wire::kEnd;
    return candidate.end;
  }

  // All from gap_ to `end` is damaged: chunk by chunk where their headers lead to `end`.
  void close_gap(std::size_t end) {
    if (gap_ >= end) return;
    std::vector<SoundChunk> parts;
    std::size_t at = gap_;
    while (at < end) {
      const auto header = header_at(at);
      if (!header || !is_known(header->type)) break;
      parts.push_back({.header = *header, .offset = at, .stored = {}});
      at += wire::kChunkHeaderSize + static_cast<std::size_t>(header->stored_size) +
            wire::kChecksumSize;
    }
    if (at == end) {
      for (const SoundChunk& part : parts) {
        problem(part.offset, wire::kChunkHeaderSize + part.header.stored_size + wire::kChecksumSize,
                wire::name_of(part.header.type),
                fmt::format("{} is damaged: the checksum of {} does not fit its bytes",
                            file_.string(), part.place()));
      }
    } else {
      problem(gap_, end - gap_, parts.empty() ? "" : wire::name_of(parts.front().header.type),
              fmt::format("{} is damaged: its {} bytes from byte {} on are no chunk that a "
                          "checksum confirms{}",
                          file_.string(), end - gap_, gap_,
                          parts.empty() ? ""
                                        : ", though they begin as one of type " +
                                              wire::name_of(parts.front().header.type)));
    }
  }

  void finish(std::size_t at) {
    if (ended_) {
      if (at == bytes_.size()) return;
      problem(at, bytes_.size() - at, "",
              fmt::format("{} goes on for {} bytes behind its END chunk, which ends at byte {}",
                          file_.string(), bytes_.size() - at, at));
      return;
    }
    close_gap(bytes_.size());
    if (budget_ == 0) {
      problem(gap_, 0, "",
              fmt::format("{} is so damaged that the search for chunks behind byte {} was given "
                          "up",
                          file_.string(), gap_));
    }
    if (gap_ == bytes_.size() && found_.header) {
      problem(gap_, 0, "",
              fmt::format("{} is cut off: at byte {} a chunk must follow, up to the END chunk, and "
                          "0 bytes are left",
                          file_.string(), gap_));
    }
  }

  void problem(std::uint64_t offset, std::uint64_t size, std::string chunk, std::string sentence) {
    found_.problems.push_back({.sentence = std::move(sentence),
                               .chunk = std::move(chunk),
                               .offset = offset,
                               .size = size});
  }

  const std::filesystem::path& file_;
  std::span<const std::byte> bytes_;
  Salvage found_;
  std::uint64_t budget_;
  std::size_t gap_ = 0;                  ///< from here on nothing is confirmed
  std::optional<std::uint64_t> before_;  ///< checksum of the last part that is
  std::optional<wire::Header> pending_header_;
  std::optional<Candidate> pending_;  ///< at gap_, not confirmed by its own checksum
  bool ended_ = false;
};

}  // namespace

std::string SoundChunk::place() const {
  return fmt::format("chunk {} at byte {}", wire::name_of(header.type), offset);
}

Salvage salvage(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  return Search(file, bytes).run();
}

}  // namespace rmap
