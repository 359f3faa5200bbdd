#include "io/byte_reader.hpp"
#include "io/input_file.hpp"
#include "io/memory.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/lattice.hpp>
#include <rmap/octomap_file.hpp>

namespace rmap {

namespace {

constexpr std::string_view kMagic = "# Octomap OcTree binary file";
constexpr int kDepth = 16;

/// What two bits say of a child.
enum class Child : std::uint32_t { unknown = 0, free = 1, occupied = 2, inner = 3 };

struct Header {
  std::optional<std::uint64_t> nodes;
  std::optional<double> resolution;
  bool octree = false;
};

/// The lines before the nodes: `key value` each, comments, and `data` as the last one.
class HeaderReader {
 public:
  explicit HeaderReader(ByteReader& bytes) : bytes_(bytes) {}

  Header read() {
    if (line() != kMagic) {
      throw refusal(fmt::format("it does not begin with \"{}\"", kMagic));
    }
    Header header;
    while (line() != "data") {
      if (line_.empty() || line_.front() == '#') continue;
      read_entry(line_, header);
    }
    if (!header.octree) throw refusal("its header has no line \"id OcTree\"");
    if (!header.nodes) throw refusal("its header has no line \"size\"");
    if (!header.resolution) throw refusal("its header has no line \"res\"");
    return header;
  }

 private:
  static constexpr std::size_t kLongestLine = 1000;

  Error refusal(std::string_view why) const {
    return Error(ErrorKind::input, fmt::format("{} is not a binary map of OctoMap (.bt): {}",
                                               bytes_.file().string(), why));
  }

  const std::string& line() {
    line_.clear();
    for (;;) {
      const auto byte = static_cast<char>(bytes_.take(1, "the header's line")[0]);
      if (byte == '\n') break;
      if (line_.size() == kLongestLine) throw refusal("a line of its header does not end");
      line_.push_back(byte);
    }
    if (!line_.empty() && line_.back() == '\r') line_.pop_back();
    return line_;
  }

  template <class Number>
  Number number(std::string_view key, std::string_view text) const {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) {
      throw refusal(
          fmt::format("\"{}\" in its header is followed by \"{}\", not by a number", key, text));
    }
    return number;
  }

  void read_entry(std::string_view line, Header& header) const {
    const std::size_t space = std::min(line.find(' '), line.size());
    const std::string_view key = line.substr(0, space);
    const std::string_view value = line.substr(std::min(space + 1, line.size()));
    if (key == "id") {
      if (value != "OcTree") throw refusal(fmt::format("it holds a {}, not an OcTree", value));
      header.octree = true;
    } else if (key == "size") {
      header.nodes = number<std::uint64_t>(key, value);
    } else if (key == "res") {
      header.resolution = number<double>(key, value);
    }
  }

  ByteReader& bytes_;
  std::string line_;
};

class TreeReader {
 public:
  TreeReader(ByteReader& bytes, const OctomapReadOptions& options, OctomapCells& cells)
      : bytes_(bytes), options_(options), cells_(cells) {}

  /// The inner node at `origin` whose children have edges of 2^level cells, and all below.
  void read_inner(const Cell& origin, int level) {
    if (level < 0) {
      throw Error(ErrorKind::input, fmt::format("{} has nodes below level {}, the last one that an "
                                                "OcTree has",
                                                bytes_.file().string(), kDepth));
    }
    const auto states = bytes_.number<std::uint16_t>("a node of the tree");
    ++nodes_;
    std::array<Cell, 8> inner;
    std::size_t inner_count = 0;
    for (std::uint32_t child = 0; child < 8; ++child) {
      const auto corner = [&](std::uint32_t axis) {
        return static_cast<std::int32_t>((child >> axis) & 1) << level;
      };
      const Cell at = origin + Cell(corner(0), corner(1), corner(2));
      switch (static_cast<Child>((states >> (2 * child)) & 3)) {
        case Child::unknown:
          break;
        case Child::free:
          ++nodes_;
          ++cells_.free_leaves;
          break;
        case Child::occupied:
          ++nodes_;
          ++cells_.occupied_leaves;
          expand(at, level);
          break;
        case Child::inner:
          inner[inner_count++] = at;
          break;
      }
    }
    // Its inner children follow a node, one subtree after the other.
    for (std::size_t i = 0; i < inner_count; ++i) read_inner(inner[i], level - 1);
  }

  std::uint64_t nodes() const { return nodes_; }

 private:
  void expand(const Cell& origin, int level) {
    const std::uint64_t count = std::uint64_t{1} << (3 * level);
    if (count > options_.max_cells || cells_.occupied.size() > options_.max_cells - count) {
      throw Error(ErrorKind::limit,
                  fmt::format("{} has more than {} occupied cells when its large leaves are "
                              "expanded: a higher limit can be asked for",
                              bytes_.file().string(), options_.max_cells));
    }
    const std::int32_t edge = 1 << level;
    for (std::int32_t z = 0; z < edge; ++z) {
      for (std::int32_t y = 0; y < edge; ++y) {
        for (std::int32_t x = 0; x < edge; ++x) {
          cells_.occupied.push_back(origin + Cell(x, y, z));
        }
      }
    }
  }

  ByteReader& bytes_;
  const OctomapReadOptions& options_;
  OctomapCells& cells_;
  std::uint64_t nodes_ = 0;
};

OctomapCells read_tree(const std::filesystem::path& file, const OctomapReadOptions& options) {
  InputFile input(file);
  const std::vector<std::byte> content = input.read_rest();
  if (content.empty()) {
    throw Error(ErrorKind::input, fmt::format("{} is empty: a map of OctoMap (.bt) begins with "
                                              "\"{}\"",
                                              file.string(), kMagic));
  }
  ByteReader bytes(file, content);
  const Header header = HeaderReader(bytes).read();
  OctomapCells cells;
  try {
    cells.resolution = Lattice(*header.resolution).resolution();
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{} is of no use: its {}", file.string(), error.what()));
  }
  TreeReader tree(bytes, options, cells);
  if (*header.nodes > 0) tree.read_inner(Cell::Constant(-(1 << (kDepth - 1))), kDepth - 1);
  if (tree.nodes() != *header.nodes) {
    throw Error(ErrorKind::input, fmt::format("{} has {} nodes, but its header says {}",
                                              file.string(), tree.nodes(), *header.nodes));
  }
  if (bytes.remaining() > 0) {
    throw Error(ErrorKind::input, fmt::format("{} has {} bytes behind its last node", file.string(),
                                              bytes.remaining()));
  }
  return cells;
}

}  // namespace

OctomapCells read_octomap(const std::filesystem::path& file, const OctomapReadOptions& options) {
  return with_memory_for(file, [&] { return read_tree(file, options); });
}

}  // namespace rmap
