#include "evaluation/seen_cells.hpp"

#include "evaluation/sequence.hpp"

#include <rmap/beam.hpp>

namespace rmap::evaluation {

void CellSet::insert(const Cell& cell) {
  const Cell origin = block_origin(cell);
  if (last_ == nullptr || origin != last_origin_) {
    last_ = &blocks_[origin];
    last_origin_ = origin;
  }
  last_->set(block_position(cell));
}

bool CellSet::contains(const Cell& cell) const {
  const auto block = blocks_.find(block_origin(cell));
  return block != blocks_.end() && block->second.test(block_position(cell));
}

std::size_t CellSet::size() const {
  std::size_t size = 0;
  for (const auto& [origin, mask] : blocks_) size += mask.count();
  return size;
}

SeenCells seen_cells(const Scan& scan, const Lattice& lattice) {
  SeenCells seen;
  CellSet crossed;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Vector3d end = lattice.to_cells(scan.points[i].cast<double>());
    const auto end_cell = cell_at(end);
    if (!end_cell) continue;
    seen.ends.insert(*end_cell);
    const Beam beam(lattice.to_cells(beam_origin(scan, i)), end, false);
    if (beam.crosses_nothing()) continue;
    for (BeamWalk walk(beam, all_cells()); walk.more(); walk.advance()) crossed.insert(walk.cell());
  }
  crossed.for_each([&](const Cell& cell) {
    if (!seen.ends.contains(cell)) seen.path.insert(cell);
  });
  return seen;
}

}  // namespace rmap::evaluation
