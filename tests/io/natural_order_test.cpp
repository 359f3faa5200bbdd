#include "io/natural_order.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rmap {
namespace {

TEST(NaturalOrder, counts_as_people_do) {
  const std::vector<std::string> sorted = {"",
                                           "2.bin",
                                           "10.bin",
                                           "a",
                                           "a01",
                                           "a1",
                                           "a1b",
                                           "a2",
                                           "a10",
                                           "a10b2",
                                           "a10b12",
                                           "b0",
                                           "b00",
                                           "scan2_9",
                                           "scan10_1",
                                           "scan99999999999999999999998",
                                           "scan99999999999999999999999",
                                           "scan100000000000000000000000",
                                           "\xc3\xa4"};
  int pairs = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t j = 0; j < sorted.size(); ++j, ++pairs) {
      EXPECT_EQ(natural_less(sorted[i], sorted[j]), i < j) << sorted[i] << " " << sorted[j];
    }
  }
  EXPECT_EQ(pairs, 19 * 19);
}

TEST(NaturalOrder, is_a_strict_total_order) {
  test::Random random(2);
  SCOPED_TRACE(random.trace());
  std::vector<std::string> names;
  for (int i = 0; i < 60; ++i) {
    std::string name;
    for (int length = random.integer(0, 5); length > 0; --length) {
      name += "019a."[random.integer(0, 4)];
    }
    names.push_back(name);
  }
  int triples = 0;
  for (const auto& a : names) {
    for (const auto& b : names) {
      ASSERT_EQ(natural_less(a, b) || natural_less(b, a), a != b) << a << " " << b;
      ASSERT_FALSE(natural_less(a, b) && natural_less(b, a)) << a << " " << b;
      for (const auto& c : names) {
        if (natural_less(a, b) && natural_less(b, c)) {
          ASSERT_TRUE(natural_less(a, c)) << a << " " << b << " " << c;
        }
        ++triples;
      }
    }
  }
  EXPECT_EQ(triples, 60 * 60 * 60);
}

}  // namespace
}  // namespace rmap
