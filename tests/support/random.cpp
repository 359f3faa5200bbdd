#include "support/random.hpp"

#include <cstdlib>

namespace rmap::test {

namespace {

std::uint64_t chosen_seed(std::uint64_t default_seed) {
  const char* text = std::getenv("RMAP_SEED");
  return text == nullptr ? default_seed : std::strtoull(text, nullptr, 10);
}

}  // namespace

Random::Random(std::uint64_t default_seed) : seed_(chosen_seed(default_seed)), engine_(seed_) {}

std::int32_t Random::integer(std::int32_t low, std::int32_t high) {
  return std::uniform_int_distribution<std::int32_t>(low, high)(engine_);
}

double Random::real(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(engine_);
}

double Random::gaussian(double sigma) {
  return std::normal_distribution<double>(0, sigma)(engine_);
}

Cell Random::cell(std::int32_t low, std::int32_t high) {
  const std::int32_t x = integer(low, high);
  const std::int32_t y = integer(low, high);
  return {x, y, integer(low, high)};
}

Vector3d Random::point(double low, double high) {
  const double x = real(low, high);
  const double y = real(low, high);
  return {x, y, real(low, high)};
}

CellBox Random::box(std::int32_t low, std::int32_t high, std::int32_t max_edge) {
  const Cell min = cell(low, high);
  return {.min = min, .max = min + cell(1, max_edge)};
}

Vector3d Random::direction() {
  for (;;) {
    const Vector3d candidate = point(-1, 1);
    const double length = candidate.norm();
    if (length > 0.1 && length <= 1) return candidate / length;
  }
}

}  // namespace rmap::test
