#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include <rmap/leaf.hpp>

namespace rmap {

/// A set of places in a tile.
template <std::size_t kSize>
class TileMask {
 public:
  void clear() { words_ = {}; }
  void set(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  bool test(std::size_t i) const { return ((words_[i / 64] >> (i % 64)) & 1) != 0; }
  /// The bits of `group` go to the places from `first` on, all in one word.
  void set_group(std::size_t first, std::uint64_t group) {
    words_[first / 64] |= group << (first % 64);
  }
  std::size_t count() const {
    std::size_t count = 0;
    for (const std::uint64_t word : words_) count += bit_count(word);
    return count;
  }
  /// use(i) for each place of the set, ascending.
  template <class Use>
  void for_each(Use&& use) const {
    for (std::size_t word = 0; word < words_.size(); ++word) {
      for (std::uint64_t left = words_[word]; left != 0; left &= left - 1) {
        use(word * 64 + static_cast<std::size_t>(std::countr_zero(left)));
      }
    }
  }
  /// The places of the set but those that follow one of the set and are not in `changed`.
  TileMask run_starts(const TileMask& changed) const {
    TileMask starts;
    std::uint64_t before = 0;
    for (std::size_t word = 0; word < words_.size(); ++word) {
      const std::uint64_t follows = words_[word] << 1 | before;
      starts.words_[word] = words_[word] & (changed.words_[word] | ~follows);
      before = words_[word] >> 63;
    }
    return starts;
  }
  /// The first `count` places that are not in the set.
  TileMask missing(std::size_t count) const {
    TileMask rest;
    for (std::size_t word = 0; 64 * word < count; ++word) {
      const std::size_t left = count - 64 * word;
      rest.words_[word] =
          ~words_[word] & (left < 64 ? (std::uint64_t{1} << left) - 1 : ~std::uint64_t{0});
    }
    return rest;
  }

 private:
  std::array<std::uint64_t, kSize / 64> words_{};
};

/// What of its points a tile is asked for, beside their cells: each step up costs time.
enum class TileDetail : std::uint8_t {
  cells,
  directions,  ///< and the mask `beams`
  ends,        ///< and the directions
};

/// Some points of a scan on their way into the map, in cell units: few enough to
/// stay in the nearest cache from one step to the next.
struct PointTile {
  static constexpr std::size_t kSize = 256;
  using Mask = TileMask<kSize>;

  std::size_t count = 0;
  /// Number of each point in the scan, when they do not follow one another from `first` on.
  std::span<const std::uint32_t> numbers;
  std::size_t first = 0;
  std::uint32_t number(std::size_t i) const {
    return numbers.empty() ? static_cast<std::uint32_t>(first + i) : numbers[i];
  }

  Mask ends;   ///< points that end in a cell
  Mask beams;  ///< points that have a beam with a direction, cut ones too; for cells alone, none
  Mask cuts;   ///< points whose beam is cut: it goes on beyond its end
  /// Whether a cut beam has no direction: it crosses the cell of its origin alone.
  bool cut_at_origin = false;

  alignas(64) std::array<std::array<double, kSize>, 3> end;
  alignas(64) std::array<std::array<std::int32_t, kSize>, 3> cell;  ///< of the end
  alignas(64) std::array<std::array<float, kSize>, 3> direction;    ///< of the beam

  Cell cell_of(std::size_t i) const { return {cell[0][i], cell[1][i], cell[2][i]}; }
  Eigen::Vector3d end_of(std::size_t i) const { return {end[0][i], end[1][i], end[2][i]}; }
};

}  // namespace rmap
