#include "command/command.hpp"
#include "support/random.hpp"

#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <rmap/box_query.hpp>
#include <rmap/cast_ray.hpp>
#include <rmap/cells.hpp>
#include <rmap/map_file.hpp>
#include <rmap/multiresolution.hpp>

namespace rmap::test {

namespace {

using testing::HasSubstr;

// The answers of the command are those of the library on the same map.
class Query : public CommandTest {
 protected:
  Query() : grid_({.resolution = 0.25, .free_probability = 0.05}), random_(71) {
    for (int i = 0; i < 400; ++i) grid_.set(random_.cell(-12, 12), random_.real(0.1, 0.97));
    save(grid_, folder() / "map.rmap");
  }

  std::vector<nlohmann::json> query(std::vector<std::string> arguments,
                                    const std::string& input = {}) const {
    arguments.insert(arguments.begin(), {"query", "map.rmap"});
    arguments.emplace_back("--json");
    return rmap_done(arguments, {.input = input}).json_lines();
  }

  std::string text(const Vector3d& vector) {
    return fmt::format("{},{},{}", vector.x(), vector.y(), vector.z());
  }

  Grid grid_;
  Random random_;
};

TEST_F(Query, Points) {
  SCOPED_TRACE(random_.trace());
  std::string list = "# points\n\n";
  std::vector<Vector3d> points{{-1, 0.5, 0.25}};
  for (int i = 0; i < 500; ++i) {
    points.push_back(random_.point(-4, 4));
    list += text(points.back()) + (i % 2 == 0 ? "  # comment\r\n" : "\n");
  }
  const auto answers = query({"point", "-1,0.5,0.25", "--from", "-"}, list);
  ASSERT_EQ(answers.size(), 501u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(answers[i]["point"], numbers(points[i]));
    EXPECT_EQ(answers[i]["probability"], grid_.point_probability(points[i]));
    const State state = grid_.state(points[i]);
    EXPECT_EQ(answers[i]["state"], state == State::occupied ? "occupied"
                                   : state == State::free   ? "free"
                                                            : "assumed_free");
  }
}

TEST_F(Query, BoxesByBothCriteria) {
  SCOPED_TRACE(random_.trace());
  std::string list;
  std::vector<Box> boxes;
  for (int i = 0; i < 200; ++i) {
    const Vector3d min = random_.point(-4, 2);
    boxes.push_back({.min = min, .max = min + random_.point(0.1, 3)});
    list += text(boxes.back().min) + " " + text(boxes.back().max) + "\n";
  }
  write("boxes.txt", list);
  for (const Criterion criterion : {Criterion::mean, Criterion::max}) {
    const char* word = criterion == Criterion::mean ? "mean" : "max";
    const auto answers = query({"box", "--from", "boxes.txt", "--criterion", word});
    ASSERT_EQ(answers.size(), boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const BoxOccupancy expected = box_occupancy(grid_, boxes[i]);
      EXPECT_EQ(answers[i]["mean"], expected.mean);
      EXPECT_EQ(answers[i]["max"], expected.max);
      EXPECT_EQ(answers[i]["cells"], expected.cells);
      EXPECT_EQ(answers[i]["existing_cells"], expected.existing);
      EXPECT_EQ(answers[i]["occupied_cells"], expected.occupied);
      EXPECT_EQ(answers[i]["box"]["min"], numbers(grid_.lattice().metric(expected.box).min));
      EXPECT_EQ(answers[i]["occupied"], box_occupied(grid_, boxes[i], criterion));
      EXPECT_EQ(answers[i]["criterion"], word);
    }
  }
}

TEST_F(Query, Rays) {
  SCOPED_TRACE(random_.trace());
  std::string list;
  std::vector<std::array<Vector3d, 2>> rays;
  for (int i = 0; i < 300; ++i) {
    rays.push_back({random_.point(-4, 4), random_.direction() * 3});
    list += text(rays.back()[0]) + "," + text(rays.back()[1]) + "\n";
  }
  int hits = 0;
  const auto answers = query({"cast", "--from", "-", "--max-range", "7.5"}, list);
  ASSERT_EQ(answers.size(), rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto expected = cast_ray(grid_, rays[i][0], rays[i][1], 7.5);
    ASSERT_EQ(answers[i]["hit"], expected.has_value());
    if (!expected) continue;
    ++hits;
    EXPECT_EQ(answers[i]["distance"], expected->distance);
    EXPECT_EQ(answers[i]["point"], numbers(expected->point));
  }
  EXPECT_GT(hits, 20);
  EXPECT_EQ(query({"cast", "0,0,0", "1,0,0", "0,0,0", "-1,0,0"}).size(), 2u);
}

TEST_F(Query, CellsOfARegion) {
  const auto expect_cells = [&](const std::vector<std::string>& arguments,
                                const CellSelection& selection) {
    SCOPED_TRACE(testing::PrintToString(arguments));
    const auto answers = query(arguments);
    std::size_t i = 0;
    for (const auto& [cell, value] : cells(grid_, selection)) {
      ASSERT_LT(i, answers.size());
      EXPECT_EQ(answers[i]["center"], numbers(grid_.lattice().center(cell)));
      EXPECT_EQ(answers[i]["size"], 0.25);
      EXPECT_EQ(answers[i]["probability"], probability_of(value));
      EXPECT_EQ(answers[i]["state"], grid_.rule().occupied(value) ? "occupied" : "free");
      ++i;
    }
    EXPECT_EQ(i, answers.size());
    EXPECT_GT(i, 5u);
  };
  const Box box{.min = {-2, -1, 0}, .max = {2, 2, 2}};
  const Sphere sphere{.center = {0.5, 0, 0}, .radius = 2};
  expect_cells({"cells"}, {});
  expect_cells({"cells", "--occupied"}, {.occupied_only = true});
  expect_cells({"cells", "--box", "-2,-1,0,2,2,2"}, {.box = box});
  expect_cells({"cells", "--sphere", "0.5,0,0,2"}, {.sphere = sphere});
  expect_cells({"cells", "--sphere", "0.5,0,0,2", "--box", "-2,-1,0,2,2,2", "--occupied"},
               {.box = box, .sphere = sphere, .occupied_only = true});
}

TEST_F(Query, CellsNearFineAndFarCoarse) {
  const auto edge_in = [](const Box& place) {
    const Vector3d center(1, 0, 0);
    return 0.5 * std::max(0.0, (place.nearest(center) - center).norm() - 1.5);
  };
  for (const Criterion criterion : {Criterion::mean, Criterion::max}) {
    const auto answers = query({"cells", "--center", "1,0,0", "--growth", "0.5", "--fine", "1.5",
                                "--criterion", criterion == Criterion::mean ? "mean" : "max"});
    const auto expected = cells_at(grid_, edge_in);
    ASSERT_EQ(answers.size(), expected.size());
    std::set<double> sizes;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const Box box = grid_.lattice().metric(expected[i].box);
      EXPECT_EQ(answers[i]["center"], numbers((box.min + box.max) / 2));
      EXPECT_EQ(answers[i]["size"], box.max.x() - box.min.x());
      EXPECT_EQ(answers[i]["probability"],
                criterion == Criterion::mean ? expected[i].mean : expected[i].max);
      sizes.insert(answers[i]["size"].get<double>());
    }
    EXPECT_GE(sizes.size(), 3u);
    EXPECT_EQ(*sizes.begin(), 0.25);
  }
}

// However fast cubes may grow, the cells at the centre stay single.
TEST_F(Query, CellsAtTheCentreAreFineForEveryGrowth) {
  grid_.set({4, 0, 0}, 0.9);  // holds the centre
  save(grid_, folder() / "map.rmap");
  for (const char* growth : {"0.05", "1.2", "3", "inf"}) {
    double at_center = 0;
    for (const auto& answer : query({"cells", "--center", "1.1,0.1,0.1", "--growth", growth})) {
      const double size = answer["size"];
      bool holds = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double offset = (axis == 0 ? 1.1 : 0.1) - answer["center"][axis].get<double>();
        holds = holds && std::abs(offset) <= size / 2;
      }
      if (holds) at_center = size;
    }
    EXPECT_EQ(at_center, 0.25) << growth;
  }
}

