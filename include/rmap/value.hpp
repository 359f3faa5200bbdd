#pragma once

#include <cstdint>

#include <rmap/options.hpp>

namespace rmap {

/// Log-odds of a cell in steps of 1/1000.
using Value = std::int16_t;

/// Value of a probability, rounded to the nearest step; 0 and 1 become the ends of the range.
Value value_of(double probability);
/// Probability of a value: 1 / (1 + exp(-value / 1000)).
double probability_of(Value value);
/// How far an observation of `probability` moves a value: logit(probability) - logit(prior),
/// rounded to the nearest step.
std::int32_t step_of(double probability, double prior);

/// How hits and misses move a value [RMAP 2.2, Moravec and Elfes 1985]: value +
/// step, then clamp. Integers, converted once from the options, so that every
/// machine computes the same.
class UpdateRule {
 public:
  /// Throws what `check_options` throws.
  explicit UpdateRule(const Options& options);

  Value prior() const { return prior_; }
  bool occupied(Value value) const { return value > threshold_; }

  Value hit(Value value) const { return frozen(value) ? value : moved(value, hit_step_); }
  Value miss(Value value) const { return frozen(value) ? value : moved(value, miss_step_); }
  Value clamped(std::int32_t value) const {
    return static_cast<Value>(value < min_ ? min_ : value > max_ ? max_ : value);
  }
  /// Whether a miss cannot change the value.
  bool settled(Value value) const { return value == min_ || frozen(value); }

 private:
  Value moved(Value value, std::int32_t step) const { return clamped(value + step); }
  bool frozen(Value value) const { return freeze_ && (value <= min_ || value >= max_); }

  Value prior_;
  Value threshold_;
  std::int32_t min_;
  std::int32_t max_;
  std::int32_t hit_step_;
  std::int32_t miss_step_;
  bool freeze_;
};

}  // namespace rmap
