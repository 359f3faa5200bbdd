#include "evaluation/rtree_experiment.hpp"

#include "evaluation/seen_cells.hpp"
#include "evaluation/stopwatch.hpp"

#include <functional>

namespace rmap::evaluation {

namespace {

using Tree = RTree<std::uint32_t>;

// The boxes that a map of the sequence would put into its tree, in that order.
std::vector<Tree::Item> items_of(const Sequence& sequence, double resolution, int edge) {
  const Lattice lattice(resolution);
  std::vector<Tree::Item> items;
  CellSet known;
  std::size_t size = 0;
  for (const Scan& scan : sequence.scans) {
    for (const Vector3f& point : scan.points) {
      const auto end = lattice.find_cell(point.cast<double>());
      if (!end) continue;
      const Cell low = edge == 1 ? *end : block_origin(*end);
      if (known.contains(low)) continue;
      known.insert(low);
      items.push_back(
          {{.min = low, .max = low + Cell::Constant(edge)}, static_cast<std::uint32_t>(size++)});
    }
  }
  return items;
}

// Lookups all over the tree, in an order that has nothing to do with its own.
double find_ns(const Tree& tree, const std::vector<Tree::Item>& items) {
  constexpr std::size_t kLookups = 20000;
  constexpr std::size_t kStep = 7919;  // a prime
  std::size_t found = 0;
  std::size_t at = 0;
  const double time = milliseconds_of([&] {
    for (std::size_t i = 0; i < kLookups; ++i) {
      at = (at + kStep) % items.size();
      found += tree.find(items[at].box) != nullptr ? 1 : 0;
    }
  });
  return found == kLookups ? 1e6 * time / static_cast<double>(kLookups) : 0;
}

double extract_ns(const Tree& tree) {
  std::uint64_t sum = 0;
  const double time = milliseconds_of(
      [&] { tree.for_each([&](const CellBox&, std::uint32_t payload) { sum += payload; }); });
  return sum == 0 && tree.size() > 1 ? 0 : 1e6 * time / static_cast<double>(tree.size());
}

void describe(const RTreeStatistics& statistics, RTreeRow& row) {
  double volume = 0;
  for (const RTreeLevelStatistics& level : statistics.levels) {
    volume += level.volume;
    row.overlap += level.overlap_volume;
    row.dead_space += level.dead_space;
  }
  row.overlap_of_node = row.overlap / static_cast<double>(statistics.nodes);
  row.overlap /= volume;
  row.dead_space /= volume;
  row.bytes = statistics.bytes_in_use;
  row.nodes = statistics.nodes;
  row.height = statistics.height;
}

RTreeRow measure(const std::vector<Tree::Item>& items, int repetitions,
                 const std::function<Tree()>& build) {
  RTreeRow row{.items = items.size()};
  std::vector<double> insert, extract, find;
  for (int i = 0; i < repetitions; ++i) {
    std::optional<Tree> tree;
    insert.push_back(milliseconds_of([&] { tree.emplace(build()); }));
    extract.push_back(extract_ns(*tree));
    find.push_back(find_ns(*tree, items));
    if (i == 0) describe(tree->statistics(), row);
  }
  row.insert_ns = 1e6 * median(insert) / static_cast<double>(items.size());
  row.extract_ns = median(extract);
  row.find_ns = median(find);
  return row;
}

}  // namespace

Json to_json(const RTreeRow& row) {
  return {{"sequence", row.sequence},
          {"resolution_m", row.resolution},
          {"leaves", row.leaves},
          {"built", row.built},
          {"max_branches", row.max_branches},
          {"items", row.items},
          {"insert_ns_per_item", row.insert_ns},
          {"extract_ns_per_item", row.extract_ns},
          {"find_ns_per_item", row.find_ns},
          {"bytes", row.bytes},
          {"nodes", row.nodes},
          {"height", row.height},
          {"overlap", row.overlap},
          {"overlap_cells_per_node", row.overlap_of_node},
          {"dead_space", row.dead_space}};
}

std::vector<RTreeRow> rtree_experiment(const Sequence& sequence,
                                       const RTreeExperimentOptions& options) {
  std::vector<RTreeRow> rows;
  for (const int edge : {1, kBlockEdge}) {
    const std::vector<Tree::Item> items = items_of(sequence, options.resolution, edge);
    if (items.empty()) continue;
    const auto add = [&](const char* built, int branches, const std::function<Tree()>& build) {
      RTreeRow row = measure(items, options.repetitions, build);
      row.sequence = sequence.name;
      row.resolution = options.resolution;
      row.leaves = edge == 1 ? "cells" : "blocks";
      row.built = built;
      row.max_branches = branches;
      rows.push_back(row);
    };
    for (const int branches : {4, 8, 16, 32, 64}) {
      for (const Split split : {Split::quadratic, Split::linear}) {
        const RTreeOptions order{
            .max_branches = branches, .split = split, .leaf_edge = static_cast<int>(edge)};
        add(split == Split::quadratic ? "quadratic" : "linear", branches, [&items, order] {
          Tree tree(order);
          for (const Tree::Item& item : items) tree.insert(item.box, item.payload);
          return tree;
        });
      }
      const RTreeOptions order{.max_branches = branches, .leaf_edge = static_cast<int>(edge)};
      add("bulk", branches, [&items, order] { return Tree::bulk_load(items, order); });
    }
  }
  return rows;
}

}  // namespace rmap::evaluation
