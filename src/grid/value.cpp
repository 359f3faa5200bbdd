#include <algorithm>
#include <cmath>
#include <limits>

#include <rmap/value.hpp>

namespace rmap {

namespace {

constexpr double kSteps = 1000;

double log_odds(double probability) { return std::log(probability / (1 - probability)); }

double in_range(double steps) {
  return std::clamp<double>(steps, std::numeric_limits<Value>::min(),
                            std::numeric_limits<Value>::max());
}

}  // namespace

Value value_of(double probability) {
  return static_cast<Value>(in_range(std::round(kSteps * log_odds(probability))));
}

double probability_of(Value value) { return 1 / (1 + std::exp(-value / kSteps)); }

std::int32_t step_of(double probability, double prior) {
  return static_cast<std::int32_t>(std::round(kSteps * (log_odds(probability) - log_odds(prior))));
}

UpdateRule::UpdateRule(const Options& options) {
  check_options(options);
  prior_ = value_of(options.prior);
  threshold_ = value_of(options.occupied_threshold);
  min_ = value_of(options.clamp_min);
  max_ = value_of(options.clamp_max);
  hit_step_ = step_of(options.prob_hit, options.prior);
  miss_step_ = step_of(options.prob_miss, options.prior);
  freeze_ = options.saturation == Saturation::freeze;
}

}  // namespace rmap
