#include "io/rmap_blocks.hpp"

#include "io/rmap_format.hpp"

#include <array>
#include <bit>
#include <cassert>

#include <fmt/format.h>

#include <rmap/cell.hpp>
#include <rmap/error.hpp>

namespace rmap::wire {

namespace {

using Word = std::uint64_t;

// Small for steps both ways, so that the upper bytes are zero.
std::uint32_t zigzag(std::uint32_t step) { return (step << 1) ^ (0 - (step >> 31)); }
std::uint32_t unzigzag(std::uint32_t number) { return (number >> 1) ^ (0 - (number & 1)); }

// Index of a block along an axis, modulo 2^32 so that steps never overflow.
std::uint32_t block_index(std::int32_t cell_index) {
  return static_cast<std::uint32_t>(cell_index >> 3);
}

// Bytes with the lowest of all numbers first, then the next ...: the upper ones are all zero.
void append_planes(std::vector<std::byte>& content, const std::vector<std::uint32_t>& numbers) {
  for (std::uint32_t shift = 0; shift < 32; shift += 8) {
    for (const std::uint32_t number : numbers) {
      content.push_back(static_cast<std::byte>(number >> shift));
    }
  }
}

std::byte byte_of(Word word, std::uint32_t index) {
  return static_cast<std::byte>(word >> (8 * index));
}

// Bit i tells whether byte i of the word is not zero.
std::byte summary_of(Word word) {
  std::uint32_t summary = 0;
  for (std::uint32_t i = 0; i < sizeof(Word); ++i) {
    summary |= static_cast<std::uint32_t>(byte_of(word, i) != std::byte{0}) << i;
  }
  return static_cast<std::byte>(summary);
}

[[noreturn]] void refuse(const std::string& predicate) { throw Error(ErrorKind::input, predicate); }

// The columns of a chunk's content, none of them longer than what there is.
class Columns {
 public:
  explicit Columns(std::span<const std::byte> content) : rest_(content) {
    const auto counts = take(2 * sizeof(std::uint32_t));
    blocks_ = load_little<std::uint32_t>(&counts[0]);
    cells_ = load_little<std::uint32_t>(&counts[4]);
    if (blocks_ == 0 || blocks_ > kMaxBlocksPerChunk) {
      refuse(fmt::format("has {} blocks: it must have 1 to {}", blocks_, kMaxBlocksPerChunk));
    }
    indices_ = take(3 * sizeof(std::uint32_t) * std::uint64_t{blocks_});
    summaries_ = take(sizeof(Word) * std::uint64_t{blocks_});
    std::uint64_t mask_bytes = 0;
    for (const std::byte summary : summaries_) {
      mask_bytes += static_cast<std::uint64_t>(std::popcount(static_cast<std::uint8_t>(summary)));
    }
    mask_bytes_ = take(mask_bytes);
    values_ = take(sizeof(Value) * std::uint64_t{cells_});
    if (!rest_.empty()) refuse(fmt::format("has {} bytes of content too many", rest_.size()));
  }

  std::uint32_t blocks() const { return blocks_; }
  std::uint32_t cells() const { return cells_; }

  /// The lowest cell of block `block`; blocks come in order.
  Cell next_origin(std::uint32_t block) {
    Cell origin;
    for (int axis = 0; axis < 3; ++axis) {
      std::uint32_t& index = index_before_[static_cast<std::size_t>(axis)];
      index += step(axis, block);
      constexpr auto kLimit = static_cast<std::uint32_t>(kMaxCellIndex / kBlockEdge) + 1;
      if (index + kLimit >= 2 * kLimit) {
        refuse(
            fmt::format("has block {} at {} times {} cells along axis {}: indices of cells must "
                        "lie in {} to {}",
                        block, static_cast<std::int32_t>(index), kBlockEdge, axis, kMinCellIndex,
                        kMaxCellIndex));
      }
      origin[axis] = static_cast<std::int32_t>(index) * kBlockEdge;
    }
    return origin;
  }

  /// Its mask.
  CellMask next_mask(std::uint32_t block) {
    CellMask mask;
    for (std::size_t word = 0; word < mask.words().size(); ++word) {
      const auto summary = static_cast<std::uint32_t>(summaries_[block * sizeof(Word) + word]);
      for (std::uint32_t i = 0; i < sizeof(Word); ++i) {
        if ((summary >> i & 1) == 0) continue;
        const std::byte byte = mask_bytes_[next_mask_byte_++];
        if (byte == std::byte{0}) refuse("has a byte of a mask that is zero and must not be");
        mask.words()[word] |= static_cast<Word>(byte) << (8 * i);
      }
    }
    if (mask.none()) refuse(fmt::format("has no cell in block {}", block));
    return mask;
  }

