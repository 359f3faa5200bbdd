#pragma once

#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

#include <rmap/grid.hpp>

namespace rmap {

/// A ball, metres, in the map's frame.
struct Sphere {
  Vector3d center = Vector3d::Zero();
  double radius = 0;  ///< not negative
};

/// Which cells of a grid are wanted: those for which all that is given holds.
struct CellSelection {
  /// Cells in the box (m); borders as in Lattice::cells_of.
  std::optional<Box> box = {};
  /// Cells that come nearer to the centre than the radius.
  std::optional<Sphere> sphere = {};
  bool occupied_only = false;
};

/// In which order cells come.
enum class Order {
  morton,  ///< along the Morton curve: the same for equal maps
  any,     ///< as they lie in memory: faster to start
};

/// Cells of a grid as a single-pass range. Valid until the grid changes.
///
///     for (const auto& [cell, value] : rmap::cells(grid, {.occupied_only = true})) ...
///
/// Cost: each cell in the leaves near the selection; memory by leaves.
class CellRange {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = CellValue;
    using difference_type = std::ptrdiff_t;
    using pointer = const CellValue*;
    using reference = const CellValue&;

    Iterator() = default;
    explicit Iterator(CellRange* range) : range_(range) {}
    reference operator*() const { return range_->batch_[range_->next_]; }
    pointer operator->() const { return &**this; }
    Iterator& operator++() {
      range_->advance();
      return *this;
    }
    void operator++(int) { ++*this; }
    friend bool operator==(const Iterator& a, std::default_sentinel_t) { return a.at_end(); }

   private:
    bool at_end() const { return range_->batch_.empty(); }

    CellRange* range_ = nullptr;
  };

  Iterator begin() { return Iterator(this); }
  std::default_sentinel_t end() const { return {}; }

 private:
  friend CellRange cells(const Grid& grid, const CellSelection& selection, Order order);
  CellRange(const Grid& grid, const CellSelection& selection, Order order);
  void advance();
  void fill();

  const Grid* grid_;
  CellSelection selection_;
  std::vector<Leaf> leaves_;
  std::size_t next_leaf_ = 0;
  std::vector<CellValue> batch_;  ///< the selected cells of one leaf; empty at the end
  std::size_t next_ = 0;
};

/// The selected cells of a grid, as a range. Throws Error(input) when the box is
/// empty or the radius is negative or not finite.
CellRange cells(const Grid& grid, const CellSelection& selection = {}, Order order = Order::morton);

/// use(cells) for the selected cells of each leaf that has some, up to 512 at a time, leaves in
/// no order: the fastest way. `use` returns false to stop; the cells are gone when it returns.
void for_each_batch(const Grid& grid, const CellSelection& selection,
                    FunctionRef<bool(std::span<const CellValue>)> use);

/// use(cell, value) for each selected cell, in no order. `use` returns false to stop.
template <class Use>
void for_each_cell(const Grid& grid, const CellSelection& selection, Use&& use) {
  for_each_batch(grid, selection, [&](std::span<const CellValue> batch) {
    for (const CellValue& each : batch) {
      if (!use(each.cell, each.value)) return false;
    }
    return true;
  });
}

/// How many cells are selected.
std::size_t count_cells(const Grid& grid, const CellSelection& selection);

/// Whether an occupied cell comes nearer to the centre than the radius: a
/// collision check for a ball.
bool any_occupied(const Grid& grid, const Sphere& sphere);

}  // namespace rmap
