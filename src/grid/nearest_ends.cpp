#include "grid/nearest_ends.hpp"

#include <algorithm>
#include <tuple>

namespace rmap {

namespace {

constexpr std::size_t kFirstSlots = 4096;

auto coordinates(const Vector3d& point) { return std::make_tuple(point.x(), point.y(), point.z()); }

}  // namespace

NearestEnds::NearestEnds(const ScanBeams& beams) : beams_(&beams), slots_(kFirstSlots, 0) {}

void NearestEnds::add(const PointTile& tile) {
  tile.ends.for_each([&](std::size_t i) {
    const Cell cell = tile.cell_of(i);
    const Vector3d off = tile.end_of(i) - (cell.cast<double>().array() + 0.5).matrix();
    const double distance = (off.x() * off.x() + off.y() * off.y()) + off.z() * off.z();
    add(Entry{cell, tile.number(i), distance});
  });
}

void NearestEnds::add(const NearestEnds& other) {
  for (const Entry& entry : other.entries_) add(entry);
}

void NearestEnds::add(const Entry& entry) {
  // Neighbouring points mostly end in one cell.
  if (last_ >= entries_.size() || entries_[last_].cell != entry.cell) {
    const std::size_t slot = slot_of(entry.cell);
    if (slots_[slot] == 0) {
      last_ = entries_.size();
      entries_.push_back(entry);
      slots_[slot] = static_cast<std::uint32_t>(entries_.size());
      if (2 * entries_.size() > slots_.size()) grow();
      return;
    }
    last_ = slots_[slot] - 1;
  }
  if (is_nearer(entry, entries_[last_])) entries_[last_] = entry;
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

std::size_t NearestEnds::slot_of(const Cell& cell) const {
  std::size_t slot = CellHash()(cell);
  while (true) {
    slot &= slots_.size() - 1;
    if (slots_[slot] == 0 || entries_[slots_[slot] - 1].cell == cell) return slot;
    ++slot;
  }
}

void NearestEnds::grow() {
  slots_.assign(2 * slots_.size(), 0);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    slots_[slot_of(entries_[i].cell)] = static_cast<std::uint32_t>(i + 1);
  }
}

}  // namespace rmap
