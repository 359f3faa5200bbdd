#include "approximation/runs.hpp"

#include <tuple>

namespace rmap {

namespace {

/// Joins boxes that touch on `axis` and are equal on the axes before it. They come sorted by the
/// axes behind `axis`, then `axis`, then those before, the fastest last.
class Joiner {
 public:
  explicit Joiner(int axis) : axis_(axis) {}

  void add(const CellBox& box) {
    if (!same_slice(box)) begin_slice(box);
    // Boxes of the slice before that come earlier have no partner any more.
    while (next_ < before_.size() && order(before_[next_]) < order(box)) ++next_;
    if (next_ < before_.size() && order(before_[next_]) == order(box)) {
      CellBox& grown = joined_[open_[next_]];
      grown.max[axis_] = box.max[axis_];
      open_here_.push_back(open_[next_++]);
    } else {
      open_here_.push_back(joined_.size());
      joined_.push_back(box);
    }
    here_.push_back(box);
  }

  std::vector<CellBox> joined() && { return std::move(joined_); }

 private:
  using Order = std::tuple<std::int32_t, std::int32_t, std::int32_t, std::int32_t>;

  // By the axes before axis_ alone.
  Order order(const CellBox& box) const {
    if (axis_ == 1) return {box.min.x(), box.max.x(), 0, 0};
    return {box.min.y(), box.min.x(), box.max.x(), box.max.y()};
  }
  bool same_slice(const CellBox& box) const {
    return !here_.empty() && here_.front().min[axis_] == box.min[axis_] &&
           (axis_ == 2 || here_.front().min.z() == box.min.z());
  }
  void begin_slice(const CellBox& box) {
    const bool next_to = !here_.empty() && here_.front().min[axis_] + 1 == box.min[axis_] &&
                         (axis_ == 2 || here_.front().min.z() == box.min.z());
    before_.swap(here_);
    open_.swap(open_here_);
    if (!next_to) before_.clear();
    here_.clear();
    open_here_.clear();
    next_ = 0;
  }

  int axis_;
  std::vector<CellBox> joined_;
  std::vector<CellBox> before_, here_;         // boxes of the slice before and of this one
  std::vector<std::size_t> open_, open_here_;  // which joined box each has become part of
  std::size_t next_ = 0;                       // first of the slice before that may be a partner
};

std::vector<CellBox> rows_of(std::span<const CountedCell> cells) {
  std::vector<CellBox> rows;
  for (const CountedCell& counted : cells) {
    const Cell& cell = counted.cell;
    if (!rows.empty() && rows.back().max.x() == cell.x() && rows.back().min.y() == cell.y() &&
        rows.back().min.z() == cell.z()) {
      ++rows.back().max.x();
    } else {
      rows.push_back(box_of(cell));
    }
  }
  return rows;
}

}  // namespace

std::vector<CellBox> run_boxes(std::span<const CountedCell> cells) {
  Joiner rectangles(1);
  for (const CellBox& row : rows_of(cells)) rectangles.add(row);
  std::vector<CellBox> flat = std::move(rectangles).joined();
  // Rectangles stand in the order in which they began: by z, then y, then x.
  Joiner boxes(2);
  for (const CellBox& rectangle : flat) boxes.add(rectangle);
  return std::move(boxes).joined();
}

}  // namespace rmap
