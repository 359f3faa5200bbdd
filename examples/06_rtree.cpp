// The R-tree on its own: boxes of cells with a payload, no occupancy [RMAP 2].
#include <iostream>
#include <vector>

#include <rmap/beam.hpp>
#include <rmap/rtree.hpp>

int main() {
  // A field of 20 x 20 posts: one cell wide and 4 to 8 cells high.
  using Posts = rmap::RTree<int>;
  std::vector<Posts::Item> items;
  for (int i = 0; i < 400; ++i) {
    const rmap::Cell foot(5 * (i % 20), 5 * (i / 20), 0);
    items.push_back({{.min = foot, .max = foot + rmap::Cell(1, 1, 4 + i % 5)}, i});
  }

  // M trades memory against overlap [RMAP 2.1], and packing beats inserting one by one.
  for (const int max_branches : {4, 16, 64}) {
    Posts grown({.max_branches = max_branches});
    for (const Posts::Item& item : items) grown.insert(item.box, item.payload);
    const auto packed = Posts::bulk_load(items, {.max_branches = max_branches});
    std::cout << "M = " << max_branches << ": height " << grown.height() << ", "
              << grown.statistics().nodes << " nodes grown, " << packed.statistics().nodes
              << " packed\n";
  }

  Posts posts = Posts::bulk_load(items);
  int overlapping = 0;
  posts.overlapping({.min = {0, 0, 0}, .max = {12, 12, 2}},
                    [&](const rmap::CellBox&, int) { ++overlapping; });
  std::cout << overlapping << " posts overlap the corner\n";

  if (const auto nearest = posts.nearest({51.5, 48.0, 1.0})) {
    std::cout << "post " << nearest->payload << " is nearest, " << nearest->distance
              << " cells away\n";
  }

  // From front to back along a beam, until the third post.
  int met = 0;
  posts.crossed_in_order(rmap::Beam({-1.0, 10.5, 1.5}, {99.0, 10.5, 1.5}, false),
                         [&](const rmap::CellBox&, int post, double enter) {
                           std::cout << "the beam meets post " << post << " after " << enter * 100
                                     << " cells\n";
                           return ++met == 3 ? 0.0 : 1.0;
                         });

  posts.erase(items[0].box);
  std::cout << posts.size() << " posts are left; the tree is "
            << (posts.check() ? "broken\n" : "sound\n");
}
