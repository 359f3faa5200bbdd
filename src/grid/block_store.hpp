#pragma once

#include "grid/leaf_store.hpp"
#include "grid/value_pool.hpp"

namespace rmap {

/// Layout blocks: a leaf is a block of 8 x 8 x 8 cells, a 512-bit mask of those
/// that exist and values for only those, found by rank (population count).
class BlockStore final : public LeafStore {
 public:
  explicit BlockStore(const Options& options);
  std::unique_ptr<LeafStore> clone() const override;

  Leaf leaf(LeafId id, const Cell& origin) const override;
  std::span<Value> values(LeafId id) override;
  LeafId id_limit() const override { return static_cast<LeafId>(masks_.slots()); }
  BytesInUse bytes_in_use() const override;
  Stamp stamp(LeafId id) const override { return blocks_.record(id)->stamp; }
  void set_stamp(LeafId id, Stamp stamp) override { blocks_.record(id)->stamp = stamp; }

 private:
  struct Block {
    ValuePool::Handle values;  ///< a run as long as the mask has positions; none when it is empty
    Stamp stamp;
  };

  LeafId allocate() override;
  void release(LeafId id) override;
  void add_cells(LeafId id, const CellMask& cells, Value value) override;
  void take_cells(LeafId id, const CellMask& cells) override;
  std::optional<std::string> check_storage() const override;

  RecordPool<CellMask> masks_;
  RecordPool<Block> blocks_;  ///< the same numbers as masks_
  ValuePool values_;
};

}  // namespace rmap
