#pragma once

#include "grid/block_table.hpp"
#include "grid/leaf_store.hpp"
#include "grid/value_pool.hpp"

#include <array>

namespace rmap {

/// Layout blocks: a leaf is a block of 8 x 8 x 8 cells, a mask of those that exist and
/// values for only those, found by rank (population count), packed in one run. Who asks for
/// one block finds it in a table, not in the R-tree.
class BlockStore final : public LeafStore {
 public:
  explicit BlockStore(const Options& options);
  std::unique_ptr<LeafStore> clone() const override;

  std::optional<LeafId> find(const Cell& origin) const override;
  void visit_block(const Cell& block,
                   FunctionRef<void(LeafId, const Cell& origin)> visit) const override;
  const Value* find_value(const Cell& cell) const override;
  void visit_along(const Beam& beam, VisitAlong visit) const override;
  Leaf leaf(LeafId id, const Cell& origin) const override;
  Content content(LeafId id) override;
  void prefetch(LeafId id) const override;
  LeafId id_limit() const override { return static_cast<LeafId>(blocks_.slots()); }
  BytesInUse bytes_in_use() const override;
  Stamp stamp(LeafId id) const override { return blocks_.record(id)->stamp; }
  void set_stamp(LeafId id, Stamp stamp) override { blocks_.record(id)->stamp = stamp; }

 private:
  struct Block {
    ValuePool::Handle run;  ///< a packed_block; none when it has no cells
    Stamp stamp;
    std::array<std::int32_t, 3> origin;
  };

  LeafId allocate(const Cell& origin) override;
  void release(LeafId id) override;
  void add_cells(LeafId id, const CellMask& cells, Value value) override;
  void take_cells(LeafId id, const CellMask& cells) override;
  std::optional<std::string> check_storage() const override;

  static constexpr ValuePool::Handle kNoRun = UINT32_MAX;

  /// Makes room for other cells, writes which they are and returns where their values go.
  Value* replace(LeafId id, const CellMask& before, const CellMask& after);
  Value* run(LeafId id) { return runs_.at(blocks_.record(id)->run); }
  const Value* run(LeafId id) const { return runs_.at(blocks_.record(id)->run); }

  auto origins() const {
    return [this](LeafId id) { return Cell(blocks_.record(id)->origin.data()); };
  }

  RecordPool<Block> blocks_;
  BlockTable table_;
  ValuePool runs_;
};

}  // namespace rmap
