#include "grid/beam_groups.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <unordered_map>

namespace rmap {

namespace {

// By bits: two zeros of different sign start the same beams, but then as two groups.
struct BitsHash {
  std::size_t operator()(const Vector3d& point) const {
    std::uint64_t hash = 0;
    for (const double coordinate : point) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};
struct SameBits {
  bool operator()(const Vector3d& a, const Vector3d& b) const {
    return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
      return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    });
  }
};

}  // namespace

std::vector<BeamGroup> groups_by_origin(const ScanBeams& beams) {
  if (beams.scan().origins.empty()) {
    return {{.origin = beams.origin(0), .numbers = {}, .size = beams.size()}};
  }
  std::vector<std::uint32_t> all(beams.size());
  std::iota(all.begin(), all.end(), 0U);
  return groups_by_origin(beams, all);
}

std::vector<BeamGroup> groups_by_origin(const ScanBeams& beams,
                                        std::span<const std::uint32_t> numbers) {
  std::vector<BeamGroup> groups;
  std::unordered_map<Vector3d, std::size_t, BitsHash, SameBits> places;
  for (const std::uint32_t number : numbers) {
    const Vector3d& origin = beams.origin(number);
    // Firings follow one another.
    if (groups.empty() || !SameBits()(groups.back().origin, origin)) {
      const auto [place, is_new] = places.try_emplace(origin, groups.size());
      if (is_new) groups.push_back({.origin = origin, .numbers = {}, .size = 0});
      BeamGroup& group = groups[place->second];
      group.numbers.push_back(number);
      ++group.size;
    } else {
      groups.back().numbers.push_back(number);
      ++groups.back().size;
    }
  }
  return groups;
}

}  // namespace rmap
