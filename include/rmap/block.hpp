#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include <rmap/value.hpp>

namespace rmap {

/// Position of a cell in a block of 8 x 8 x 8: along the Morton curve, x the
/// fastest axis, so that 8 positions are a 2 x 2 x 2 and 64 a 4 x 4 x 4 sub-block.
using BlockPosition = std::uint32_t;

inline constexpr std::int32_t kBlockEdge = 8;
inline constexpr std::uint32_t kBlockCells = 512;

/// Number of bits that are set. Unlike std::popcount never a call into a library,
/// which it is for processors of which nothing is known.
constexpr std::uint32_t bit_count(std::uint64_t word) {
#ifdef __POPCNT__
  return static_cast<std::uint32_t>(std::popcount(word));
#else
  word -= (word >> 1) & 0x5555555555555555U;
  word = (word & 0x3333333333333333U) + ((word >> 2) & 0x3333333333333333U);
  word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0FU;
  return static_cast<std::uint32_t>((word * 0x0101010101010101U) >> 56);
#endif
}

/// A set of positions in a block. A leaf branch that is a single cell uses position 0 only.
class CellMask {
 public:
  /// The set of one position.
  static constexpr CellMask single(BlockPosition position) {
    CellMask mask;
    mask.set(position);
    return mask;
  }

  bool test(BlockPosition position) const {
    return ((words_[position / 64] >> (position % 64)) & 1) != 0;
  }
  constexpr void set(BlockPosition position) { words_[position / 64] |= bit(position); }
  /// Sets a position where `condition` holds, without a branch.
  void set_if(BlockPosition position, bool condition) {
    words_[position / 64] |= std::uint64_t{condition} << (position % 64);
  }
  void reset(BlockPosition position) { words_[position / 64] &= ~bit(position); }
  bool none() const { return *this == CellMask{}; }
  std::uint32_t count() const {
    std::uint32_t count = 0;
    for (const std::uint64_t word : words_) count += bit_count(word);
    return count;
  }
  /// How many positions of the set lie before `position`.
  std::uint32_t rank(BlockPosition position) const {
    std::uint32_t rank = bit_count(words_[position / 64] & (bit(position) - 1));
    for (std::uint32_t word = 0; word < position / 64; ++word) rank += bit_count(words_[word]);
    return rank;
  }

  const std::array<std::uint64_t, 8>& words() const { return words_; }
  std::array<std::uint64_t, 8>& words() { return words_; }

  CellMask& operator|=(const CellMask& other) {
    for (std::size_t word = 0; word < words_.size(); ++word) words_[word] |= other.words_[word];
    return *this;
  }
  CellMask& operator&=(const CellMask& other) {
    for (std::size_t word = 0; word < words_.size(); ++word) words_[word] &= other.words_[word];
    return *this;
  }
  /// The positions of this set that are not in `other`.
  CellMask without(const CellMask& other) const {
    CellMask rest;
    for (std::size_t word = 0; word < words_.size(); ++word) {
      rest.words_[word] = words_[word] & ~other.words_[word];
    }
    return rest;
  }
  friend CellMask operator&(CellMask a, const CellMask& b) { return a &= b; }
  friend bool operator==(const CellMask&, const CellMask&) = default;

  /// use(position) for each position of the set, ascending.
  template <class Use>
  void for_each(Use&& use) const {
    for (std::uint32_t word = 0; word < words_.size(); ++word) {
      for (std::uint64_t left = words_[word]; left != 0; left &= left - 1) {
        use(word * 64 + static_cast<BlockPosition>(std::countr_zero(left)));
      }
    }
  }
  /// use(position, rank) for each position of the set, ascending, with its rank in `among`,
  /// a set that holds this one.
  template <class Use>
  void for_each_ranked(const CellMask& among, Use&& use) const {
    std::uint32_t before = 0;
    for (std::uint32_t word = 0; word < words_.size(); ++word) {
      const std::uint64_t all = among.words_[word];
      for (std::uint64_t left = words_[word]; left != 0; left &= left - 1) {
        const auto place = static_cast<BlockPosition>(std::countr_zero(left));
        use(word * 64 + place, before + bit_count(all & (bit(place) - 1)));
      }
      before += bit_count(all);
    }
  }

 private:
  static constexpr std::uint64_t bit(BlockPosition position) {
    return std::uint64_t{1} << (position % 64);
  }

  std::array<std::uint64_t, 8> words_{};
};

/// Position of `cell` in the block that holds it.
inline BlockPosition block_position(const Cell& cell) {
  constexpr std::array<std::uint8_t, kBlockEdge> kSpread{0, 1, 8, 9, 64, 65, 72, 73};
  const auto spread = [&](std::int32_t index) -> BlockPosition {
    return kSpread[static_cast<std::uint32_t>(index) & (kBlockEdge - 1)];
  };
  return spread(cell.x()) | (spread(cell.y()) << 1) | (spread(cell.z()) << 2);
}
/// Offset of a position from the block's lowest cell on one axis: 0 to 7.
constexpr std::int32_t block_offset(BlockPosition position, std::uint32_t axis) {
  const BlockPosition bits = position >> axis;
  return static_cast<std::int32_t>((bits & 1) | ((bits >> 2) & 2) | ((bits >> 4) & 4));
}
/// The same on all axes.
inline Cell block_offset(BlockPosition position) {
  // Four bits for each axis.
  static constexpr auto kOffsets = [] {
    std::array<std::uint16_t, kBlockCells> offsets{};
    for (BlockPosition i = 0; i < kBlockCells; ++i) {
      offsets[i] = static_cast<std::uint16_t>(block_offset(i, 0) | block_offset(i, 1) << 4 |
                                              block_offset(i, 2) << 8);
    }
    return offsets;
  }();
  const std::int32_t offsets = kOffsets[position];
  return {offsets & 15, (offsets >> 4) & 15, offsets >> 8};
}
/// Lowest cell of the block that holds `cell`.
inline Cell block_origin(const Cell& cell) {
  return cell.unaryExpr([](std::int32_t index) { return index & ~(kBlockEdge - 1); });
}

/// A box of positions in a block: those at offsets of `low` to `high` from its lowest cell, both
/// inclusive and within 0 to 7 on each axis. Cheap when only some words of the mask are asked.
class CellsBetween {
 public:
  CellsBetween(const Cell& low, const Cell& high) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<int>(axis);
      below_low_[axis] = &kBelow[axis][static_cast<std::size_t>(low[at])];
      below_high_[axis] = &kBelow[axis][static_cast<std::size_t>(high[at]) + 1];
    }
  }

  /// A word of the mask.
  std::uint64_t word(std::size_t i) const {
    std::uint64_t word = ~std::uint64_t{0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      word &= below_high_[axis]->words()[i] & ~below_low_[axis]->words()[i];
    }
    return word;
  }
  CellMask mask() const {
    CellMask mask;
    for (std::size_t i = 0; i < mask.words().size(); ++i) mask.words()[i] = word(i);
    return mask;
  }

 private:
  // kBelow[axis][i]: the positions at offsets below i on that axis.
  static constexpr auto kBelow = [] {
    std::array<std::array<CellMask, kBlockEdge + 1>, 3> below{};
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      for (BlockPosition position = 0; position < kBlockCells; ++position) {
        const auto offset = static_cast<std::size_t>(block_offset(position, axis));
        for (std::size_t i = offset + 1; i <= kBlockEdge; ++i) below[axis][i].set(position);
      }
    }
    return below;
  }();

  std::array<const CellMask*, 3> below_low_;
  std::array<const CellMask*, 3> below_high_;
};

}  // namespace rmap
