#pragma once

#include "io/bag/bag_storage.hpp"
#include "io/bag/mcap_records.hpp"
#include "io/bag/unpack.hpp"
#include "io/input_file.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rmap/error.hpp>

namespace rmap {

/// An MCAP file, with or without chunks. It is read from its start to its end: an index may be
/// missing or wrong, the records themselves are what counts. One chunk is in memory at a time.
///
/// A file whose end is missing, as a recorder leaves it that lost its power, gives all complete
/// records, those of a chunk too that is not compressed, and a warning that counts.
class McapStorage : public BagStorage {
 public:
  explicit McapStorage(InputFile file);

  void visit(FunctionRef<void(const BagMessage&)> use) override;
  std::span<const std::byte> read(const BagPlace& place) override;
  std::vector<BagTopic> topics() const override;
  std::string format() const override { return "mcap"; }
  std::vector<std::string> compressions() const override { return compressions_; }
  std::vector<std::string> warnings() const override { return warnings_; }

 private:
  struct Record {
    McapRecordHead head;
    std::uint64_t offset = 0;   ///< of its content in the file
    std::uint64_t present = 0;  ///< bytes of its content that are there

    bool complete() const { return present == head.size; }
    std::uint64_t end() const { return offset + present; }
  };
  /// A chunk without its head.
  struct Chunk {
    McapChunkHead head;
    std::uint64_t offset = 0;   ///< of what is packed, in the file
    std::uint64_t present = 0;  ///< bytes of it that are there
  };
  using Use = FunctionRef<void(const BagMessage&)>;

  void check_sum(std::string_view what, std::uint64_t begin, std::uint64_t end,
                 std::uint32_t expected) const;
  std::optional<Record> record_at(std::uint64_t offset, std::uint64_t stop) const;
  std::uint64_t visit_records(std::uint64_t stop, Use use);
  std::uint64_t visit_record(const Record& record, Use use);
  std::uint64_t visit_chunk(const Record& record, Use use);
  std::size_t visit_content(const Chunk& chunk, Use use);
  std::span<const std::byte> load(const Record& record);
  std::optional<Chunk> chunk_at(const Record& record) const;
  void unpack(const Chunk& chunk);
  void learn(McapSchema schema);
  void learn(const McapChannel& channel, std::uint64_t offset);
  void give(std::span<const std::byte> content, std::uint64_t offset, BagPlace place, Use use);
  void warn_of_cut(std::uint64_t kept);
  Error damaged(std::uint64_t offset, std::string_view problem) const;

  InputFile file_;
  bool closed_ = false;      ///< by the magic at the end
  bool data_ended_ = false;  ///< the record that ends the messages was met
  std::map<std::uint16_t, std::string> schemas_;
  std::map<std::uint16_t, BagTopic> channels_;
  std::map<std::uint64_t, Chunk> chunks_;  ///< the compressed ones, by offset
  std::vector<std::string> compressions_;
  std::vector<std::string> warnings_;
  std::uint64_t messages_ = 0;
  UnpackBudget budget_;
  std::vector<std::byte> packed_;
  std::vector<std::byte> content_;  ///< of a record, or of a chunk
  std::uint64_t loaded_ = 0;        ///< offset of the chunk that content_ holds; 0: none
};

}  // namespace rmap
