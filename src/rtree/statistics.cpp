#include "rtree/union_volume.hpp"

#include <rmap/rtree/box_tree.hpp>
#include <rmap/rtree/statistics.hpp>

namespace rmap {

namespace {

void add_node(const NodePool& pool, std::uint32_t node, RTreeLevelStatistics& level) {
  std::vector<CellBox> boxes;
  boxes.reserve(static_cast<std::size_t>(pool.count(node)));
  for (int i = 0; i < pool.count(node); ++i) boxes.push_back(pool.box(node, i));
  CellCount sum = 0;
  CellCount overlap = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    sum += cells_in(boxes[i]);
    for (std::size_t j = 0; j < i; ++j) overlap += cells_in(intersection(boxes[i], boxes[j]));
  }
  const CellCount volume = cells_in(pool.bounds(node));
  const CellCount covered = overlap == 0 ? sum : cells_in_union(boxes);
  ++level.nodes;
  level.branches += boxes.size();
  level.volume += static_cast<double>(volume);
  level.overlap_volume += static_cast<double>(overlap);
  level.dead_space += static_cast<double>(volume - covered);
}

void add_subtree(const BoxTree& tree, std::uint32_t node, int level, RTreeStatistics& statistics) {
  const NodePool& pool = tree.nodes(level);
  add_node(pool, node, statistics.levels[static_cast<std::size_t>(level)]);
  if (level == 0) return;
  for (int i = 0; i < pool.count(node); ++i) {
    add_subtree(tree, pool.child(node, i), level - 1, statistics);
  }
}

}  // namespace

RTreeStatistics BoxTree::statistics() const {
  RTreeStatistics statistics{
      .levels = {}, .height = height_, .items = size_, .nodes = 0, .bytes_in_use = bytes_in_use()};
  statistics.levels.resize(static_cast<std::size_t>(height_));
  if (height_ > 0) add_subtree(*this, root_, height_ - 1, statistics);
  for (int i = 0; i < height_; ++i) {
    RTreeLevelStatistics& level = statistics.levels[static_cast<std::size_t>(i)];
    level.level = i;
    level.fill = static_cast<double>(level.branches) /
                 (static_cast<double>(level.nodes) * options_.max_branches);
    statistics.nodes += level.nodes;
  }
  return statistics;
}

}  // namespace rmap
