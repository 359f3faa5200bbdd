#include "rtree/split.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rmap {

namespace {

constexpr double kLowest = -std::numeric_limits<double>::infinity();

/// One number for each box.
using Column = std::array<double, kMaxBranches + 1>;

double volume_of(const CellBox& box) {
  const Eigen::Array3d edges = box.max.cast<double>() - box.min.cast<double>();
  return (edges.x() * edges.y()) * edges.z();
}

/// The boxes by columns, so that compilers find vectors in loops over them.
class BoxColumns {
 public:
  explicit BoxColumns(std::span<const CellBox> boxes) : count_(boxes.size()) {
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low_[axis][i] = boxes[i].min[static_cast<Eigen::Index>(axis)];
        high_[axis][i] = boxes[i].max[static_cast<Eigen::Index>(axis)];
      }
    }
  }
  /// The volumes of the smallest boxes that hold `box` and each one from `first` on.
  void united_volumes(const CellBox& box, std::size_t first, Column& volumes) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double low = box.min[static_cast<Eigen::Index>(axis)];
      const double high = box.max[static_cast<Eigen::Index>(axis)];
      const Column& lows = low_[axis];
      const Column& highs = high_[axis];
      for (std::size_t i = first; i < count_; ++i) {
        const double from = lows[i] < low ? lows[i] : low;
        const double to = highs[i] > high ? highs[i] : high;
        volumes[i] = axis == 0 ? to - from : volumes[i] * (to - from);
      }
    }
  }

 private:
  std::size_t count_;
  std::array<Column, 3> low_;
  std::array<Column, 3> high_;
};

struct Seeds {
  std::size_t first;
  std::size_t second;
};

/// The pair that would waste most volume if one node held both (Guttman's PickSeeds).
Seeds most_wasteful(std::span<const CellBox> boxes, const BoxColumns& columns) {
  Seeds seeds{0, 1};
  double most = kLowest;
  Column volumes;
  for (std::size_t i = 0; i < boxes.size(); ++i) volumes[i] = volume_of(boxes[i]);
  for (std::size_t i = 0; i + 1 < boxes.size(); ++i) {
    Column with_i;
    columns.united_volumes(boxes[i], i + 1, with_i);
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const double waste = (with_i[j] - volumes[i]) - volumes[j];
      if (waste > most) {
        most = waste;
        seeds = {i, j};
      }
    }
  }
  return seeds;
}

/// The pair with the widest gap on one axis, in widths of the whole set on it
/// (Guttman's LinearPickSeeds). Without gaps it is the pair that overlaps least.
Seeds farthest_apart(std::span<const CellBox> boxes) {
  Seeds seeds{0, 1};
  double most = kLowest;
  for (int axis = 0; axis < 3; ++axis) {
    std::size_t upper = 0;  // the box with the highest low side
    for (std::size_t i = 1; i < boxes.size(); ++i) {
      if (boxes[i].min[axis] > boxes[upper].min[axis]) upper = i;
    }
    std::size_t lower = upper == 0 ? 1 : 0;  // of the others, that with the lowest high side
    double low = boxes[upper].min[axis];
    double high = boxes[upper].max[axis];
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (i != upper && boxes[i].max[axis] < boxes[lower].max[axis]) lower = i;
      low = std::min<double>(low, boxes[i].min[axis]);
      high = std::max<double>(high, boxes[i].max[axis]);
    }
    const double gap =
        static_cast<double>(boxes[upper].min[axis]) - static_cast<double>(boxes[lower].max[axis]);
    const double separation = gap / (high - low);
    if (separation > most) {
      most = separation;
      seeds = {std::min(lower, upper), std::max(lower, upper)};
    }
  }
  return seeds;
}

