#include <cmath>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/lattice.hpp>
#include <rmap/options.hpp>
#include <rmap/value.hpp>

namespace rmap {

namespace {

constexpr int kMaxThreads = 1024;

[[noreturn]] void refuse(const std::string& sentence) { throw Error(ErrorKind::input, sentence); }

// NaN fails every comparison, so it is refused here as well.
void require_probability(const char* name, double value) {
  if (!(value > 0 && value < 1)) {
    refuse(fmt::format("{} is {}: it must lie between 0 and 1", name, value));
  }
}

// `low` < `high` for probabilities, as they are and after rounding to steps.
void require_below(const char* low_name, double low, const char* high_name, double high) {
  if (!(low < high)) {
    refuse(fmt::format("{} is {} and {} is {}: {} must be below {}", low_name, low, high_name, high,
                       low_name, high_name));
  }
  if (value_of(low) >= value_of(high)) {
    refuse(fmt::format("{} is {} and {} is {}: their log-odds are the same when rounded to 1/1000",
                       low_name, low, high_name, high));
  }
}

// An observation that moves no value would be lost.
void require_step(const char* name, double probability, double prior) {
  if (step_of(probability, prior) == 0) {
    refuse(
        fmt::format("{} is {} and prior is {}: the difference of their log-odds is 0 when rounded "
                    "to 1/1000",
                    name, probability, prior));
  }
}

// Beyond it the range of 16 bits would cut the log-odds off.
void require_representable(const char* name, double probability) {
  constexpr double kLargest = 32.767;
  if (!(std::abs(std::log(probability / (1 - probability))) <= kLargest)) {
    refuse(fmt::format("{} is {}: its log-odds must lie within +-{}", name, probability, kLargest));
  }
}

void check_probabilities(const Options& options) {
  const std::pair<const char*, double> probabilities[] = {
      {"prior", options.prior},         {"prob_hit", options.prob_hit},
      {"prob_miss", options.prob_miss}, {"clamp_min", options.clamp_min},
      {"clamp_max", options.clamp_max}, {"occupied_threshold", options.occupied_threshold}};
  for (const auto& [name, value] : probabilities) {
    require_probability(name, value);
    require_representable(name, value);
  }
  require_below("clamp_min", options.clamp_min, "prior", options.prior);
  require_below("prior", options.prior, "clamp_max", options.clamp_max);
  require_below("prob_miss", options.prob_miss, "prior", options.prior);
  require_below("prior", options.prior, "prob_hit", options.prob_hit);
  require_step("prob_hit", options.prob_hit, options.prior);
  require_step("prob_miss", options.prob_miss, options.prior);
  if (!(options.prior <= options.occupied_threshold)) {
    refuse(
        fmt::format("occupied_threshold is {} and prior is {}: a cell of which nothing is known "
                    "must not be occupied, so the threshold must not be below the prior",
                    options.occupied_threshold, options.prior));
  }
  if (!(options.free_probability >= 0 && options.free_probability <= 1)) {
    refuse(fmt::format("free_probability is {}: it must lie in 0 to 1", options.free_probability));
  }
}

void check_ranges(const Options& options) {
  if (!(options.min_range >= 0 && std::isfinite(options.min_range))) {
    refuse(fmt::format("min_range is {} m: it must be finite and not negative", options.min_range));
  }
  if (!(options.max_range > options.min_range)) {
    refuse(fmt::format("max_range is {} m: it must be above min_range, which is {} m",
                       options.max_range, options.min_range));
  }
}

}  // namespace

void check_options(const Options& options) {
  const Lattice lattice(options.resolution);  // checks the resolution
  check_probabilities(options);
  check_ranges(options);
  if (options.max_branches < 4 || options.max_branches > 64) {
    refuse(fmt::format("max_branches is {}: it must lie in 4 to 64", options.max_branches));
  }
  if (options.threads < 0 || options.threads > kMaxThreads) {
    refuse(fmt::format("threads is {}: it must lie in 0 (all cores) to {}", options.threads,
                       kMaxThreads));
  }
}

}  // namespace rmap
