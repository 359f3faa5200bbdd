#include "approximation/cover.hpp"

#include "approximation/cell_boxes.hpp"
#include "approximation/cover_registry.hpp"
#include "approximation/maximal_boxes.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <random>

namespace rmap {

namespace {

class Cover {
 public:
  Cover(const BitGrid& allowed, BitGrid& uncovered, int inner)
      : maximal_(allowed), uncovered_(uncovered), inner_(inner), registry_(uncovered.rows(0)) {}

  void seed(std::span<const CellBox> first);
  void drop_idle();
  void reshape();
  std::vector<CellBox> boxes() const;

 private:
  CellBox covered(const CellBox& box) const { return inner_ == 0 ? box : grown_by(box, inner_); }
  CellBox best_from(const Cell& seed);
  /// What a box must hold to cover the cells in `own`, as `box` does.
  CellBox core(const CellBox& own, const CellBox& box) const;
  void drop(std::uint32_t box);
  void reshape(std::uint32_t box);
  CellBox least_needed(const CellBox& core);

  MaximalBoxes maximal_;
  BitGrid& uncovered_;
  int inner_;
  CoverRegistry registry_;
  std::vector<CellBox> boxes_;  // those that were dropped are empty
  std::vector<bool> rigid_;
  std::vector<CellBox> candidates_;
  std::vector<std::uint32_t> idle_;
  std::mt19937 random_;
};

CellBox Cover::best_from(const Cell& seed) {
  CellBox best = box_of(seed);
  std::int64_t most = 0;
  std::int64_t best_volume = 0;
  maximal_.for_each(box_of(seed), [&](const CellBox& box) {
    const std::int64_t volume = volume_of(box);
    if (inner_ == 0 && (volume < most || (volume == most && volume <= best_volume))) return;
    const std::int64_t gain = uncovered_.count(covered(box));
    if (gain > most || (gain == most && volume > best_volume)) {
      most = gain;
      best = box;
      best_volume = volume;
    }
  });
  return maximal_.grown(best);
}

void Cover::seed(std::span<const CellBox> first) {
  for (const CellBox& box : first) {
    boxes_.push_back(box);
    uncovered_.reset(covered(box));
  }
  BitRows& rows = uncovered_.rows(0);
  for (std::int32_t z = 0; z < rows.size().z(); ++z) {
    for (std::int32_t y = 0; y < rows.size().y(); ++y) {
      const BitRows::Word* const row = rows.row({0, y, z});
      for (std::ptrdiff_t word = 0; word < rows.words_in_row(); ++word) {
        while (row[word] != 0) {
          const auto x = static_cast<std::int32_t>(word * 64 + std::countr_zero(row[word]));
          boxes_.push_back(best_from({x, y, z}));
          uncovered_.reset(covered(boxes_.back()));
        }
      }
    }
  }
  rigid_.assign(boxes_.size(), false);
  registry_.resize(boxes_.size());
  for (std::uint32_t box = 0; box < boxes_.size(); ++box) registry_.add(box, covered(boxes_[box]));
}

void Cover::drop(std::uint32_t box) {
  registry_.remove(box, covered(boxes_[box]));
  boxes_[box] = {};
}

void Cover::drop_idle() {
  std::vector<std::uint32_t> idle;
  for (std::uint32_t box = 0; box < boxes_.size(); ++box) {
    if (registry_.sole(box) == 0) idle.push_back(box);
  }
  std::stable_sort(idle.begin(), idle.end(), [&](std::uint32_t a, std::uint32_t b) {
    return volume_of(boxes_[a]) < volume_of(boxes_[b]);
  });
  for (const std::uint32_t box : idle) {
    if (registry_.sole(box) == 0) drop(box);
  }
}

void Cover::reshape() {
  const auto count = static_cast<std::uint32_t>(boxes_.size());
  for (std::uint32_t box = 0; box < count; ++box) reshape(box);
  for (std::uint32_t box = count; box-- > 0;) reshape(box);
}

CellBox Cover::core(const CellBox& own, const CellBox& box) const {
  if (inner_ == 0) return own;
  CellBox core;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t low = std::min(own.min[axis] + inner_, box.max[axis] - 1);
    const std::int32_t high = std::max(own.max[axis] - 1 - inner_, box.min[axis]);
    // Where every place between the two would do, the one in the middle.
    const std::int32_t middle = high + (low - high) / 2;
    core.min[axis] = low > high ? middle : low;
    core.max[axis] = (low > high ? middle : high) + 1;
  }
  return core;
}

// Of boxes that hold the core, the one that takes most from boxes that have least of their own.
CellBox Cover::least_needed(const CellBox& core) {
  constexpr std::size_t kMost = 32;
  candidates_.clear();
  maximal_.for_each(core, [&](const CellBox& box) { candidates_.push_back(box); });
  if (candidates_.size() > kMost) {
    for (std::size_t i = 0; i < kMost; ++i) {
      std::swap(candidates_[i], candidates_[i + random_() % (candidates_.size() - i)]);
    }
    candidates_.resize(kMost);
  }
  CellBox best;
  double most = -1;
  std::uint32_t equal = 0;
  for (const CellBox& box : candidates_) {
    const double relief = registry_.relief(covered(box));
    equal = relief == most ? equal + 1 : 1;
    if (relief > most || (relief == most && random_() % equal == 0)) best = box;
    most = std::max(most, relief);
  }
  return best;
}

void Cover::reshape(std::uint32_t box) {
  if (rigid_[box] || boxes_[box].empty()) return;
  if (registry_.sole(box) == 0) return drop(box);
  const CellBox own = core(registry_.sole_bounds(box, covered(boxes_[box])), boxes_[box]);
  if (own == boxes_[box]) {
    rigid_[box] = true;
    return;
  }
  registry_.remove(box, covered(boxes_[box]));
  boxes_[box] = least_needed(own);
  idle_.clear();
  registry_.add(box, covered(boxes_[box]), idle_);
  for (const std::uint32_t other : idle_) {
    if (!boxes_[other].empty() && registry_.sole(other) == 0) drop(other);
  }
}

std::vector<CellBox> Cover::boxes() const {
  std::vector<CellBox> boxes;
  std::copy_if(boxes_.begin(), boxes_.end(), std::back_inserter(boxes),
               [](const CellBox& box) { return !box.empty(); });
  return boxes;
}

}  // namespace

std::vector<CellBox> cover(const BitGrid& allowed, BitGrid& required, const CoverLimits& limits,
                           std::span<const CellBox> first) {
  Cover cover(allowed, required, limits.inner);
  cover.seed(first);
  cover.drop_idle();
  if (limits.reshape) cover.reshape();
  return cover.boxes();
}

}  // namespace rmap