TEST_F(Query, JsonMayStandAnywhere) {
  const std::string expected = rmap_done({"query", "map.rmap", "point", "1,2,3", "--json"}).out;
  EXPECT_EQ(rmap_done({"query", "--json", "map.rmap", "point", "1,2,3"}).out, expected);
  EXPECT_EQ(rmap_done({"query", "map.rmap", "--json", "point", "1,2,3"}).out, expected);
}

TEST_F(Query, CountsAreIntegers) {
  const auto small = query({"box", "0,0,0,1,1,1"}).front();
  EXPECT_TRUE(small["cells"].is_number_integer());
  EXPECT_EQ(small["cells"], 64);
  const auto all =
      rmap_done({"query", "map.rmap", "--json", "box", "--", "-inf,-inf,-inf,inf,inf,inf"}).json();
  EXPECT_EQ(all["cells"], std::pow(2.0, 93));
}

TEST_F(Query, TablesBeginWithTheirFirstRow) {
  EXPECT_THAT(rmap_done({"query", "map.rmap", "point", "1,2,3"}).out, HasSubstr("probability"));
  for (const std::vector<std::string>& request : {std::vector<std::string>{"point", "1e300,0,0"},
                                                  {"cast", "0,0,0", "0,0,0"},
                                                  {"box", "0,0,0,0,1,1"},
                                                  {"cells", "--box", "0,0,0,0,1,1"}}) {
    std::vector<std::string> call{"query", "map.rmap"};
    call.insert(call.end(), request.begin(), request.end());
    EXPECT_EQ(rmap(call).out, "");
    rmap_refused(1, call);
  }
}

