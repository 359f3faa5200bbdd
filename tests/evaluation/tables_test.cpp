#include "evaluation/tables.hpp"

#include <gtest/gtest.h>

namespace rmap::evaluation {
namespace {

TEST(Tables, HaveAHeaderAndQuoteWhatNeedsIt) {
  const std::vector<Json> rows{{{"map", "cells, M = 8"}, {"bytes", 12}, {"extract_ms", nullptr}},
                               {{"map", "a \"b\""}, {"bytes", 3}, {"extract_ms", 0.5}}};
  EXPECT_EQ(csv_of(rows), "map,bytes,extract_ms\n\"cells, M = 8\",12,\n\"a \"\"b\"\"\",3,0.5\n");
  EXPECT_EQ(csv_of({}), "");
}

}  // namespace
}  // namespace rmap::evaluation
