#include "grid/block_marks.hpp"

namespace rmap {

namespace {

constexpr std::size_t kFirstSlots = 1024;

}  // namespace

BlockMarks::BlockMarks() : slots_(kFirstSlots, Slot{Cell::Zero(), 0}) {}

void BlockMarks::add(const BlockMarks& other) {
  for (const Block& block : other.blocks_) at(block.origin) |= block.cells;
}

std::size_t BlockMarks::added(const Cell& origin) {
  blocks_.push_back({origin, {}});
  slots_[slot_of(origin)] = {origin, static_cast<std::uint32_t>(blocks_.size())};
  if (2 * blocks_.size() > slots_.size()) grow();
  return blocks_.size() - 1;
}

void BlockMarks::grow() {
  slots_.assign(2 * slots_.size(), Slot{Cell::Zero(), 0});
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    slots_[slot_of(blocks_[i].origin)] = {blocks_[i].origin, static_cast<std::uint32_t>(i + 1)};
  }
}

}  // namespace rmap