TEST_F(Query, WrongRequestsAreNamed) {
  write("bad.txt", "1,2,3\n4,5\n");
  EXPECT_THAT(
      rmap_refused(1, {"query", "map.rmap", "point", "--from", "bad.txt"}),
      testing::AllOf(HasSubstr("bad.txt, line 2"), HasSubstr("\"4,5\""), HasSubstr("3 numbers")));
  EXPECT_THAT(rmap_refused(1, {"query", "map.rmap", "box", "--from", "-"},
                           {.input = "0,0,0,1,1,1\n# more\n0,0,0,0,1,1\n"}),
              testing::AllOf(HasSubstr("standard input, line 3"), HasSubstr("empty")));
  EXPECT_THAT(rmap_refused(1, {"query", "map.rmap", "point", "--from", "-"},
                           {.input = std::string(10000, '1')}),
              HasSubstr("line 1 is longer"));
  EXPECT_THAT(rmap_refused(1, {"query", "map.rmap", "point", "--from", "-"},
                           {.input = "1,2,3\n1,2,3" + std::string(1, '\0') + ",4\n"}),
              HasSubstr("standard input, line 2 holds a zero byte"));
  EXPECT_THAT(rmap_refused(1, {"query", "map.rmap", "point", "--from", "none.txt"}),
              testing::AllOf(HasSubstr("none.txt"), HasSubstr("No such file")));
  EXPECT_THAT(rmap_refused(1, {"query", "map.rmap", "point", "--from", "."}), HasSubstr("."));
  EXPECT_THAT(rmap_refused(1, {"query", "map.rmap", "point", "1e300,0,0"}),
              HasSubstr("beyond what a map can hold"));
  EXPECT_THAT(rmap_refused(1, {"query", "map.rmap", "cast", "0,0,0", "0,0,0"}),
              HasSubstr("direction"));
  EXPECT_THAT(rmap_refused(1, {"query", "map.rmap", "cells", "--box", "1,1,1,0,0,0"}),
              HasSubstr("empty"));
}

}  // namespace

}  // namespace rmap::test
