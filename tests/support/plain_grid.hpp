#pragma once

#include "support/plain_crossing.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rmap/grid.hpp>

namespace rmap::test {

struct MortonOrder {
  bool operator()(const Cell& a, const Cell& b) const { return morton_less(a, b); }
};

/// An occupancy grid by the letter of the definition: a map from cells to
/// values, and for each scan every existing cell asked of every beam. Slow.
class PlainGrid {
 public:
  explicit PlainGrid(const Options& options) : options_(options) {}
  /// Follows these cells alone: what it says of others, and of counts, means nothing.
  PlainGrid(const Options& options, std::set<Cell, MortonOrder> followed)
      : options_(options), followed_(std::move(followed)) {}

  void prepare(const Scan& scan);
  InsertReport insert(const Scan& scan);

  const std::map<Cell, int, MortonOrder>& cells() const { return cells_; }
  bool occupied(const Cell& cell) const;
  std::optional<int> value(const Cell& cell) const;

 private:
  struct Sorted;
  bool follows(const Cell& cell) const { return followed_.empty() || followed_.contains(cell); }
  Sorted sort_out(const Scan& scan) const;

  Options options_;
  std::set<Cell, MortonOrder> followed_;
  std::map<Cell, int, MortonOrder> cells_;
};

/// How the cells and values of a grid differ from a plain one's; empty when they do not.
std::string difference(const Grid& grid, const PlainGrid& plain);

}  // namespace rmap::test
