#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include <rmap/cell.hpp>
#include <rmap/rtree/record_pool.hpp>

namespace rmap {

/// The largest M that an R-tree may have: the branches of a node fit in a 64-bit mask.
inline constexpr int kMaxBranches = 64;

/// The boxes of a node's branches, as columns: branch i covers, on axis a,
/// [min[a][i], max[a][i] + added).
struct BranchColumns {
  int count;
  std::array<const std::int32_t*, 3> min;
  std::array<const std::int32_t*, 3> max;
  std::int32_t added;
};

/// The nodes of an R-tree that are alike: the inner nodes, or the leaves. A node
/// is a flat record: the number of its branches, then columns of their boxes (the
/// lower corners, then the upper ones unless all boxes are cubes of one edge),
/// then what stands behind each branch: a child's id, or a payload.
class NodePool {
 public:
  static constexpr std::uint32_t kNone = RecordPool<std::byte>::kNone;

  /// `edge`: that of the cubes, or 0 for boxes of any shape. `content_size` and
  /// `content_alignment`: bytes behind each branch.
  NodePool(int max_branches, std::int32_t edge, std::size_t content_size,
           std::size_t content_alignment);

  std::size_t content_size() const { return content_size_; }
  std::size_t content_alignment() const { return content_alignment_; }

  /// A node without branches.
  std::uint32_t allocate();
  void release(std::uint32_t node) { records_.release(node); }
  void reserve(std::size_t nodes) { records_.reserve(nodes); }
  void clear() { records_.clear(); }

  int count(std::uint32_t node) const { return words(node)[0]; }
  bool full(std::uint32_t node) const { return count(node) == max_branches_; }

  CellBox box(std::uint32_t node, int branch) const {
    assert(branch < count(node));
    const std::int32_t* column = words(node) + 1 + branch;
    CellBox box;
    for (int axis = 0; axis < 3; ++axis, column += max_branches_) box.min[axis] = *column;
    if (edge_ > 0) {
      box.max = box.min + Cell::Constant(edge_);
    } else {
      for (int axis = 0; axis < 3; ++axis, column += max_branches_) box.max[axis] = *column;
    }
    return box;
  }
  void set_box(std::uint32_t node, int branch, const CellBox& box);
  BranchColumns columns(std::uint32_t node) const {
    const std::int32_t* min = words(node) + 1;
    const std::ptrdiff_t column = max_branches_;
    const std::int32_t* max = edge_ > 0 ? min : min + 3 * column;
    return {.count = count(node),
            .min = {min, min + column, min + 2 * column},
            .max = {max, max + column, max + 2 * column},
            .added = edge_};
  }
  /// The MBRC of the node, which has a branch.
  CellBox bounds(std::uint32_t node) const;

  std::byte* content(std::uint32_t node, int branch) {
    assert(branch < count(node));
    return records_.record(node) + content_offset_ +
           static_cast<std::size_t>(branch) * content_size_;
  }
  const std::byte* content(std::uint32_t node, int branch) const {
    assert(branch < count(node));
    return records_.record(node) + content_offset_ +
           static_cast<std::size_t>(branch) * content_size_;
  }
  /// The content of a branch of an inner node.
  std::uint32_t child(std::uint32_t node, int branch) const {
    std::uint32_t id = kNone;
    std::memcpy(&id, content(node, branch), sizeof(id));
    return id;
  }

  /// Adds a branch to a node that is not full.
  void append(std::uint32_t node, const CellBox& box, const std::byte* content);
  /// Removes a branch; the last one takes its place.
  void remove(std::uint32_t node, int branch);
  /// Keeps only the first `count` branches.
  void truncate(std::uint32_t node, int count);
  /// Copies branch `from` of the node over its branch `to`.
  void copy_branch(std::uint32_t node, int from, int to);

  /// Number of nodes in use, and one more than the highest id that ever was.
  std::size_t size() const { return records_.size(); }
  std::size_t slots() const { return records_.slots(); }
  std::size_t bytes_in_use() const { return records_.bytes_in_use(); }
  /// RecordPool::slots_in_use().
  std::optional<std::vector<bool>> slots_in_use() const { return records_.slots_in_use(); }

 private:
  // Bytes provide the storage; the words at the start of a record are its count and columns.
  std::int32_t* words(std::uint32_t node) {
    return reinterpret_cast<std::int32_t*>(records_.record(node));
  }
  const std::int32_t* words(std::uint32_t node) const {
    return reinterpret_cast<const std::int32_t*>(records_.record(node));
  }

  int max_branches_;
  std::int32_t edge_;
  std::size_t content_size_;
  std::size_t content_alignment_;
  std::size_t content_offset_;
  RecordPool<std::byte> records_;
};

}  // namespace rmap
