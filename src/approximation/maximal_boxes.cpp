#include "approximation/maximal_boxes.hpp"

#include <algorithm>
#include <bit>

namespace rmap {

namespace {

Run run_on(const CellBox& box, int axis) { return {box.min[axis], box.max[axis] - 1}; }

// Which of many windows are worth a look, by their rank: all small ones, then fewer and fewer.
bool worth_a_look(std::size_t rank) {
  return rank <= 6 || std::has_single_bit(rank) || (rank % 3 == 0 && std::has_single_bit(rank / 3));
}

}  // namespace

void MaximalBoxes::Layer::intersect(const Layer& other) {
  const auto narrow = [](std::vector<Run>& mine, const std::vector<Run>& theirs) {
    mine.resize(std::min(mine.size(), theirs.size()));
    for (std::size_t i = 0; i < mine.size(); ++i) mine[i] = intersection(mine[i], theirs[i]);
  };
  narrow(up, other.up);
  narrow(down, other.down);
}

bool MaximalBoxes::Layer::within(const Layer& other) const {
  const auto inside = [](const std::vector<Run>& mine, const std::vector<Run>& theirs) {
    if (mine.size() > theirs.size()) return false;
    for (std::size_t i = 0; i < mine.size(); ++i) {
      if (!theirs[i].contains(mine[i])) return false;
    }
    return true;
  };
  return inside(up, other.up) && inside(down, other.down);
}

// Rows lie along the longest run through the core, layers are stacked along the shortest.
MaximalBoxes::Axes MaximalBoxes::axes_of(const CellBox& core) const {
  std::array<std::int32_t, 3> length;
  for (int axis = 0; axis < 3; ++axis) {
    const Run run = run_around(allowed_.rows(axis).row(core.min), core.min[axis]);
    length[static_cast<std::size_t>(axis)] = run.last - run.first;
  }
  const auto along =
      static_cast<int>(std::max_element(length.begin(), length.end()) - length.begin());
  int mid = (along + 1) % 3;
  int out = (along + 2) % 3;
  if (length[static_cast<std::size_t>(mid)] < length[static_cast<std::size_t>(out)]) {
    std::swap(mid, out);
  }
  return {along, mid, out};
}

// What the rows of one layer allow; false when it does not hold the core's footprint.
bool MaximalBoxes::read_layer(const CellBox& core, const Axes& axes, std::int32_t at,
                              Layer& layer) const {
  const BitRows& rows = allowed_.rows(axes.along);
  const std::ptrdiff_t stride = rows.stride(axes.mid);
  const Run core_run = run_on(core, axes.along);
  Cell first = core.min;
  first[axes.out] = at;
  const BitRows::Word* const lowest = rows.row(first);
  const auto common = [&](const BitRows::Word* row, Run& run) {
    if (((row[BitRows::word_of(core_run.first)] >> BitRows::bit_of(core_run.first)) & 1) == 0) {
      return false;
    }
    const Run here = run_around(row, core_run.first);
    if (here.last < core_run.last) return false;
    run = intersection(run, here);
    return true;
  };

  Run run{0, rows.size()[axes.along]};
  const BitRows::Word* row = lowest;
  for (std::int32_t m = core.min[axes.mid]; m < core.max[axes.mid]; ++m, row += stride) {
    if (!common(row, run)) return false;
  }
  layer.up.assign(1, run);
  layer.down.assign(1, run);
  for (Run next = run; common(row, next); row += stride) layer.up.push_back(next);
  row = lowest - stride;
  for (Run next = run; common(row, next); row -= stride) layer.down.push_back(next);
  return true;
}

void MaximalBoxes::visit_window(const CellBox& core, const Axes& axes, const Layer& layer,
                                CellBox box, FunctionRef<void(const CellBox&)> visit) const {
  const auto goes_on = [](const std::vector<Run>& runs, std::size_t i, const Run& run) {
    return i + 1 < runs.size() && runs[i + 1].contains(run);
  };
  for (std::size_t i = 0; i < layer.up.size(); ++i) {
    if (goes_on(layer.up, i, layer.up[i])) continue;
    for (std::size_t j = 0; j < layer.down.size(); ++j) {
      if (goes_on(layer.down, j, layer.down[j])) continue;
      const Run run = intersection(layer.up[i], layer.down[j]);
      if (goes_on(layer.up, i, run) || goes_on(layer.down, j, run)) continue;
      box.min[axes.along] = run.first;
      box.max[axes.along] = run.last + 1;
      box.min[axes.mid] = core.min[axes.mid] - static_cast<std::int32_t>(j);
      box.max[axes.mid] = core.max[axes.mid] + static_cast<std::int32_t>(i);
      visit(box);
    }
  }
}

// The windows of layers from `lowest` on, whose common rows are in bottom_, to one above the core.
void MaximalBoxes::visit_windows_above(const CellBox& core, const Axes& axes, std::int32_t lowest,
                                       FunctionRef<void(const CellBox&)> visit) {
  window_ = bottom_;
  CellBox box = core;
  box.min[axes.out] = lowest;
  std::size_t rank = 0;
  for (std::size_t b = 0; b <= above_count_; ++b) {
    if (b > 0) window_.intersect(above_[b - 1]);
    const bool last = b == above_count_;
    if (!last && window_.within(above_[b])) continue;  // one more layer costs nothing
    if (!last && !worth_a_look(rank++)) continue;
    box.max[axes.out] = core.max[axes.out] + static_cast<std::int32_t>(b);
    visit_window(core, axes, window_, box, visit);
  }
}

void MaximalBoxes::for_each(const CellBox& core, FunctionRef<void(const CellBox&)> visit) {
  const Axes axes = axes_of(core);
  const auto read_from = [&](std::int32_t at, std::int32_t step, std::vector<Layer>& layers) {
    std::size_t count = 0;
    for (;; ++count, at += step) {
      if (layers.size() == count) layers.emplace_back();
      if (!read_layer(core, axes, at, layers[count])) return count;
    }
  };
  above_count_ = read_from(core.max[axes.out], 1, above_);
  below_count_ = read_from(core.min[axes.out] - 1, -1, below_);

  read_layer(core, axes, core.min[axes.out], bottom_);
  for (std::int32_t at = core.min[axes.out] + 1; at < core.max[axes.out]; ++at) {
    read_layer(core, axes, at, window_);
    bottom_.intersect(window_);
  }
  std::size_t rank = 0;
  for (std::size_t a = 0; a <= below_count_; ++a) {
    if (a > 0) bottom_.intersect(below_[a - 1]);
    const bool last = a == below_count_;
    if (!last && bottom_.within(below_[a])) continue;
    if (!last && !worth_a_look(rank++)) continue;
    visit_windows_above(core, axes, core.min[axes.out] - static_cast<std::int32_t>(a), visit);
  }
}

CellBox MaximalBoxes::grown(CellBox box) const {
  for (int axis = 0; axis < 3; ++axis) {
    CellBox slab = box;
    const auto holds_at = [&](std::int32_t at) {
      slab.min[axis] = at;
      slab.max[axis] = at + 1;
      return allowed_.holds(slab);
    };
    while (holds_at(box.max[axis])) ++box.max[axis];
    while (holds_at(box.min[axis] - 1)) --box.min[axis];
  }
  return box;
}

}  // namespace rmap
