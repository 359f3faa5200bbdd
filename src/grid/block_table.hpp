#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <rmap/cell.hpp>

namespace rmap {

/// Which block lies where: the numbers of blocks by their origins, for who asks for one block.
/// The R-tree, which answers all that is asked of a region, would take two to four times as
/// long. The origins are kept by the owner: origin_of(number) tells them.
///
/// A slot takes 4 bytes: the number in as few low bits as there are slots, and above them bits
/// of the origin's hash, which tell most other blocks without looking at them. Four slots make
/// a bucket that is looked at as a whole, since nothing foretells which of them are taken; what
/// finds its bucket full goes to the next one. Three of four slots are taken at the most, so a
/// block costs 5 to 11 bytes.
class BlockTable {
 public:
  BlockTable() : slots_(std::size_t{1} << bits_, kFree) {}

  /// The number of the block at `origin`, if there is one.
  template <class OriginOf>
  std::optional<std::uint32_t> find(const Cell& origin, const OriginOf& origin_of) const {
    const std::uint32_t hash = hash_of(origin);
    const std::uint32_t tag = tag_of(hash);
    for (std::size_t bucket = home_of(hash);; bucket = next(bucket)) {
      const std::uint32_t* const slots = slots_.data() + bucket * kBucket;
      // With the same tag what is left is the number and 1; a free slot leaves 0 or a tag.
      unsigned alike = 0;
      for (std::size_t i = 0; i < kBucket; ++i) {
        alike |= unsigned{(slots[i] ^ tag) - 1 < number_bits()} << i;
      }
      for (; alike != 0; alike &= alike - 1) {
        const std::uint32_t number = (slots[std::countr_zero(alike)] ^ tag) - 1;
        if (origin_of(number) == origin) return number;
      }
      if (slots[kBucket - 1] == kFree) return std::nullopt;
    }
  }

  /// Enters a block that is not there. Numbers are below the greatest count that there ever was.
  template <class OriginOf>
  void add(const Cell& origin, std::uint32_t number, const OriginOf& origin_of) {
    if (4 * (size_ + 1) > 3 * slots_.size()) grow(origin_of);
    ++size_;
    enter(hash_of(origin), number);
  }

  /// Takes out the block at `origin`, which is there.
  template <class OriginOf>
  void remove(const Cell& origin, const OriginOf& origin_of) {
    std::size_t slot = home_of(hash_of(origin)) * kBucket;
    while (origin_of(number_in(slot)) != origin) slot = (slot + 1) & (slots_.size() - 1);
    std::size_t bucket = slot / kBucket;
    bool was_full = take(slot);
    // A full bucket sent blocks on: one of them comes back into the gap, if there is one.
    for (std::size_t other = next(bucket); was_full; other = next(other)) {
      const bool is_full = slots_[other * kBucket + kBucket - 1] != kFree;
      for (std::size_t i = other * kBucket; i < (other + 1) * kBucket && slots_[i] != kFree; ++i) {
        const std::uint32_t hash = hash_of(origin_of(number_in(i)));
        if (distance(home_of(hash), other) < distance(bucket, other)) continue;
        slots_[bucket * kBucket + kBucket - 1] = slots_[i];
        take(i);
        bucket = other;
        break;
      }
      was_full = is_full;
    }
    --size_;
  }

  std::size_t size() const { return size_; }
  std::size_t bytes_in_use() const { return slots_.capacity() * sizeof(slots_[0]); }

 private:
  static constexpr std::uint32_t kFree = 0;
  static constexpr std::size_t kBucket = 4;  ///< slots; those taken come first

  static std::uint32_t hash_of(const Cell& origin) {
    const auto index = [&](int axis) {
      return static_cast<std::uint64_t>(static_cast<std::uint32_t>(origin[axis]));
    };
    std::uint64_t hash = index(0) * 0x9E3779B97F4A7C15U + index(1) * 0xC2B2AE3D27D4EB4FU +
                         index(2) * 0x165667B19E3779F9U;
    hash = (hash ^ (hash >> 32)) * 0x9FB21C651E98DF25U;
    return static_cast<std::uint32_t>(hash >> 32);
  }
  std::size_t home_of(std::uint32_t hash) const { return (hash >> (32 - bits_)) / kBucket; }
  std::uint32_t tag_of(std::uint32_t hash) const { return hash << bits_; }
  std::uint32_t number_bits() const { return (std::uint32_t{1} << bits_) - 1; }
  std::uint32_t number_in(std::size_t slot) const { return (slots_[slot] & number_bits()) - 1; }
  std::size_t next(std::size_t bucket) const {
    return (bucket + 1) & (slots_.size() / kBucket - 1);
  }
  /// Buckets from one to another.
  std::size_t distance(std::size_t from, std::size_t to) const {
    return (to - from) & (slots_.size() / kBucket - 1);
  }

  /// Empties a slot, the last of its bucket taking its place; returns whether that was full.
  bool take(std::size_t slot);
  void enter(std::uint32_t hash, std::uint32_t number);
  template <class OriginOf>
  void grow(const OriginOf& origin_of);
  /// Empty, with twice the slots; returns what they were.
  std::vector<std::uint32_t> doubled();

  int bits_ = 6;  ///< binary logarithm of the number of slots
  std::size_t size_ = 0;
  std::vector<std::uint32_t> slots_;  ///< 1 + number below the tag
};

template <class OriginOf>
void BlockTable::grow(const OriginOf& origin_of) {
  const std::uint32_t old_number_bits = number_bits();
  for (const std::uint32_t slot : doubled()) {
    if (slot == kFree) continue;
    const std::uint32_t number = (slot & old_number_bits) - 1;
    enter(hash_of(origin_of(number)), number);
  }
}

}  // namespace rmap
