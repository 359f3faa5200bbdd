#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <rmap/cell.hpp>

namespace rmap {

/// Cells of a box as numbers that sort as the cells do, by z, then y, then x, with no more bits
/// than the box needs.
class CellKeys {
 public:
  /// Nothing when 64 bits are not enough. `box` holds a cell at least.
  static std::optional<CellKeys> of(const CellBox& box);

  std::uint64_t key(const Cell& cell) const {
    const auto index = [&](int axis) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[axis]) - min_[axis]);
    };
    return index(2) << shift_z_ | index(1) << shift_y_ | index(0);
  }
  Cell cell(std::uint64_t key) const {
    const auto index = [](std::uint64_t bits, std::int32_t min) {
      return static_cast<std::int32_t>(static_cast<std::int64_t>(bits) + min);
    };
    return {index(key & ((std::uint64_t{1} << shift_y_) - 1), min_.x()),
            index(key >> shift_y_ & ((std::uint64_t{1} << (shift_z_ - shift_y_)) - 1), min_.y()),
            index(key >> shift_z_, min_.z())};
  }
  /// Of a key; the others are 0.
  int bits() const { return bits_; }

 private:
  Cell min_ = Cell::Zero();
  int shift_y_ = 0;
  int shift_z_ = 0;
  int bits_ = 0;
};

/// Sorts numbers of which the lowest `bits` alone are not 0. Cost: some 1.5 ns a number for
/// every 11 bits. `spare` is memory to work in.
void sort_keys(std::vector<std::uint64_t>& keys, int bits, std::vector<std::uint64_t>& spare);

}  // namespace rmap
