#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <rmap/leaf.hpp>

/// The content of a CELL chunk: blocks of 8 x 8 x 8 cells in Morton order, by columns
/// (indices, masks, values) so that like stands beside like and compresses well.
namespace rmap::wire {

/// Gathers blocks for one chunk, in the order in which they are added.
class BlockEncoder {
 public:
  /// Begins a block at `origin`, a multiple of 8 on each axis.
  void add_block(const Cell& origin);
  /// Adds cells of the block begun last that come behind all its cells so far.
  void add_cells(const CellMask& cells, std::span<const Value> values);

  std::size_t blocks() const { return masks_.size(); }
  std::size_t cells() const { return values_.size(); }
  /// The content of the chunk; forgets all blocks.
  std::vector<std::byte> take_content();

 private:
  std::vector<Cell> origins_;
  std::vector<CellMask> masks_;
  std::vector<Value> values_;
};

/// Reads the contents of the CELL chunks of one file, in their order.
class BlockDecoder {
 public:
  /// The blocks of a chunk, in Morton order, until the next call; `stored_size` is what the
  /// content takes in the file. Throws Error(input) with what is wrong as a predicate, for
  /// the reader to complete.
  std::span<const BlockValues> decode(std::span<const std::byte> content,
                                      std::uint64_t stored_size);

  /// Blocks and cells so far.
  std::uint64_t blocks() const { return blocks_; }
  std::uint64_t cells() const { return cells_; }

 private:
  std::vector<BlockValues> chunk_;
  std::vector<Value> values_;
  std::optional<Cell> last_origin_;
  std::uint64_t blocks_ = 0;
  std::uint64_t cells_ = 0;
};

}  // namespace rmap::wire
