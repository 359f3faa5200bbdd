#include "grid/implementation.hpp"

#include <algorithm>

#include <rmap/error.hpp>
#include <rmap/grid.hpp>

namespace rmap {

Grid::Implementation::Implementation(const Options& grid_options)
    : options(grid_options),
      lattice(grid_options.resolution),
      rule(grid_options),
      store(LeafStore::make(grid_options)) {}

Grid::Implementation::Implementation(const Implementation& other)
    : options(other.options),
      lattice(other.lattice),
      rule(other.rule),
      store(other.store->clone()),
      log(other.log),
      cell_count(other.cell_count),
      scan_poses(other.scan_poses),
      history(other.history) {}

void Grid::Implementation::begin_mutation() {
  if (log.begin()) return;
  store->visit(all_cells(), [&](LeafId id, const Leaf&) {
    store->set_stamp(id, 0);
    return true;
  });
}

void Grid::Implementation::count_new_cells(std::uint32_t cells) {
  cell_count += cells;
  if (cells > 0 && !scan_poses.empty()) history = History::first_hit;
}

std::uint32_t Grid::Implementation::note_new_cells(LeafId id, const Cell& origin,
                                                   const CellMask& cells, Value value) {
  const std::uint32_t count = cells.count();
  if (count == 0) return 0;
  store->set_stamp(id, log.stamp());
  count_new_cells(count);
  if (log.tracks_flips() && rule.occupied(value)) {
    cells.for_each([&](BlockPosition at) { log.flipped(origin + block_offset(at)); });
  }
  return count;
}

Grid::Grid(const Options& options) : implementation_(std::make_unique<Implementation>(options)) {}
Grid::Grid(const Grid& other)
    : implementation_(std::make_unique<Implementation>(*other.implementation_)) {}
Grid::Grid(Grid&&) noexcept = default;
Grid& Grid::operator=(const Grid& other) {
  if (this != &other) *this = Grid(other);
  return *this;
}
Grid& Grid::operator=(Grid&&) noexcept = default;
Grid::~Grid() = default;

const Options& Grid::options() const { return implementation_->options; }
const Lattice& Grid::lattice() const { return implementation_->lattice; }
const UpdateRule& Grid::rule() const { return implementation_->rule; }
History Grid::history() const { return implementation_->history; }
std::span<const Pose> Grid::scan_poses() const { return implementation_->scan_poses; }
std::size_t Grid::cell_count() const { return implementation_->cell_count; }
std::size_t Grid::leaf_count() const { return implementation_->store->leaf_count(); }
std::uint64_t Grid::revision() const { return implementation_->log.revision(); }

State Grid::state(const Vector3d& point) const { return cell_state(lattice().cell_of(point)); }

State Grid::cell_state(const Cell& cell) const {
  const Value* value = implementation_->store->find_value(cell);
  if (value == nullptr) return State::assumed_free;
  return rule().occupied(*value) ? State::occupied : State::free;
}

double Grid::point_probability(const Vector3d& point) const {
  return cell_probability(lattice().cell_of(point));
}

double Grid::cell_probability(const Cell& cell) const {
  const Value* value = implementation_->store->find_value(cell);
  return value == nullptr ? options().free_probability : probability_of(*value);
}

std::optional<Value> Grid::cell_value(const Cell& cell) const {
  const Value* value = implementation_->store->find_value(cell);
  if (value == nullptr) return std::nullopt;
  return *value;
}

CellBox Grid::bounds() const {
  CellBox bounds;
  visit_leaves(all_cells(), [&](const Leaf& leaf) {
    if (bounds.contains(leaf.box())) return true;
    leaf.for_each([&](const Cell& cell, Value) {
      bounds = bounds.empty() ? box_of(cell) : united(bounds, box_of(cell));
    });
    return true;
  });
  return bounds;
}

CellBox Grid::block_bounds() const {
  const CellBox leaves = implementation_->store->leaf_bounds();
  return {.min = block_origin(leaves.min),
          .max = block_origin(leaves.max + Cell::Constant(kBlockEdge - 1))};
}

BytesInUse Grid::bytes_in_use() const {
  BytesInUse bytes = implementation_->store->bytes_in_use();
  bytes.records =
      implementation_->scan_poses.capacity() * sizeof(Pose) + implementation_->log.bytes_in_use();
  return bytes;
}

RTreeStatistics Grid::rtree_statistics() const { return implementation_->store->tree_statistics(); }

void Grid::visit_leaves(const CellBox& region, FunctionRef<bool(const Leaf&)> visit) const {
  implementation_->store->visit(region, [&](LeafId, const Leaf& leaf) { return visit(leaf); });
}

void Grid::visit_leaves_along(const Beam& beam,
                              FunctionRef<double(const Leaf&, double enter)> visit) const {
  implementation_->store->visit_along(beam, visit);
}

std::optional<std::string> Grid::check() const {
  if (auto broken = implementation_->store->check()) return broken;
  std::size_t cells = 0;
  visit_leaves(all_cells(), [&](const Leaf& leaf) {
    cells += leaf.cells().count();
    return true;
  });
  if (cells != cell_count()) {
    return "the grid counts " + std::to_string(cell_count()) + " cells, but its leaves hold " +
           std::to_string(cells);
  }
  return std::nullopt;
}

namespace {

// The options that decide what the map is, without those on how it is kept and computed.
Options meaning(Options options) {
  const Options defaults;
  options.layout = defaults.layout;
  options.max_branches = defaults.max_branches;
  options.split = defaults.split;
  options.threads = defaults.threads;
  options.traversal = defaults.traversal;
  options.bad_points = defaults.bad_points;
  return options;
}

bool same_poses(std::span<const Pose> a, std::span<const Pose> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Pose& p, const Pose& q) { return p.matrix() == q.matrix(); });
}

}  // namespace

bool same_map(const Grid& a, const Grid& b) {
  if (meaning(a.options()) != meaning(b.options()) || a.history() != b.history() ||
      a.cell_count() != b.cell_count() || !same_poses(a.scan_poses(), b.scan_poses())) {
    return false;
  }
  bool same = true;
  a.visit_leaves(all_cells(), [&](const Leaf& leaf) {
    leaf.for_each(
        [&](const Cell& cell, Value value) { same = same && b.cell_value(cell) == value; });
    return same;
  });
  return same;
}

}  // namespace rmap
