#include <cmath>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/grid.hpp>
#include <rmap/options.hpp>

namespace rmap {
namespace {

std::string refusal(const Options& options) {
  try {
    check_options(options);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return error.what();
  }
  return "accepted";
}

TEST(CheckOptions, NamesTheFieldThatDoesNotFit) {
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  struct Case {
    std::function<void(Options&)> change;
    const char* expected;
  };
  const std::vector<Case> cases = {
      {[](Options& o) { o.resolution = 0; }, "resolution is 0 m"},
      {[&](Options& o) { o.resolution = nan; }, "resolution is nan m"},
      {[](Options& o) { o.prob_hit = 1; }, "prob_hit is 1"},
      {[&](Options& o) { o.prob_hit = nan; }, "prob_hit is nan"},
      {[](Options& o) { o.prob_hit = 0.5; }, "prior must be below prob_hit"},
      {[](Options& o) { o.prob_hit = 0.50000001; }, "the same when rounded"},
      {[](Options& o) { o.prob_miss = 0.5; }, "prob_miss must be below prior"},
      {[](Options& o) { o.prob_miss = 0; }, "prob_miss is 0"},
      {[](Options& o) { o.clamp_min = 0.6; }, "clamp_min must be below prior"},
      {[](Options& o) { o.clamp_max = 0.4; }, "prior must be below clamp_max"},
      {[](Options& o) { o.clamp_max = 1 - 1e-16; },
       "clamp_max is 0.9999999999999999: its log-odds"},
      {[](Options& o) { o.prior = 0; }, "prior is 0"},
      {[](Options& o) { o.occupied_threshold = 0.4; },
       "occupied_threshold is 0.4 and prior is 0.5"},
      {[](Options& o) { o.occupied_threshold = 1; }, "occupied_threshold is 1"},
      {[](Options& o) { o.free_probability = -0.1; }, "free_probability is -0.1"},
      {[&](Options& o) { o.free_probability = nan; }, "free_probability is nan"},
      {[](Options& o) { o.min_range = -1; }, "min_range is -1 m"},
      {[&](Options& o) { o.min_range = infinity; }, "min_range is inf m"},
      {[](Options& o) { o.max_range = 0; }, "max_range is 0 m"},
      {[](Options& o) { o.min_range = o.max_range = 2; }, "max_range is 2 m"},
      {[&](Options& o) { o.max_range = nan; }, "max_range is nan m"},
      {[](Options& o) { o.max_branches = 3; }, "max_branches is 3"},
      {[](Options& o) { o.max_branches = 65; }, "max_branches is 65"},
      {[](Options& o) { o.threads = -1; }, "threads is -1"},
  };
  for (const Case& example : cases) {
    Options options{.resolution = 0.1};
    example.change(options);
    EXPECT_THAT(refusal(options), testing::HasSubstr(example.expected));
    EXPECT_THROW(Grid{options}, Error);
  }
  EXPECT_EQ(refusal({.resolution = 0.1}), "accepted");
}

// Apart when each is rounded, but too near for a step.
TEST(CheckOptions, RefusesObservationsThatMoveNothing) {
  const auto probability = [](double log_odds) { return 1 / (1 + std::exp(-log_odds)); };
  Options hit{.resolution = 0.1, .occupied_threshold = 0.6};
  hit.prior = probability(0.00049);
  hit.prob_hit = probability(0.00051);
  EXPECT_THAT(refusal(hit), testing::AllOf(testing::HasSubstr("prob_hit is 0.50012"),
                                           testing::HasSubstr("prior is 0.50012"),
                                           testing::HasSubstr("log-odds is 0 when rounded")));
  Options miss{.resolution = 0.1, .occupied_threshold = 0.6};
  miss.prior = probability(0.00051);
  miss.prob_miss = probability(0.00049);
  EXPECT_THAT(refusal(miss), testing::AllOf(testing::HasSubstr("prob_miss is 0.50012"),
                                            testing::HasSubstr("log-odds is 0 when rounded")));
  hit.prob_hit = probability(0.0015);
  EXPECT_EQ(refusal(hit), "accepted");
}

TEST(UpdateRule, MovesValuesAsTheFormulaOfProbabilities) {
  const Options options{.resolution = 1,
                        .prob_hit = 0.8,
                        .prob_miss = 0.3,
                        .clamp_min = 0.01,
                        .clamp_max = 0.99,
                        .prior = 0.4};
  const UpdateRule rule(options);
  // [RMAP 2.2]: P = 1 / (1 + (1-Pz)/Pz * (1-P)/P * prior/(1-prior))
  const auto updated = [&](double p, double pz) {
    return 1 / (1 + (1 - pz) / pz * (1 - p) / p * options.prior / (1 - options.prior));
  };
  for (int percent = 5; percent < 90; percent += 5) {
    const double p = percent / 100.0;
    EXPECT_NEAR(probability_of(rule.hit(value_of(p))), updated(p, 0.8), 5e-4);
    EXPECT_NEAR(probability_of(rule.miss(value_of(p))), updated(p, 0.3), 5e-4);
  }
  EXPECT_EQ(rule.prior(), value_of(0.4));
  EXPECT_NEAR(probability_of(rule.prior()), 0.4, 5e-4);
}

TEST(UpdateRule, StopsAtTheLimitsAndComesBack) {
  const UpdateRule rule(Options{.resolution = 1});
  Value value = rule.prior();
  for (int i = 0; i < 20; ++i) value = rule.hit(value);
  EXPECT_EQ(value, value_of(0.971));
  EXPECT_EQ(rule.hit(value), value);
  EXPECT_LT(rule.miss(value), value);
  EXPECT_FALSE(rule.settled(value));
  for (int i = 0; i < 20; ++i) value = rule.miss(value);
  EXPECT_EQ(value, value_of(0.1192));
  EXPECT_TRUE(rule.settled(value));
  EXPECT_GT(rule.hit(value), value);
}

TEST(UpdateRule, FreezesAtTheLimitsWhenAsked) {
  const UpdateRule rule(Options{.resolution = 1, .saturation = Saturation::freeze});
  Value high = rule.prior();
  for (int i = 0; i < 20; ++i) high = rule.hit(high);
  EXPECT_EQ(high, value_of(0.971));
  EXPECT_EQ(rule.miss(high), high);
  EXPECT_TRUE(rule.settled(high));
  Value low = rule.prior();
  for (int i = 0; i < 20; ++i) low = rule.miss(low);
  EXPECT_EQ(rule.hit(low), low);
  EXPECT_TRUE(rule.settled(low));
}

TEST(UpdateRule, OccupiedIsAboveTheThreshold) {
  const UpdateRule rule(Options{.resolution = 1});
  EXPECT_FALSE(rule.occupied(rule.prior()));
  EXPECT_TRUE(rule.occupied(static_cast<Value>(rule.prior() + 1)));
}

TEST(Value, RoundsToTheNearestStep) {
  EXPECT_EQ(value_of(0.5), 0);
  EXPECT_EQ(value_of(0.7), 847);   // ln(7/3) = 0.8473
  EXPECT_EQ(value_of(0.4), -405);  // ln(2/3) = -0.4055
  EXPECT_EQ(value_of(0), std::numeric_limits<Value>::min());
  EXPECT_EQ(value_of(1), std::numeric_limits<Value>::max());
  for (int value = -20000; value <= 20000; value += 7) {
    EXPECT_EQ(value_of(probability_of(static_cast<Value>(value))), value);
  }
}

}  // namespace
}  // namespace rmap
