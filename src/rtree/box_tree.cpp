#include "rtree/text.hpp"

#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/rtree/box_tree.hpp>

namespace rmap {

namespace {

constexpr int kSmallestMaxBranches = 4;
constexpr int kMaxLeafEdge = 1 << 30;

void require_within(int value, const char* name, int low, int high) {
  if (value >= low && value <= high) return;
  throw Error(ErrorKind::input, fmt::format("the R-tree's {} is {}: it must lie in {} to {}", name,
                                            value, low, high));
}

RTreeOptions resolved(RTreeOptions options) {
  require_within(options.max_branches, "max_branches", kSmallestMaxBranches, kMaxBranches);
  if (options.min_branches == 0) options.min_branches = options.max_branches / 2;
  require_within(options.min_branches, "min_branches", 1, options.max_branches / 2);
  require_within(options.leaf_edge, "leaf_edge", 0, kMaxLeafEdge);
  return options;
}

}  // namespace

BoxTree::BoxTree(const RTreeOptions& options, std::size_t payload_size,
                 std::size_t payload_alignment)
    : options_(resolved(options)),
      inner_(options_.max_branches, 0, sizeof(std::uint32_t), alignof(std::uint32_t)),
      leaves_(options_.max_branches, options_.leaf_edge, payload_size, payload_alignment) {}

BoxTree::BoxTree(BoxTree&& other) noexcept
    : options_(other.options_),
      inner_(std::move(other.inner_)),
      leaves_(std::move(other.leaves_)),
      root_(std::exchange(other.root_, NodePool::kNone)),
      height_(std::exchange(other.height_, 0)),
      size_(std::exchange(other.size_, 0)) {}

BoxTree& BoxTree::operator=(const BoxTree& other) {
  if (this != &other) *this = BoxTree(other);
  return *this;
}

BoxTree& BoxTree::operator=(BoxTree&& other) noexcept {
  if (this == &other) return *this;
  options_ = other.options_;
  inner_ = std::move(other.inner_);
  leaves_ = std::move(other.leaves_);
  root_ = std::exchange(other.root_, NodePool::kNone);
  height_ = std::exchange(other.height_, 0);
  size_ = std::exchange(other.size_, 0);
  return *this;
}

void BoxTree::clear() {
  inner_.clear();
  leaves_.clear();
  root_ = NodePool::kNone;
  height_ = 0;
  size_ = 0;
}

CellBox BoxTree::bounds() const {
  return height_ == 0 ? CellBox{} : nodes(height_ - 1).bounds(root_);
}

void BoxTree::check_box(const CellBox& box, std::optional<std::size_t> item) const {
  const auto refuse = [&](ErrorKind kind, const std::string& reason) {
    const std::string name = item ? fmt::format("the box of item {}", *item) : "the box";
    throw Error(kind, fmt::format("{} {} {}", name, text_of(box), reason));
  };
  if (box.empty()) refuse(ErrorKind::input, "is empty: an R-tree holds boxes with a volume");
  if (!all_cells().contains(box)) {
    refuse(ErrorKind::limit, fmt::format("leaves the limits: cell indices lie in {} to {}",
                                         kMinCellIndex, kMaxCellIndex));
  }
  const int edge = options_.leaf_edge;
  if (edge > 0 && (box.extent().array() != edge).any()) {
    refuse(
        ErrorKind::input,
        fmt::format("is no cube of {0} x {0} x {0} cells, which this R-tree's leaf_edge asks for",
                    edge));
  }
}

}  // namespace rmap
