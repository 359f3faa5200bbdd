#include "approximation/midpoint.hpp"

#include <algorithm>

namespace rmap {

namespace {

class Midpoint {
 public:
  Midpoint(double fill, std::uint64_t smallest)
      : fill_(fill), smallest_(static_cast<double>(smallest)) {}

  void approximate(std::span<Cell> cells) {
    CellBox box = box_of(cells.front());
    for (const Cell& cell : cells) box = united(box, box_of(cell));
    const double volume = box.volume();
    if (static_cast<double>(cells.size()) >= fill_ * volume || volume <= smallest_) {
      boxes_.push_back(box);
      return;
    }
    int axis = 0;
    const std::int64_t longest = box.extent().maxCoeff(&axis);
    const auto middle = static_cast<std::int32_t>(box.min[axis] + longest / 2);
    const auto upper = std::partition(cells.begin(), cells.end(),
                                      [&](const Cell& cell) { return cell[axis] < middle; });
    const auto lower_count = static_cast<std::size_t>(upper - cells.begin());
    approximate(cells.first(lower_count));
    approximate(cells.subspan(lower_count));
  }

  std::vector<CellBox> boxes() && { return std::move(boxes_); }

 private:
  double fill_;
  double smallest_;
  std::vector<CellBox> boxes_;
};

}  // namespace

std::vector<CellBox> midpoint_boxes(std::span<const CountedCell> cells, double fill,
                                    std::uint64_t smallest) {
  if (cells.empty()) return {};
  std::vector<Cell> places;
  places.reserve(cells.size());
  for (const CountedCell& counted : cells) places.push_back(counted.cell);
  Midpoint midpoint(fill, smallest);
  midpoint.approximate(places);
  return std::move(midpoint).boxes();
}

}  // namespace rmap
