// The R-tree, an item or a search at a time, for several M; searches beside a look at every item.
#include "micro/street.hpp"
#include "support/random.hpp"

#include <algorithm>

#include <rmap/rtree.hpp>

namespace rmap::bench {
namespace {

using Tree = RTree<std::uint32_t>;

// The street's blocks of 8 x 8 x 8 cells, in the order of the scans.
const std::vector<Tree::Item>& blocks() {
  static const std::vector<Tree::Item> kItems = [] {
    std::vector<Tree::Item> items;
    street_map().visit_leaves(all_cells(), [&](const Leaf& leaf) {
      items.push_back({leaf.box(), static_cast<std::uint32_t>(items.size())});
      return true;
    });
    test::Random random(11);
    std::shuffle(items.begin(), items.end(), random.engine());
    return items;
  }();
  return kItems;
}

RTreeOptions options(const benchmark::State& state) {
  return {.max_branches = static_cast<int>(state.range(0)), .leaf_edge = kBlockEdge};
}

Tree grown(const RTreeOptions& with) {
  Tree tree(with);
  for (const Tree::Item& item : blocks()) tree.insert(item.box, item.payload);
  return tree;
}

std::vector<CellBox> regions() {
  test::Random random(12);
  std::vector<CellBox> regions;
  const auto last = static_cast<std::int32_t>(blocks().size()) - 1;
  for (int i = 0; i < 200; ++i) {
    const CellBox& box = blocks()[static_cast<std::size_t>(random.integer(0, last))].box;
    regions.push_back({box.min - Cell::Constant(20), box.max + Cell::Constant(20)});
  }
  return regions;
}

std::size_t count_overlaps(const std::vector<Tree::Item>& items, const CellBox& region) {
  return static_cast<std::size_t>(
      std::count_if(items.begin(), items.end(),
                    [&](const Tree::Item& item) { return item.box.overlaps(region); }));
}
std::size_t count_overlaps(const Tree& tree, const CellBox& region) {
  std::size_t count = 0;
  tree.overlapping(region, [&](const CellBox&, std::uint32_t) {
    ++count;
    return true;
  });
  return count;
}

void rtree_insert(benchmark::State& state) {
  if (!right(state, grown(options(state)).size() == blocks().size())) return;
  for (auto _ : state) benchmark::DoNotOptimize(grown(options(state)).size());
  set_units(state, blocks().size());
}
BENCHMARK(rtree_insert)->Arg(4)->Arg(8)->Arg(16)->Arg(32)->Arg(64)->Unit(benchmark::kMillisecond);

void rtree_bulk_load(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(Tree::bulk_load(blocks(), options(state)).size());
  }
  set_units(state, blocks().size());
}
BENCHMARK(rtree_bulk_load)->Arg(8)->Arg(16)->Arg(32)->Unit(benchmark::kMillisecond);

void rtree_find(benchmark::State& state) {
  const Tree tree = grown(options(state));
  for (const Tree::Item& item : blocks()) {
    const std::uint32_t* found = tree.find(item.box);
    if (!right(state, found != nullptr && *found == item.payload)) return;
  }
  for (auto _ : state) {
    for (const Tree::Item& item : blocks()) benchmark::DoNotOptimize(tree.find(item.box));
  }
  set_units(state, blocks().size());
}
BENCHMARK(rtree_find)->Arg(4)->Arg(8)->Arg(16)->Arg(32)->Arg(64)->Unit(benchmark::kMillisecond);

void rtree_overlapping(benchmark::State& state) {
  const Tree tree = grown(options(state));
  const std::vector<CellBox> asked = regions();
  for (const CellBox& region : asked) {
    if (!right(state, count_overlaps(tree, region) == count_overlaps(blocks(), region))) return;
  }
  for (auto _ : state) {
    for (const CellBox& region : asked) benchmark::DoNotOptimize(count_overlaps(tree, region));
  }
  set_units(state, asked.size());
}
BENCHMARK(rtree_overlapping)->Arg(4)->Arg(8)->Arg(16)->Arg(32)->Arg(64);

void every_item_overlapping(benchmark::State& state) {
  const std::vector<CellBox> asked = regions();
  for (auto _ : state) {
    for (const CellBox& region : asked) benchmark::DoNotOptimize(count_overlaps(blocks(), region));
  }
  set_units(state, asked.size());
}
BENCHMARK(every_item_overlapping);

}  // namespace
}  // namespace rmap::bench
