#include "grid/block_table.hpp"

#include "support/plain_grid.hpp"
#include "support/random.hpp"

#include <map>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::Random;

// A table beside its plain twin, with numbers given out as a pool does: freed ones first.
class Twins {
  auto origin_of() const {
    return [this](std::uint32_t number) { return origins_.at(number); };
  }

 public:
  void add(const Cell& origin) {
    std::uint32_t number = static_cast<std::uint32_t>(origins_.size());
    if (free_.empty()) {
      origins_.push_back(origin);
    } else {
      number = free_.back();
      free_.pop_back();
      origins_[number] = origin;
    }
    table_.add(origin, number, origin_of());
    plain_[origin] = number;
  }
  void remove(const Cell& origin) {
    table_.remove(origin, origin_of());
    free_.push_back(plain_.at(origin));
    plain_.erase(origin);
  }
  std::optional<std::uint32_t> find(const Cell& origin) const {
    return table_.find(origin, origin_of());
  }
  void expect_equal() const {
    ASSERT_EQ(table_.size(), plain_.size());
    for (const auto& [origin, number] : plain_) ASSERT_EQ(find(origin), number);
  }

  const BlockTable& table() const { return table_; }
  const std::map<Cell, std::uint32_t, test::MortonOrder>& plain() const { return plain_; }

 private:
  BlockTable table_;
  std::map<Cell, std::uint32_t, test::MortonOrder> plain_;
  std::vector<Cell> origins_;
  std::vector<std::uint32_t> free_;
};

TEST(BlockTable, EqualsAMapWhileBlocksComeAndGo) {
  Random random(471);
  SCOPED_TRACE(random.trace());
  int added = 0;
  int removed = 0;
  int absent = 0;
  for (const int reach : {6, 40, 1 << 26}) {
    Twins twins;
    for (int phase = 0; phase < 4; ++phase) {
      // Grows, shrinks to nearly nothing, and grows again.
      const double growth = phase % 2 == 0 ? 0.8 : 0.15;
      for (int i = 0; i < 3000; ++i) {
        const Cell origin = 8 * random.cell(-reach, reach);
        const bool is_there = twins.plain().contains(origin);
        ASSERT_EQ(twins.find(origin).has_value(), is_there);
        absent += is_there ? 0 : 1;
        if (random.chance(growth)) {
          if (is_there) continue;
          twins.add(origin);
          ++added;
        } else if (!twins.plain().empty()) {
          const auto at_or_behind = twins.plain().lower_bound(origin);
          twins.remove(at_or_behind == twins.plain().end() ? twins.plain().begin()->first
                                                           : at_or_behind->first);
          ++removed;
        }
      }
      twins.expect_equal();
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(added, 5000);
  EXPECT_GT(removed, 5000);
  EXPECT_GT(absent, 5000);
}

TEST(BlockTable, TakesFiveToElevenBytesABlock) {
  Twins twins;
  int blocks = 0;
  for (int x = 0; x < 20; ++x) {
    for (int y = 0; y < 20; ++y) {
      for (int z = 0; z < 20; ++z) {
        twins.add({8 * x, 8 * y, 8 * z});
        if (++blocks < 64) continue;
        ASSERT_LE(3 * twins.table().bytes_in_use(), 32U * static_cast<unsigned>(blocks) + 32);
        ASSERT_GE(3 * twins.table().bytes_in_use(), 16U * static_cast<unsigned>(blocks));
      }
    }
  }
  EXPECT_EQ(blocks, 8000);
  twins.expect_equal();
}

}  // namespace
}  // namespace rmap
