#include "approximation/cover_registry.hpp"

#include "approximation/plain_cells.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

/// By cell the boxes that cover it.
class PlainRegistry {
 public:
  explicit PlainRegistry(const CellSet& required) {
    for (const Cell& cell : required) covers_[cell];
  }
  void add(std::uint32_t box, const CellBox& covered) {
    test::for_each_cell_in(covered, [&](const Cell& cell) {
      if (covers_.contains(cell)) covers_[cell].insert(box);
    });
  }
  void remove(std::uint32_t box) {
    for (auto& [cell, boxes] : covers_) boxes.erase(box);
  }
  CellSet sole(std::uint32_t box) const {
    CellSet cells;
    for (const auto& [cell, boxes] : covers_) {
      if (boxes == std::set{box}) cells.insert(cell);
    }
    return cells;
  }
  double relief(const CellBox& covered) const {
    double relief = 0;
    for (const auto& [cell, boxes] : covers_) {
      if (!covered.contains(cell) || boxes.size() != 1) continue;
      relief += 1.0 / static_cast<double>(sole(*boxes.begin()).size());
    }
    return relief;
  }

 private:
  std::unordered_map<Cell, std::set<std::uint32_t>, CellHash> covers_;
};

TEST(CoverRegistry, EqualsAMapFromCellsToBoxes) {
  constexpr std::uint32_t kBoxes = 12;
  int compared = 0;
  for (const Cell& size : {Cell(10, 9, 8), Cell(64, 4, 5), Cell(130, 3, 4)}) {
    Random random(static_cast<std::uint64_t>(size.x()));
    SCOPED_TRACE(random.trace());
    const CellBox all{.min = Cell::Zero(), .max = size};
    BitRows rows(size, 0);
    CellSet required;
    test::for_each_cell_in(all, [&](const Cell& cell) {
      if (!random.chance(0.6)) return;
      rows.set(cell);
      required.insert(cell);
    });
    CoverRegistry registry(rows);
    registry.resize(kBoxes);
    PlainRegistry plain(required);
    std::map<std::uint32_t, CellBox> boxes;
    for (int step = 0; step < 120; ++step, ++compared) {
      const auto box = static_cast<std::uint32_t>(random.integer(0, kBoxes - 1));
      if (boxes.contains(box)) {
        registry.remove(box, boxes.at(box));
        plain.remove(box);
        boxes.erase(box);
        ASSERT_EQ(registry.sole(box), 0u);
      } else {
        const Cell low(random.integer(0, size.x() - 1), random.integer(0, size.y() - 1),
                       random.integer(0, size.z() - 1));
        CellBox covered{.min = low, .max = low + random.cell(1, 5)};
        if (random.chance(0.5)) covered.max.x() += size.x() / 2;
        covered = intersection(covered, all);
        std::map<std::uint32_t, std::size_t> before;
        for (const auto& [other, place] : boxes) before[other] = plain.sole(other).size();
        std::vector<std::uint32_t> idle;
        if (random.chance(0.5)) {
          registry.add(box, covered, idle);
          std::vector<std::uint32_t> expected;
          plain.add(box, covered);
          for (const auto& [other, own] : before) {
            if (own > 0 && plain.sole(other).empty()) expected.push_back(other);
          }
          std::sort(idle.begin(), idle.end());
          ASSERT_EQ(idle, expected);
        } else {
          registry.add(box, covered);
          plain.add(box, covered);
        }
        boxes[box] = covered;
      }
      for (const auto& [number, covered] : boxes) {
        const CellSet own = plain.sole(number);
        ASSERT_EQ(registry.sole(number), own.size());
        ASSERT_NEAR(registry.relief(covered), plain.relief(covered), 1e-9);
        if (own.empty()) continue;
        CellBox bounds = box_of(*own.begin());
        for (const Cell& cell : own) bounds = united(bounds, box_of(cell));
        ASSERT_EQ(registry.sole_bounds(number, covered), bounds);
      }
    }
  }
  EXPECT_EQ(compared, 3 * 120);
}

}  // namespace
}  // namespace rmap