  /// The values of all blocks.
  void read_values(std::span<Value> into) const {
    for (std::size_t i = 0; i < into.size(); ++i) {
      into[i] = load_little<Value>(&values_[sizeof(Value) * i]);
    }
  }

 private:
  std::span<const std::byte> take(std::uint64_t count) {
    if (count > rest_.size()) {
      refuse(fmt::format("has too little content: {} bytes more are announced than there are",
                         count - rest_.size()));
    }
    const auto taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }

  // How far block `block` is from the one before it along an axis.
  std::uint32_t step(int axis, std::uint32_t block) const {
    std::uint32_t number = 0;
    for (std::uint32_t plane = 0; plane < 4; ++plane) {
      const std::size_t column = static_cast<std::size_t>(axis) * 4 + plane;
      number |= static_cast<std::uint32_t>(indices_[column * blocks_ + block]) << (8 * plane);
    }
    return unzigzag(number);
  }

  std::span<const std::byte> rest_;
  std::uint32_t blocks_ = 0;
  std::uint32_t cells_ = 0;
  std::span<const std::byte> indices_;
  std::span<const std::byte> summaries_;
  std::span<const std::byte> mask_bytes_;
  std::span<const std::byte> values_;
  std::array<std::uint32_t, 3> index_before_ = {};
  std::size_t next_mask_byte_ = 0;
};

}  // namespace

void BlockEncoder::add_block(const Cell& origin) {
  assert(origin == block_origin(origin) && blocks() < kMaxBlocksPerChunk);
  origins_.push_back(origin);
  masks_.emplace_back();
}

void BlockEncoder::add_cells(const CellMask& cells, std::span<const Value> values) {
  assert(cells.count() == values.size());
  masks_.back() |= cells;
  values_.insert(values_.end(), values.begin(), values.end());
}

std::vector<std::byte> BlockEncoder::take_content() {
  std::vector<std::byte> content;
  append(content, static_cast<std::uint32_t>(blocks()));
  append(content, static_cast<std::uint32_t>(cells()));

  std::vector<std::uint32_t> steps(blocks());
  for (int axis = 0; axis < 3; ++axis) {
    std::uint32_t before = 0;
    for (std::size_t block = 0; block < blocks(); ++block) {
      const std::uint32_t index = block_index(origins_[block][axis]);
      steps[block] = zigzag(index - before);
      before = index;
    }
    append_planes(content, steps);
  }
  for (const CellMask& mask : masks_) {
    for (const Word word : mask.words()) content.push_back(summary_of(word));
  }
  for (const CellMask& mask : masks_) {
    for (const Word word : mask.words()) {
      for (std::uint32_t i = 0; i < sizeof(Word); ++i) {
        if (byte_of(word, i) != std::byte{0}) content.push_back(byte_of(word, i));
      }
    }
  }
  for (const Value value : values_) append(content, value);

  origins_.clear();
  masks_.clear();
  values_.clear();
  return content;
}

std::span<const BlockValues> BlockDecoder::decode(std::span<const std::byte> content,
                                                  std::uint64_t stored_size) {
  Columns columns(content);
  if (const auto least = least_size_of_blocks(columns.blocks(), columns.cells());
      stored_size < least) {
    refuse(fmt::format("takes {} bytes for {} blocks with {} cells: it must take at least {}",
                       stored_size, columns.blocks(), columns.cells(), least));
  }
  chunk_.clear();
  values_.resize(columns.cells());
  std::span<Value> values_left(values_);
  for (std::uint32_t block = 0; block < columns.blocks(); ++block) {
    const Cell origin = columns.next_origin(block);
    if (last_origin_ && !morton_less(*last_origin_, origin)) {
      refuse(
          fmt::format("has block {} at cell ({}, {}, {}), which must come behind the block at "
                      "({}, {}, {}) in Morton order",
                      block, origin.x(), origin.y(), origin.z(), last_origin_->x(),
                      last_origin_->y(), last_origin_->z()));
    }
    last_origin_ = origin;
    const CellMask mask = columns.next_mask(block);
    const std::size_t count = mask.count();
    if (count > values_left.size()) {
      refuse(fmt::format("has values for {} cells, and more cells in its masks", columns.cells()));
    }
    chunk_.push_back({origin, mask, values_left.first(count)});
    values_left = values_left.subspan(count);
  }
  if (!values_left.empty()) {
    refuse(fmt::format("has values for {} cells, and only {} cells in its masks", columns.cells(),
                       columns.cells() - values_left.size()));
  }
  columns.read_values(values_);
  blocks_ += columns.blocks();
  cells_ += columns.cells();
  return chunk_;
}

}  // namespace rmap::wire
