#include "grid/nearest_ends.hpp"

#include <algorithm>
#include <tuple>

namespace rmap {

namespace {

// Points that end in a cell, roughly.
constexpr std::size_t kPointsPerCell = 8;
// Sets the hashes of a block's cells apart.
constexpr std::uint32_t kPositionFactor = 0x27D4EB2FU;

auto coordinates(const Vector3d& point) { return std::make_tuple(point.x(), point.y(), point.z()); }

}  // namespace

NearestEnds::NearestEnds(const ScanBeams& beams)
    : beams_(&beams), places_(beams.size() / kPointsPerCell) {}

void NearestEnds::add(const PointTile& tile, const EndBlocks& blocks) {
  tile.ends.for_each([&](std::size_t i) {
    const Cell cell = tile.cell_of(i);
    const Vector3d off = tile.end_of(i) - (cell.cast<double>().array() + 0.5).matrix();
    const double distance = (off.x() * off.x() + off.y() * off.y()) + off.z() * off.z();
    const std::uint32_t hash = blocks.hash[i] + blocks.position[i] * kPositionFactor;
    add({.cell = cell, .hash = hash, .number = tile.number(i), .distance = distance});
  });
}

void NearestEnds::add(const NearestEnds& other) {
  for (const Entry& entry : other.entries_) add(entry);
}

void NearestEnds::add(const Entry& entry) {
  const std::uint32_t place = places_.add(
      entry.cell, entry.hash, [this](std::uint32_t i) -> const Cell& { return entries_[i].cell; });
  if (place == entries_.size()) {
    entries_.push_back(entry);
  } else if (is_nearer(entry, entries_[place])) {
    entries_[place] = entry;
  }
}

bool NearestEnds::is_nearer(const Entry& a, const Entry& b) const {
  if (a.distance != b.distance) return a.distance < b.distance;
  const SortedPoint first = beams_->sorted(a.number);
  const SortedPoint second = beams_->sorted(b.number);
  return std::make_tuple(coordinates(first.end), coordinates(first.origin)) <
         std::make_tuple(coordinates(second.end), coordinates(second.origin));
}

std::vector<std::uint32_t> NearestEnds::numbers() const {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(entries_.size());
  for (const Entry& entry : entries_) numbers.push_back(entry.number);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace rmap
