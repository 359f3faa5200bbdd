#include "support/checksums.hpp"

#include <cstddef>
#include <cstdint>

#include <xxhash.h>

namespace rmap::fuzz {

namespace {

constexpr std::size_t kHeader = 40;
constexpr std::size_t kReserved = 12;  // places in the header
constexpr std::size_t kScans = 16;
constexpr std::size_t kBlocks = 24;
constexpr std::size_t kCells = 32;
constexpr std::size_t kChunkHeader = 24;
constexpr std::size_t kChecksum = 8;
constexpr std::size_t kPose = 96;
constexpr std::uint16_t kCompressed = 2;

template <class T>
T number_at(const std::string& bytes, std::size_t offset) {
  T number{};
  bytes.copy(reinterpret_cast<char*>(&number), sizeof(T), offset);
  return number;
}

template <class T>
void put(std::string& bytes, std::size_t offset, T number) {
  bytes.replace(offset, sizeof(T), reinterpret_cast<const char*>(&number), sizeof(T));
}

// visit(offset of the chunk, size of its content) for all chunks that are there with all their
// bytes.
template <class Visit>
void for_each_chunk(const std::string& bytes, Visit&& visit) {
  constexpr std::size_t kFrame = kChunkHeader + kChecksum;
  std::size_t offset = kHeader + kChecksum;
  while (offset < bytes.size() && bytes.size() - offset >= kFrame) {
    const auto size = number_at<std::uint64_t>(bytes, offset + 16);
    if (size > bytes.size() - offset - kFrame) return;
    visit(offset, static_cast<std::size_t>(size));
    offset += kFrame + static_cast<std::size_t>(size);
  }
}

}  // namespace

std::string with_map_checksums(std::string_view bytes) {
  std::string file(bytes);
  std::size_t covered_from = 0;
  const auto seal = [&](std::size_t end) {
    const std::uint64_t checksum = XXH3_64bits(file.data() + covered_from, end - covered_from);
    put(file, end, checksum);
    covered_from = end;
  };
  if (file.size() < kHeader + kChecksum) return file;
  seal(kHeader);
  for_each_chunk(file,
                 [&](std::size_t offset, std::size_t size) { seal(offset + kChunkHeader + size); });
  return file;
}

std::string with_map_counts(std::string_view bytes) {
  std::string file(bytes);
  if (file.size() < kHeader || number_at<std::uint32_t>(file, kReserved) != 0) return file;
  std::uint64_t scans = 0;
  std::uint64_t blocks = 0;
  std::uint64_t cells = 0;
  std::uint64_t chunks = 0;
  bool known = true;
  for_each_chunk(file, [&](std::size_t offset, std::size_t size) {
    const std::string type = file.substr(offset, 4);
    const std::size_t content = offset + kChunkHeader;
    if (type == "POSE") scans += number_at<std::uint64_t>(file, offset + 8) / kPose;
    if (type == "CELL" && size >= 8) {
      known = known && (number_at<std::uint16_t>(file, offset + 4) & kCompressed) == 0;
      blocks += number_at<std::uint32_t>(file, content);
      cells += number_at<std::uint32_t>(file, content + 4);
    }
    if (type == "END " && size == 8) put(file, content, chunks);
    ++chunks;
  });
  if (!known) return file;
  put(file, kScans, scans);
  put(file, kBlocks, blocks);
  put(file, kCells, cells);
  return file;
}

std::string with_rcs_checksum(std::string_view bytes) {
  std::string file(bytes);
  if (file.size() < kChecksum) return file;
  const std::size_t end = file.size() - kChecksum;
  put(file, end, static_cast<std::uint64_t>(XXH3_64bits(file.data(), end)));
  return file;
}

}  // namespace rmap::fuzz
