#include "grid/change_log.hpp"

#include <algorithm>
#include <limits>

namespace rmap {

void BoundedLog::add(const Cell& cell, std::uint64_t revision) {
  if (capacity_ == 0) return;
  if (entries_.size() < capacity_) {
    entries_.push_back({revision, cell});
    return;
  }
  horizon_ = entries_[oldest_].revision;
  entries_[oldest_] = {revision, cell};
  oldest_ = (oldest_ + 1) % capacity_;
}

void BoundedLog::restart(std::size_t capacity, std::uint64_t revision) {
  capacity_ = capacity;
  entries_ = {};
  oldest_ = 0;
  horizon_ = revision;
}

std::vector<Cell> BoundedLog::since(std::uint64_t revision) const {
  std::vector<Cell> cells;
  for (const Entry& entry : entries_) {
    if (entry.revision > revision) cells.push_back(entry.cell);
  }
  std::sort(cells.begin(), cells.end(), morton_less);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

bool ChangeLog::begin() {
  ++revision_;
  if (revision_ - base_ <= std::numeric_limits<Stamp>::max()) return true;
  base_ = revision_ - 1;
  erased_.restart(kErasedBlocks, base_);
  return false;
}

}  // namespace rmap