/// Gives the boxes to the two groups one by one, after the seeds.
class Distribution {
 public:
  Distribution(std::span<const CellBox> boxes, const BoxColumns& columns, Seeds seeds)
      : boxes_(boxes), columns_(columns) {
    groups_[0] = {boxes[seeds.first], volume_of(boxes[seeds.first]), 1};
    groups_[1] = {boxes[seeds.second], volume_of(boxes[seeds.second]), 1};
    partition_[seeds.second] = true;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (i == seeds.first || i == seeds.second) continue;
      left_[left_count_++] = i;
    }
    measure(0);
    measure(1);
  }

  bool done() const { return left_count_ == 0; }
  const Partition& partition() const { return partition_; }

  /// The group that can reach `min_branches` only with all that is left, or -1.
  int starving(int min_branches) const {
    for (const int group : {0, 1}) {
      if (at(group).count + static_cast<int>(left_count_) <= min_branches) return group;
    }
    return -1;
  }
  void give_all(int group) {
    for (std::size_t i = 0; i < left_count_; ++i) {
      partition_[left_[i]] = group == 1;
    }
    left_count_ = 0;
  }

  /// Position among those left of the box that prefers one group most (Guttman's PickNext).
  std::size_t most_decided() const {
    std::size_t best = 0;
    double most = kLowest;
    for (std::size_t position = 0; position < left_count_; ++position) {
      const std::size_t box = left_[position];
      const double preference = std::abs(enlargement_[0][box] - enlargement_[1][box]);
      if (preference > most) {
        most = preference;
        best = position;
      }
    }
    return best;
  }

  /// Gives the box to the group that it enlarges less; ties: the smaller, then the one with fewer.
  void give(std::size_t position) {
    const std::size_t box = left_[position];
    const int group = preferred(box);
    partition_[box] = group == 1;
    Group& chosen = groups_[static_cast<std::size_t>(group)];
    chosen.bounds = united(chosen.bounds, boxes_[box]);
    chosen.volume = volume_of(chosen.bounds);
    ++chosen.count;
    std::copy(left_.begin() + static_cast<std::ptrdiff_t>(position) + 1,
              left_.begin() + static_cast<std::ptrdiff_t>(left_count_),
              left_.begin() + static_cast<std::ptrdiff_t>(position));
    --left_count_;
    measure(group);
  }

 private:
  struct Group {
    CellBox bounds;
    double volume = 0;
    int count = 0;
  };

  const Group& at(int group) const { return groups_[static_cast<std::size_t>(group)]; }
  /// How much the group would grow to hold each box.
  void measure(int group) {
    Column& enlargement = enlargement_[static_cast<std::size_t>(group)];
    columns_.united_volumes(at(group).bounds, 0, enlargement);
    for (std::size_t i = 0; i < boxes_.size(); ++i) enlargement[i] -= at(group).volume;
  }
  int preferred(std::size_t box) const {
    const double first = enlargement_[0][box];
    const double second = enlargement_[1][box];
    if (first != second) return first < second ? 0 : 1;
    if (at(0).volume != at(1).volume) return at(0).volume < at(1).volume ? 0 : 1;
    return at(0).count <= at(1).count ? 0 : 1;
  }

  std::span<const CellBox> boxes_;
  const BoxColumns& columns_;
  std::array<Group, 2> groups_;
  std::array<Column, 2> enlargement_;  // by group and box
  std::array<std::size_t, kMaxBranches + 1> left_;
  std::size_t left_count_ = 0;
  Partition partition_{};
};

}  // namespace

Partition partition(std::span<const CellBox> boxes, int min_branches, Split split) {
  assert(boxes.size() >= 2 && boxes.size() <= kMaxBranches + 1);
  assert(boxes.size() >= 2 * static_cast<std::size_t>(min_branches));
  const bool quadratic = split == Split::quadratic;
  const BoxColumns columns(boxes);
  Distribution distribution(boxes, columns,
                            quadratic ? most_wasteful(boxes, columns) : farthest_apart(boxes));
  while (!distribution.done()) {
    const int starving = distribution.starving(min_branches);
    if (starving >= 0) {
      distribution.give_all(starving);
    } else {
      distribution.give(quadratic ? distribution.most_decided() : 0);
    }
  }
  return distribution.partition();
}

}  // namespace rmap
