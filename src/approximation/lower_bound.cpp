#include "approximation/cell_blocks.hpp"
#include "approximation/dense_region.hpp"
#include "approximation/star.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <fmt/format.h>

#include <rmap/approximate.hpp>
#include <rmap/cuboid_bound.hpp>
#include <rmap/error.hpp>

namespace rmap {

namespace {

/// A set of cells none of which is in the star of another, as large as can be made.
class IndependentCells {
 public:
  IndependentCells(Stars& stars, std::uint64_t seed)
      : stars_(stars),
        chosen_near_(stars.cell_count(), 0),
        place_(stars.cell_count(), kNone),
        random_(seed) {}

  /// Takes cells with the smallest stars first, which hinder others least.
  void choose_greedily();
  /// Tries to put two cells in the place of a random one; else moves that one.
  void improve();

  const std::vector<std::uint32_t>& chosen() const { return chosen_; }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::uint32_t star_size(std::uint32_t cell);
  void choose(std::uint32_t cell);
  void leave(std::uint32_t cell);

  Stars& stars_;
  std::vector<std::uint32_t> chosen_;
  std::vector<std::uint32_t> chosen_near_;  // by cell: how many chosen ones its star holds
  std::vector<std::uint32_t> place_;        // by cell: where it stands in chosen_
  std::vector<std::uint32_t> freed_;
  std::mt19937_64 random_;
};

std::uint32_t IndependentCells::star_size(std::uint32_t cell) {
  std::uint32_t size = 0;
  stars_.for_each(cell, [&](std::uint32_t, std::uint32_t count) { size += count; });
  return size;
}

void IndependentCells::choose(std::uint32_t cell) {
  place_[cell] = static_cast<std::uint32_t>(chosen_.size());
  chosen_.push_back(cell);
  stars_.for_each(cell, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t other = first; other < first + count; ++other) ++chosen_near_[other];
  });
}

void IndependentCells::leave(std::uint32_t cell) {
  chosen_[place_[cell]] = chosen_.back();
  place_[chosen_.back()] = place_[cell];
  place_[cell] = kNone;
  chosen_.pop_back();
  stars_.for_each(cell, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t other = first; other < first + count; ++other) --chosen_near_[other];
  });
}

void IndependentCells::choose_greedily() {
  std::vector<std::uint32_t> sizes(stars_.cell_count());
  for (std::uint32_t cell = 0; cell < sizes.size(); ++cell) sizes[cell] = star_size(cell);
  std::vector<std::uint32_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return sizes[a] < sizes[b]; });
  for (const std::uint32_t cell : order) {
    if (chosen_near_[cell] == 0) choose(cell);
  }
}

void IndependentCells::improve() {
  const std::uint32_t old = chosen_[random_() % chosen_.size()];
  // Cells that only `old` keeps from being chosen.
  freed_.clear();
  stars_.for_each(old, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t cell = first; cell < first + count; ++cell) {
      if (chosen_near_[cell] == 1 && cell != old) freed_.push_back(cell);
    }
  });
  if (freed_.empty()) return;
  const std::uint32_t instead = freed_[random_() % freed_.size()];
  leave(old);
  choose(instead);
  for (const std::uint32_t cell : freed_) {
    if (chosen_near_[cell] == 0) choose(cell);
  }
}

}  // namespace

CuboidBound lower_bound(std::span<const CountedCell> cells, const CuboidBoundOptions& options) {
  // Checked by the rules of the approximation that this is a bound of.
  approximate({}, {.outer = options.outer});
  constexpr double kMostSteps = 1e6;
  if (!(options.steps_per_cell >= 0 && options.steps_per_cell <= kMostSteps)) {
    throw Error(ErrorKind::input, fmt::format("steps_per_cell is {}: it must lie between 0 and {}",
                                              options.steps_per_cell, kMostSteps));
  }
  const CellBlocks blocks(cells);
  if (blocks.size() == 0) return {};
  constexpr double kMostPlaces = 1LL << 33;
  if (blocks.bounds().volume() > kMostPlaces) {
    throw Error(ErrorKind::limit,
                "the lower bound needs a bit for each place in the box of the cells, of which "
                "there may be 2^33 at most: take a part of them");
  }
  std::vector<Cell> places;
  blocks.for_each(blocks.bounds(), [&](const Cell& cell, std::size_t) { places.push_back(cell); });
  const DenseRegion dense(places, blocks.bounds(), {.outer = options.outer});
  BitRows own(dense.allowed().size(), 0);
  for (const Cell& cell : places) own.set(dense.to_local(cell));
  Stars stars(dense.allowed(), own);
  IndependentCells independent(stars, options.seed);
  independent.choose_greedily();
  const auto steps = static_cast<std::uint64_t>(
      std::ceil(options.steps_per_cell * static_cast<double>(blocks.size())));
  for (std::uint64_t step = 0; step < steps; ++step) independent.improve();

  CuboidBound bound;
  for (const std::uint32_t cell : independent.chosen()) {
    bound.independent.push_back(dense.to_map(box_of(stars.place(cell))).min);
  }
  return bound;
}

bool verify(const CuboidBound& bound, std::span<const CountedCell> cells, int outer) {
  const CellBlocks occupied(cells);
  const CellBlocks allowed = occupied.dilated(outer);
  std::vector<CountedCell> chosen;
  for (const Cell& cell : bound.independent) {
    if (!occupied.contains(cell)) return false;
    chosen.push_back({cell, 1});
  }
  const CellBlocks independent(chosen);
  if (independent.size() != chosen.size()) return false;  // one stands twice
  for (const Cell& cell : bound.independent) {
    // A box with the cell in it goes no further on an axis than allowed cells beside it do.
    CellBox reach = box_of(cell);
    for (int axis = 0; axis < 3; ++axis) {
      Cell next = cell;
      for (++next[axis]; allowed.contains(next); ++next[axis]) ++reach.max[axis];
      next = cell;
      for (--next[axis]; allowed.contains(next); --next[axis]) --reach.min[axis];
    }
    bool alone = true;
    independent.for_each(reach, [&](const Cell& other, std::size_t) {
      alone &= other == cell || !allowed.holds(united(box_of(cell), box_of(other)));
    });
    if (!alone) return false;
  }
  return true;
}

}  // namespace rmap
