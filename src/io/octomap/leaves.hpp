#pragma once

#include "io/octomap/header.hpp"

#include <vector>

#include <rmap/cell.hpp>
#include <rmap/function_ref.hpp>

namespace rmap::octomap {

/// A leaf of the tree: a cube of cells of one state.
struct Leaf {
  Cell origin;  ///< lowest cell, a multiple of the edge from -kHalf on
  int level;    ///< the edge is 2^level cells
  bool occupied;
  float log_odds;  ///< 0 in a file of states only

  std::uint64_t cells() const { return std::uint64_t{1} << (3 * level); }
  CellBox box() const {
    return {.min = origin, .max = origin + Cell::Constant(std::int32_t{1} << level)};
  }
};

/// What lies at place `code` of the Morton curve through a cube, as an offset from its lowest
/// corner.
Cell morton_offset(std::uint64_t code);

/// use(cell) for each cell of a leaf, in Morton order.
template <class Use>
void for_each_cell(const Leaf& leaf, Use&& use) {
  for (std::uint64_t code = 0; code < leaf.cells(); ++code) {
    use(Cell(leaf.origin + morton_offset(code)));
  }
}

/// The leaves of a file of OctoMap that may come from anybody. The file's bytes are in memory;
/// a walk takes no more but a stack of fixed depth.
class Leaves {
 public:
  /// Throws Error(io), Error(input) for a header that is none.
  explicit Leaves(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return file_; }
  const Header& header() const { return header_; }

  /// Visits all in Morton order. Throws Error(input) where the tree is not sound: when that is
  /// at its end, as a count of nodes is, after the visits.
  void visit(FunctionRef<void(const Leaf&)> use) const;

 private:
  std::filesystem::path file_;
  std::vector<std::byte> content_;
  Header header_;
  std::size_t first_node_ = 0;  ///< offset in the file
};

}  // namespace rmap::octomap
