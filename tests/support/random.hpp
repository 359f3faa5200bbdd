#pragma once

#include <cstdint>
#include <random>
#include <string>

#include <rmap/beam.hpp>
#include <rmap/cell.hpp>

namespace rmap::test {

/// A seeded source of random test input. The seed comes from the environment
/// variable RMAP_SEED where that is set, else from the test; `trace()` belongs
/// into a SCOPED_TRACE so that a failure prints how to repeat it.
class Random {
 public:
  explicit Random(std::uint64_t default_seed);

  std::uint64_t seed() const { return seed_; }
  std::string trace() const { return "repeat with RMAP_SEED=" + std::to_string(seed_); }

  /// Uniform integer in [low, high].
  std::int32_t integer(std::int32_t low, std::int32_t high);
  /// Uniform in [low, high).
  double real(double low, double high);
  double gaussian(double sigma);
  bool chance(double probability) { return real(0, 1) < probability; }

  Cell cell(std::int32_t low, std::int32_t high);
  Vector3d point(double low, double high);
  /// A box with its lower corner in [low, high]^3 and edges of 1 to `max_edge` cells.
  CellBox box(std::int32_t low, std::int32_t high, std::int32_t max_edge);
  /// A vector of length 1, uniform on the sphere.
  Vector3d direction();

  std::mt19937_64& engine() { return engine_; }

 private:
  std::uint64_t seed_;
  std::mt19937_64 engine_;
};

}  // namespace rmap::test
