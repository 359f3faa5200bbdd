#include "simulation/random_stream.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace rmap::simulation {
namespace {

constexpr int kDraws = 200000;

TEST(RandomStream, same_indices_give_the_same_numbers) {
  RandomStream a(7, 3, 5);
  RandomStream b(7, 3, 5);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(RandomStream, other_seeds_scans_and_beams_give_other_numbers) {
  std::set<std::uint64_t> first;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (std::uint64_t scan = 0; scan < 20; ++scan) {
      for (std::uint64_t beam = 0; beam < 20; ++beam) {
        first.insert(RandomStream(seed, scan, beam).bits());
      }
    }
  }
  EXPECT_EQ(first.size(), 8000u);
}

// The bounds are five standard deviations of the estimate.
TEST(RandomStream, uniform_numbers_are_uniform_across_beams) {
  double sum = 0;
  double squares = 0;
  double neighbours = 0;
  double last = 0.5;
  for (int beam = 0; beam < kDraws; ++beam) {
    const double value = RandomStream(1, 2, static_cast<std::uint64_t>(beam)).uniform();
    ASSERT_GE(value, 0);
    ASSERT_LT(value, 1);
    sum += value;
    squares += (value - 0.5) * (value - 0.5);
    neighbours += (value - 0.5) * (last - 0.5);
    last = value;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 5 * std::sqrt(1.0 / 12 / kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0 / 12, 5 * std::sqrt(1.0 / 180 / kDraws));
  EXPECT_NEAR(neighbours / kDraws, 0, 5 * std::sqrt(1.0 / 144 / kDraws));
}

TEST(RandomStream, gaussian_numbers_are_normal) {
  RandomStream random(5, 0, 0);
  double sum = 0;
  double squares = 0;
  int within_one = 0;
  int beyond_three = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double value = random.gaussian();
    sum += value;
    squares += value * value;
    if (std::abs(value) < 1) ++within_one;
    if (std::abs(value) > 3) ++beyond_three;
  }
  EXPECT_NEAR(sum / kDraws, 0, 5 * std::sqrt(1.0 / kDraws));
  EXPECT_NEAR(squares / kDraws, 1, 5 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(within_one, 0.682689 * kDraws, 5 * std::sqrt(0.2166 * kDraws));
  EXPECT_NEAR(beyond_three, 0.002700 * kDraws, 5 * std::sqrt(0.0027 * kDraws));
}

}  // namespace
}  // namespace rmap::simulation
