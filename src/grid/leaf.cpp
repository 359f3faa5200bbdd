#include <rmap/leaf.hpp>

namespace rmap {

namespace {

// Spreads the three bits of an offset so that two zeros lie between them.
constexpr std::uint32_t spread(std::uint32_t offset) {
  return (offset & 1) | ((offset & 2) << 2) | ((offset & 4) << 4);
}

constexpr std::int32_t gathered(std::uint32_t position) {
  return static_cast<std::int32_t>((position & 1) | ((position >> 2) & 2) | ((position >> 4) & 4));
}

}  // namespace

BlockPosition block_position(const Cell& cell) {
  const auto offset = [&](int axis) {
    return spread(static_cast<std::uint32_t>(cell[axis]) & (kBlockEdge - 1));
  };
  return offset(0) | (offset(1) << 1) | (offset(2) << 2);
}

Cell block_offset(BlockPosition position) {
  return {gathered(position), gathered(position >> 1), gathered(position >> 2)};
}

std::uint32_t CellMask::count() const {
  int count = 0;
  for (const std::uint64_t word : words_) count += std::popcount(word);
  return static_cast<std::uint32_t>(count);
}

std::uint32_t CellMask::rank(BlockPosition position) const {
  int rank = 0;
  for (std::uint32_t word = 0; word < position / 64; ++word) rank += std::popcount(words_[word]);
  return static_cast<std::uint32_t>(rank +
                                    std::popcount(words_[position / 64] & (bit(position) - 1)));
}

CellMask& CellMask::operator|=(const CellMask& other) {
  for (std::size_t word = 0; word < words_.size(); ++word) words_[word] |= other.words_[word];
  return *this;
}

CellMask& CellMask::operator&=(const CellMask& other) {
  for (std::size_t word = 0; word < words_.size(); ++word) words_[word] &= other.words_[word];
  return *this;
}

CellMask CellMask::without(const CellMask& other) const {
  CellMask rest;
  for (std::size_t word = 0; word < words_.size(); ++word) {
    rest.words_[word] = words_[word] & ~other.words_[word];
  }
  return rest;
}

}  // namespace rmap
