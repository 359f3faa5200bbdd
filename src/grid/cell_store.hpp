#pragma once

#include "grid/leaf_store.hpp"

#include <rmap/rtree/record_pool.hpp>

namespace rmap {

/// Layout cells, the paper's: every initialised cell is a leaf branch of the
/// R-tree [RMAP 2.2].
class CellStore final : public LeafStore {
 public:
  explicit CellStore(const Options& options);
  std::unique_ptr<LeafStore> clone() const override;

  std::optional<LeafId> find(const Cell& origin) const override;
  void visit_block(const Cell& block,
                   FunctionRef<void(LeafId, const Cell& origin)> visit) const override;
  const Value* find_value(const Cell& cell) const override;
  Leaf leaf(LeafId id, const Cell& origin) const override;
  Content content(LeafId id) override;
  void prefetch(LeafId id) const override;
  LeafId id_limit() const override { return static_cast<LeafId>(entries_.slots()); }
  BytesInUse bytes_in_use() const override;
  Stamp stamp(LeafId id) const override { return entries_.record(id)->stamp; }
  void set_stamp(LeafId id, Stamp stamp) override { entries_.record(id)->stamp = stamp; }

 private:
  struct Entry {
    Stamp stamp;
    Value value;
  };

  LeafId allocate(const Cell& origin) override;
  void release(LeafId id) override;
  void add_cells(LeafId id, const CellMask& cells, Value value) override;
  void take_cells(LeafId id, const CellMask& cells) override;
  std::optional<std::string> check_storage() const override;

  RecordPool<Entry> entries_;
};

}  // namespace rmap
