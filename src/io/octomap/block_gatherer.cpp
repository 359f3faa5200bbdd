#include "io/octomap/block_gatherer.hpp"

namespace rmap::octomap {

namespace {

constexpr std::size_t kBlocksAtOnce = 4096;
constexpr int kBlockLevel = 3;  // 2^3 cells along an edge
static_assert(1 << kBlockLevel == kBlockEdge);

}  // namespace

void BlockGatherer::add(const Leaf& leaf, Value value) {
  if (leaf.level < kBlockLevel) {
    const Cell origin = block_origin(leaf.origin);
    if (origins_.empty() || origins_.back() != origin) add_block(origin);
    // The cells of a small leaf are neighbours on the Morton curve.
    const BlockPosition first = block_position(leaf.origin);
    const auto count = static_cast<BlockPosition>(leaf.cells());
    for (BlockPosition i = 0; i < count; ++i) masks_.back().set(first + i);
    values_.insert(values_.end(), count, value);
    return;
  }
  const std::uint64_t blocks = leaf.cells() / kBlockCells;
  for (std::uint64_t code = 0; code < blocks; ++code) {
    add_block(leaf.origin + morton_offset(code) * kBlockEdge);
    for (std::uint64_t& word : masks_.back().words()) word = ~std::uint64_t{0};
    values_.insert(values_.end(), kBlockCells, value);
  }
}

void BlockGatherer::add_block(const Cell& origin) {
  if (origins_.size() == kBlocksAtOnce) flush();
  origins_.push_back(origin);
  masks_.emplace_back();
}

void BlockGatherer::flush() {
  std::vector<BlockValues> blocks;
  blocks.reserve(origins_.size());
  std::span<const Value> values(values_);
  for (std::size_t i = 0; i < origins_.size(); ++i) {
    const std::size_t count = masks_[i].count();
    blocks.push_back({origins_[i], masks_[i], values.first(count)});
    values = values.subspan(count);
  }
  grid_.set_blocks(blocks);
  origins_.clear();
  masks_.clear();
  values_.clear();
}

}  // namespace rmap::octomap
