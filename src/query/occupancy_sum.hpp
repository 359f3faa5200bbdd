#pragma once

#include <algorithm>
#include <cmath>

#include <rmap/grid.hpp>

namespace rmap {

/// The sum of eq. 1 over cells that come in any order: probabilities in fixed
/// point (2^-52), so that the result does not depend on the order.
class OccupancySum {
 public:
  void add(Value value) {
    const double probability = probability_of(value);
    sum_ += static_cast<Sum>(std::llround(probability * kOne));
    max_ = std::max(max_, value);
    ++existing_;
  }

  std::uint64_t existing() const { return existing_; }
  /// Mean over `cells` cells, those not added counting `free_probability`.
  double mean(double cells, double free_probability) const {
    const double absent = cells - static_cast<double>(existing_);
    return (static_cast<double>(sum_) / kOne + absent * free_probability) / cells;
  }
  /// Largest probability of `cells` cells.
  double max(double cells, double free_probability) const {
    const bool some_absent = static_cast<double>(existing_) < cells;
    const double largest = existing_ > 0 ? probability_of(max_) : 0;
    return some_absent ? std::max(largest, free_probability) : largest;
  }

 private:
  __extension__ using Sum = unsigned __int128;
  static constexpr double kOne = 0x1p52;

  Sum sum_ = 0;
  Value max_ = std::numeric_limits<Value>::min();
  std::uint64_t existing_ = 0;
};

}  // namespace rmap
