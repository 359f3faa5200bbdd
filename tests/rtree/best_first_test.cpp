#include "rtree/boxes.hpp"
#include "rtree/oracle.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/rtree.hpp>

namespace rmap {
namespace {

using test::Data;
using test::Items;
using test::plain_ranking;
using test::Random;
using test::Ranked;
using test::Tree;

struct Case {
  Tree tree;
  Items items;
};

/// Calls use(case, random) with inserted and packed trees of all data; returns how many.
template <class Use>
int for_each_case(const Use& use) {
  int cases = 0;
  for (const Data data : test::kAllData) {
    for (const int leaf_edge : {0, 1, 8}) {
      for (const int max_branches : {4, 16, 64}) {
        Random random(static_cast<std::uint64_t>(data));
        const RTreeOptions options{.max_branches = max_branches, .leaf_edge = leaf_edge};
        SCOPED_TRACE(random.trace() + ", " + test::text_of(options));
        Items items;
        for (const CellBox& box : test::boxes_of(data, leaf_edge, 300, random)) {
          items.push_back({box, static_cast<int>(items.size())});
        }
        Tree inserted(options);
        for (const Tree::Item& item : items) inserted.insert(item.box, item.payload);
        use(Case{inserted, items}, random);
        use(Case{Tree::bulk_load(items, options, Packing::hilbert), items}, random);
        if (testing::Test::HasFailure()) return cases;
        cases += 2;
      }
    }
  }
  return cases;
}
constexpr int kCases = 9 * 3 * 3 * 2;

TEST(BestFirst, BeamsMeetAllBoxesInTheExactOrder) {
  std::size_t met = 0;
  const int cases = for_each_case([&](const Case& of, Random& random) {
    for (int kind = 0; kind < 2 * test::kBeamKinds; ++kind) {
      const Beam beam = test::beam_of(kind % test::kBeamKinds, of.tree.bounds(), random);
      const auto expected =
          plain_ranking(of.items, [&](const CellBox& box) { return test::entry(beam, box); });
      std::size_t next = 0;
      of.tree.crossed_in_order(beam, [&](const CellBox& box, int payload, double enter) {
        EXPECT_LT(next, expected.size());
        EXPECT_EQ(box, expected[next].box);
        EXPECT_EQ(enter, expected[next].key);
        EXPECT_EQ(of.items[static_cast<std::size_t>(payload)].box, box);
        ++next;
        return 1.0;
      });
      ASSERT_EQ(next, expected.size());
      met += next;
    }
  });
  EXPECT_EQ(cases, kCases);
  EXPECT_GT(met, 10000u);
}

TEST(BestFirst, NothingComesThatEntersAtOrBeyondTheLimit) {
  std::size_t cut = 0;
  const int cases = for_each_case([&](const Case& of, Random& random) {
    for (int kind = 0; kind < test::kBeamKinds; ++kind) {
      const Beam beam = test::beam_of(kind, of.tree.bounds(), random);
      const auto ranking =
          plain_ranking(of.items, [&](const CellBox& box) { return test::entry(beam, box); });
      // Each box wants nothing beyond its own far side: what lies behind the nearest exit is cut.
      double limit = 2;
      std::size_t expected = 0;
      for (const Ranked& ranked : ranking) {
        if (!(ranked.key < limit)) break;
        limit = std::min(limit, crossing(beam, ranked.box)->leave);
        ++expected;
      }
      std::size_t visits = 0;
      of.tree.crossed_in_order(beam, [&](const CellBox& box, int, double enter) {
        EXPECT_EQ(enter, ranking[visits].key);
        ++visits;
        return crossing(beam, box)->leave;
      });
      ASSERT_EQ(visits, expected);
      cut += ranking.size() - expected;
    }
  });
  EXPECT_EQ(cases, kCases);
  EXPECT_GT(cut, 1000u);
}

TEST(BestFirst, WithoutAnOrderAllComeThatEnterBeforeTheLimit) {
  std::size_t met = 0;
  const int cases = for_each_case([&](const Case& of, Random& random) {
    for (int kind = 0; kind < test::kBeamKinds; ++kind) {
      const Beam beam = test::beam_of(kind, of.tree.bounds(), random);
      const auto ranking =
          plain_ranking(of.items, [&](const CellBox& box) { return test::entry(beam, box); });
      std::vector<double> all;
      of.tree.crossed_until(beam, [&](const CellBox& box, int payload, double enter) {
        EXPECT_EQ(of.items[static_cast<std::size_t>(payload)].box, box);
        EXPECT_EQ(enter, crossing(beam, box)->enter);
        all.push_back(enter);
        return 2.0;
      });
      std::sort(all.begin(), all.end());
      ASSERT_TRUE(
          std::equal(all.begin(), all.end(), ranking.begin(), ranking.end(),
                     [](double enter, const Ranked& ranked) { return enter == ranked.key; }));
      met += all.size();

      // Who looks for the least exit finds it.
      double least = 2;
      for (const Ranked& ranked : ranking) {
        least = std::min(least, crossing(beam, ranked.box)->leave);
      }
      double found = 2;
      of.tree.crossed_until(beam, [&](const CellBox& box, int, double enter) {
        EXPECT_LT(enter, found);
        found = std::min(found, crossing(beam, box)->leave);
        return found;
      });
      ASSERT_EQ(found, least);
    }
  });
  EXPECT_EQ(cases, kCases);
  EXPECT_GT(met, 10000u);
}

TEST(BestFirst, ALimitNeverRisesAgainAndEnterStops) {
  Tree tree({.max_branches = 4});
  for (int i = 0; i < 40; ++i) tree.insert(box_of({i, 0, 0}), i);
  const Beam beam({0, 0.5, 0.5}, {40, 0.5, 0.5}, false);
  std::vector<int> met;
  tree.crossed_in_order(beam, [&](const CellBox&, int payload, double) {
    met.push_back(payload);
    return payload == 2 ? 0.25 : 1;
  });
  EXPECT_EQ(met, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  met.clear();
  tree.crossed_in_order(beam, [&](const CellBox&, int payload, double enter) {
    met.push_back(payload);
    return enter;
  });
  EXPECT_EQ(met, (std::vector<int>{0}));
}

TEST(BestFirst, BoxesThatDoNotOverlapNeverEnterTogether) {
  Random random(1);
  SCOPED_TRACE(random.trace());
  const auto boxes = test::boxes_of(Data::lattice, 8, 512, random);
  Tree tree({.leaf_edge = 8});
  for (const CellBox& box : boxes) tree.insert(box, 0);
  for (int i = 0; i < 1000; ++i) {
    const Beam beam = test::beam_of(i % test::kBeamKinds, tree.bounds(), random);
    double last = -1;
    tree.crossed_in_order(beam, [&](const CellBox&, int, double enter) {
      EXPECT_LT(last, enter);
      last = enter;
      return 1;
    });
  }
}

TEST(BestFirst, NeighboursAreThePlainOnesInOrder) {
  int compared = 0;
  const int cases = for_each_case([&](const Case& of, Random& random) {
    for (int i = 0; i < 6; ++i) {
      Vector3d point = test::cell_of(of.tree.bounds(), random).cast<double>();
      if (i % 2 == 1) point += random.point(0, 1);
      const auto ranking =
          plain_ranking(of.items, [&](const CellBox& box) -> std::optional<double> {
            return test::squared_distance(point, box);
          });
      for (const std::size_t k :
           {std::size_t{0}, std::size_t{1}, std::size_t{7}, of.items.size(), of.items.size() + 1}) {
        const auto found = of.tree.nearest_k(point, k);
        ASSERT_EQ(found.size(), std::min(k, of.items.size()));
        for (std::size_t j = 0; j < found.size(); ++j) {
          ASSERT_EQ(found[j].box, ranking[j].box);
          ASSERT_EQ(found[j].distance, std::sqrt(ranking[j].key));
          ASSERT_EQ(of.items[static_cast<std::size_t>(found[j].payload)].box, found[j].box);
        }
        ++compared;
      }
      const auto nearest = of.tree.nearest(point);
      ASSERT_TRUE(nearest);
      ASSERT_EQ(nearest->box, ranking[0].box);
      ASSERT_EQ(nearest->distance, std::sqrt(ranking[0].key));
    }
  });
  EXPECT_EQ(cases, kCases);
  EXPECT_EQ(compared, kCases * 6 * 5);
}

TEST(BestFirst, TheEmptyTreeHasNothing) {
  const Tree tree;
  EXPECT_FALSE(tree.nearest({0, 0, 0}));
  EXPECT_TRUE(tree.nearest_k({0, 0, 0}, 3).empty());
  tree.crossed_in_order(Beam({0, 0, 0}, {1, 1, 1}, false), [](const CellBox&, int, double) {
    ADD_FAILURE();
    return 1;
  });
}

TEST(BestFirst, APointBeyondTheLimitsIsAnError) {
  Tree tree;
  tree.insert(box_of({0, 0, 0}), 1);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 0x1p30, 1e300}) {
    try {
      (void)tree.nearest({0, bad, 0});
      ADD_FAILURE() << "accepted " << bad;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::limit);
    }
  }
  EXPECT_EQ(tree.nearest({0, 0x1p29, 0})->distance, 0x1p29 - 1);
}

}  // namespace
}  // namespace rmap
