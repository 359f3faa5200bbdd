#pragma once

#include "simulation/exact_math.hpp"

#include <cstdint>

namespace rmap::simulation {

/// Random numbers for one beam of one scan, the same on every target: splitmix64
/// from a start that is a hash of the seed and both indices. So no beam's chance
/// depends on what was simulated before it.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t scan, std::uint64_t beam)
      : state_(mixed(mixed(mixed(seed) + scan) + beam)) {}

  std::uint64_t bits() { return mixed(state_ += 0x9E3779B97F4A7C15u); }

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  /// Normal, mean 0, standard deviation 1 (Box and Muller).
  double gaussian() {
    const double radius = std::sqrt(-2 * natural_log(1 - uniform()));
    return radius * sine_cosine_of_turns(uniform()).cosine;
  }

 private:
  // The finaliser of splitmix64: a bijection in which each bit depends on all.
  static std::uint64_t mixed(std::uint64_t value) {
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9u;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBu;
    return value ^ (value >> 31);
  }

  std::uint64_t state_;
};

}  // namespace rmap::simulation
