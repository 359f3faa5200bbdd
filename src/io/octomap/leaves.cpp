#include "io/octomap/leaves.hpp"

#include "io/input_file.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap::octomap {

namespace {

/// What two bits of a `.bt` say of a child.
enum class Child : std::uint32_t { unknown = 0, free = 1, occupied = 2, inner = 3 };

/// The way from the root to where a walk is: of each inner node which children are left.
class Path {
 public:
  struct Step {
    Cell origin;
    int level;
    std::uint32_t children;  ///< as the file has them
    std::uint32_t next = 0;
  };

  void enter(const Cell& origin, int level, std::uint32_t children) {
    steps_[depth_++] = {.origin = origin, .level = level, .children = children};
  }

  /// Calls use(step, child) for each of the eight children of all that was and is entered; a child
  /// that is entered meanwhile comes before those behind it.
  template <class Use>
  void walk(Use&& use) {
    while (depth_ > 0) {
      Step& step = steps_[depth_ - 1];
      if (step.next == 8) {
        --depth_;
      } else {
        const std::uint32_t child = step.next++;
        use(std::as_const(step), child);
      }
    }
  }

 private:
  std::array<Step, kDepth> steps_;  // inner nodes have levels kDepth to 1
  std::size_t depth_ = 0;
};

Cell child_origin(const Path::Step& step, std::uint32_t child) {
  const auto corner = [&](std::uint32_t axis) {
    return static_cast<std::int32_t>((child >> axis) & 1) << (step.level - 1);
  };
  return step.origin + Cell(corner(0), corner(1), corner(2));
}

Error too_deep(const ByteReader& bytes) {
  return Error(ErrorKind::input,
               fmt::format("{} has nodes below level {}, the last one that an OcTree has, at byte "
                           "{}",
                           bytes.file().string(), kDepth, bytes.offset()));
}

const Cell kRoot = Cell::Constant(-kHalf);

// Each walk returns how many nodes it met.

/// An inner node has two bits for each child; its inner children follow it, one subtree after
/// the other. Leaves have no bytes of their own.
std::uint64_t walk_states(ByteReader& bytes, FunctionRef<void(const Leaf&)> use) {
  std::uint64_t nodes = 0;
  Path path;
  const auto enter = [&](const Cell& origin, int level) {
    const std::uint64_t at = bytes.offset();
    const auto states = bytes.number<std::uint16_t>("a node of the tree");
    ++nodes;
    if (states == 0 && level < kDepth) {
      throw Error(ErrorKind::input, fmt::format("{} has an inner node without children at byte {}",
                                                bytes.file().string(), at));
    }
    path.enter(origin, level, states);
  };
  enter(kRoot, kDepth);
  path.walk([&](const Path::Step& step, std::uint32_t child) {
    const Cell origin = child_origin(step, child);
    const int level = step.level - 1;
    switch (static_cast<Child>((step.children >> (2 * child)) & 3)) {
      case Child::unknown:
        break;
      case Child::free:
      case Child::occupied:
        ++nodes;
        use({.origin = origin,
             .level = level,
             .occupied = ((step.children >> (2 * child)) & 2) != 0,
             .log_odds = 0});
        break;
      case Child::inner:
        if (level == 0) throw too_deep(bytes);
        enter(origin, level);
        break;
    }
  });
  return nodes;
}

/// A node has its log-odds, its colour if any, and a bit for each child; the children follow
/// it, one subtree after the other.
std::uint64_t walk_values(ByteReader& bytes, bool colors, FunctionRef<void(const Leaf&)> use) {
  constexpr std::size_t kColor = 3;
  std::uint64_t nodes = 0;
  Path path;
  const auto meet = [&](const Cell& origin, int level) {
    const std::uint64_t at = bytes.offset();
    const auto log_odds = bytes.number<float>("a node of the tree");
    if (colors) bytes.take(kColor, "the colour of a node");
    const auto children = bytes.number<std::uint8_t>("the children of a node");
    ++nodes;
    if (children == 0) {
      if (std::isnan(log_odds)) {
        throw Error(ErrorKind::input, fmt::format("{} has a leaf whose log-odds is no number, at "
                                                  "byte {}",
                                                  bytes.file().string(), at));
      }
      use({.origin = origin, .level = level, .occupied = log_odds >= 0, .log_odds = log_odds});
    } else {
      if (level == 0) throw too_deep(bytes);
      path.enter(origin, level, children);
    }
  };
  meet(kRoot, kDepth);
  path.walk([&](const Path::Step& step, std::uint32_t child) {
    if ((step.children >> child & 1) != 0) meet(child_origin(step, child), step.level - 1);
  });
  return nodes;
}

}  // namespace

Cell morton_offset(std::uint64_t code) {
  Cell offset = Cell::Zero();
  for (int bit = 0; code != 0; ++bit) {
    for (int axis = 0; axis < 3; ++axis, code >>= 1) {
      offset[axis] |= static_cast<std::int32_t>(code & 1) << bit;
    }
  }
  return offset;
}

Leaves::Leaves(const std::filesystem::path& file) : file_(file) {
  InputFile input(file);
  content_ = input.read_rest();
  ByteReader bytes(file, content_);
  header_ = read_header(bytes);
  first_node_ = static_cast<std::size_t>(bytes.offset());
}

void Leaves::visit(FunctionRef<void(const Leaf&)> use) const {
  ByteReader bytes(file_, std::span(content_).subspan(first_node_), first_node_);
  std::uint64_t nodes = 0;
  if (header_.nodes > 0) {
    nodes =
        header_.states_only ? walk_states(bytes, use) : walk_values(bytes, header_.colors(), use);
  }
  if (nodes != header_.nodes) {
    throw Error(ErrorKind::input, fmt::format("{} has {} nodes, but its header says {}",
                                              file_.string(), nodes, header_.nodes));
  }
  if (bytes.remaining() > 0) {
    throw Error(ErrorKind::input, fmt::format("{} has {} bytes behind its last node, from byte {} "
                                              "on",
                                              file_.string(), bytes.remaining(), bytes.offset()));
  }
}

}  // namespace rmap::octomap
