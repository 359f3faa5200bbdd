#include <algorithm>

#include <rmap/rtree/node_pool.hpp>

namespace rmap {

namespace {

std::size_t rounded_up(std::size_t bytes, std::size_t alignment) {
  return (bytes + alignment - 1) / alignment * alignment;
}

std::size_t bytes_before_content(int max_branches, std::int32_t edge, std::size_t alignment) {
  const std::size_t columns = edge > 0 ? 3 : 6;
  const std::size_t words = 1 + columns * static_cast<std::size_t>(max_branches);
  return rounded_up(words * sizeof(std::int32_t), alignment);
}

std::size_t node_bytes(std::size_t content_offset, int max_branches, std::size_t content_size,
                       std::size_t alignment) {
  return rounded_up(content_offset + static_cast<std::size_t>(max_branches) * content_size,
                    std::max(alignment, alignof(std::int32_t)));
}

}  // namespace

NodePool::NodePool(int max_branches, std::int32_t edge, std::size_t content_size,
                   std::size_t content_alignment)
    : max_branches_(max_branches),
      edge_(edge),
      content_size_(content_size),
      content_alignment_(content_alignment),
      content_offset_(bytes_before_content(max_branches, edge, content_alignment)),
      records_(node_bytes(content_offset_, max_branches, content_size, content_alignment)) {}

std::uint32_t NodePool::allocate() {
  const std::uint32_t node = records_.allocate();
  // The columns too, so that copies and files never hold bytes that were not written.
  std::memset(records_.record(node), 0, records_.stride());
  return node;
}

void NodePool::set_box(std::uint32_t node, int branch, const CellBox& box) {
  assert(branch < count(node));
  std::int32_t* column = words(node) + 1 + branch;
  for (int axis = 0; axis < 3; ++axis, column += max_branches_) *column = box.min[axis];
  if (edge_ > 0) return;
  for (int axis = 0; axis < 3; ++axis, column += max_branches_) *column = box.max[axis];
}

CellBox NodePool::bounds(std::uint32_t node) const {
  assert(count(node) > 0);
  const BranchColumns branches = columns(node);
  CellBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int32_t* min = branches.min[axis];
    const std::int32_t* max = branches.max[axis];
    box.min[static_cast<int>(axis)] = *std::min_element(min, min + branches.count);
    box.max[static_cast<int>(axis)] = *std::max_element(max, max + branches.count) + branches.added;
  }
  return box;
}

void NodePool::append(std::uint32_t node, const CellBox& box, const std::byte* bytes) {
  assert(!full(node));
  const int branch = words(node)[0]++;
  set_box(node, branch, box);
  std::memcpy(content(node, branch), bytes, content_size_);
}

void NodePool::remove(std::uint32_t node, int branch) {
  const int last = count(node) - 1;
  copy_branch(node, last, branch);
  truncate(node, last);
}

void NodePool::truncate(std::uint32_t node, int count) {
  assert(count >= 0 && count <= this->count(node));
  words(node)[0] = count;
}

void NodePool::copy_branch(std::uint32_t node, int from, int to) {
  if (from == to) return;
  set_box(node, to, box(node, from));
  std::memcpy(content(node, to), content(node, from), content_size_);
}

}  // namespace rmap
