#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <rmap/cells.hpp>
#include <rmap/error.hpp>

namespace rmap {

namespace {

// Whether a box (m) comes nearer to the centre of the sphere than its radius.
bool reaches(const Sphere& sphere, const Box& box) {
  return (box.nearest(sphere.center) - sphere.center).squaredNorm() < sphere.radius * sphere.radius;
}

void check_sphere(const Sphere& sphere) {
  if (sphere.center.allFinite() && sphere.radius >= 0 && std::isfinite(sphere.radius)) return;
  throw Error(
      ErrorKind::input,
      fmt::format("the sphere around ({}, {}, {}) m has the radius {} m: all must be finite "
                  "and the radius not negative",
                  sphere.center.x(), sphere.center.y(), sphere.center.z(), sphere.radius));
}

// Tests the cells of a grid against a selection.
class Selector {
 public:
  Selector(const Grid& grid, const CellSelection& selection)
      : lattice_(grid.lattice()), rule_(grid.rule()), selection_(selection) {
    if (selection.sphere) {
      check_sphere(*selection.sphere);
      region_ = intersection(region_, around(*selection.sphere));
    }
    if (selection.box) region_ = intersection(region_, lattice_.cells_of(*selection.box));
  }

  /// Holds every selected cell.
  const CellBox& region() const { return region_; }

  bool wants(const Leaf& leaf) const {
    return !selection_.sphere || reaches(*selection_.sphere, lattice_.metric(leaf.box()));
  }

  /// Whether the place of a cell of the leaf does not matter.
  bool wants_all_places(const Leaf& leaf) const {
    return !selection_.sphere && region_.contains(leaf.box());
  }
  bool wants(Value value) const { return !selection_.occupied_only || rule_.occupied(value); }
  bool wants(const Cell& cell, Value value) const {
    return wants(value) && region_.contains(cell) &&
           (!selection_.sphere || reaches(*selection_.sphere, lattice_.metric(box_of(cell))));
  }

 private:
  // A box of cells that holds the sphere, with a cell to spare for rounding.
  CellBox around(const Sphere& sphere) const {
    const auto index = [](double border) {
      return static_cast<std::int32_t>(
          std::clamp<double>(border, kMinCellIndex, kMaxCellIndex + 1.0));
    };
    const Vector3d low = lattice_.to_cells((sphere.center.array() - sphere.radius).matrix());
    const Vector3d high = lattice_.to_cells((sphere.center.array() + sphere.radius).matrix());
    CellBox box;
    for (int axis = 0; axis < 3; ++axis) {
      box.min[axis] = index(std::floor(low[axis]) - 1);
      box.max[axis] = index(std::ceil(high[axis]) + 1);
    }
    return box;
  }

  const Lattice& lattice_;
  const UpdateRule& rule_;
  const CellSelection& selection_;
  CellBox region_ = all_cells();
};

// The wanted cells of a leaf, in Morton order.
class WantedCells {
 public:
  WantedCells(const Leaf& leaf, const Selector& selector) {
    if (!selector.wants(leaf)) return;
    if (selector.wants_all_places(leaf)) {
      list(leaf, [&](const Cell&, Value value) { return selector.wants(value); });
    } else {
      list(leaf, [&](const Cell& cell, Value value) { return selector.wants(cell, value); });
    }
  }

  std::span<const CellValue> cells() const { return std::span(cells_).first(count_); }

 private:
  // Nothing foretells which cells are occupied: they are listed without a branch for each.
  template <class Wants>
  void list(const Leaf& leaf, const Wants& wants) {
    std::size_t count = 0;
    leaf.for_each([&](const Cell& cell, Value value) {
      cells_[count] = {cell, value};
      count += wants(cell, value) ? 1 : 0;
    });
    count_ = count;
  }

  std::array<CellValue, kBlockCells> cells_;
  std::size_t count_ = 0;
};

}  // namespace

CellRange::CellRange(const Grid& grid, const CellSelection& selection, Order order)
    : grid_(&grid), selection_(selection) {
  const Selector selector(grid, selection_);
  if (selector.region().empty()) return;
  grid.visit_leaves(selector.region(), [&](const Leaf& leaf) {
    if (selector.wants(leaf)) leaves_.push_back(leaf);
    return true;
  });
  if (order == Order::morton) {
    std::sort(leaves_.begin(), leaves_.end(),
              [](const Leaf& a, const Leaf& b) { return morton_less(a.origin, b.origin); });
  }
  fill();
}

void CellRange::advance() {
  if (++next_ == batch_.size()) fill();
}

void CellRange::fill() {
  const Selector selector(*grid_, selection_);
  batch_.clear();
  next_ = 0;
  while (batch_.empty() && next_leaf_ < leaves_.size()) {
    const WantedCells wanted(leaves_[next_leaf_++], selector);
    batch_.assign(wanted.cells().begin(), wanted.cells().end());
  }
}

CellRange cells(const Grid& grid, const CellSelection& selection, Order order) {
  return CellRange(grid, selection, order);
}

void for_each_batch(const Grid& grid, const CellSelection& selection,
                    FunctionRef<bool(std::span<const CellValue>)> use) {
  const Selector selector(grid, selection);
  if (selector.region().empty()) return;
  grid.visit_leaves(selector.region(), [&](const Leaf& leaf) {
    const WantedCells wanted(leaf, selector);
    return wanted.cells().empty() || use(wanted.cells());
  });
}

std::size_t count_cells(const Grid& grid, const CellSelection& selection) {
  std::size_t count = 0;
  for_each_batch(grid, selection, [&](std::span<const CellValue> batch) {
    count += batch.size();
    return true;
  });
  return count;
}

bool any_occupied(const Grid& grid, const Sphere& sphere) {
  bool found = false;
  for_each_cell(grid, {.sphere = sphere, .occupied_only = true}, [&](const Cell&, Value) {
    found = true;
    return false;
  });
  return found;
}

}  // namespace rmap
