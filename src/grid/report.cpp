#include <rmap/report.hpp>

namespace rmap {

SkippedPoints& SkippedPoints::operator+=(const SkippedPoints& other) {
  not_finite += other.not_finite;
  too_near += other.too_near;
  beyond_limits += other.beyond_limits;
  no_range += other.no_range;
  return *this;
}

InsertReport& InsertReport::operator+=(const InsertReport& other) {
  points += other.points;
  inserted += other.inserted;
  cut += other.cut;
  skipped += other.skipped;
  end_cells += other.end_cells;
  new_cells += other.new_cells;
  hits += other.hits;
  misses += other.misses;
  return *this;
}

PrepareReport& PrepareReport::operator+=(const PrepareReport& other) {
  points += other.points;
  skipped += other.skipped;
  end_cells += other.end_cells;
  new_cells += other.new_cells;
  return *this;
}

}  // namespace rmap
