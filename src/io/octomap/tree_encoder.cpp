#include "io/octomap/tree_encoder.hpp"

#include <algorithm>
#include <cassert>

namespace rmap::octomap {

namespace {

constexpr std::uint32_t kAllChildren = 0xFF;
constexpr std::uint32_t kFree = 1;
constexpr std::uint32_t kOccupied = 2;
constexpr std::uint32_t kInner = 3;
constexpr std::size_t kValueNode = sizeof(float) + 1;

// OctoMap's threshold, at which its leaves are occupied already.
bool occupied(float log_odds) { return log_odds >= 0; }

// Bits of the three keys by turns, x first.
std::uint64_t morton_code(const Cell& cell) {
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto key = static_cast<std::uint32_t>(cell[axis] + kHalf);
    for (int bit = 0; bit < kDepth; ++bit) {
      code |= static_cast<std::uint64_t>(key >> bit & 1) << (3 * bit + axis);
    }
  }
  return code;
}

}  // namespace

void TreeEncoder::add(const Cell& cell, float log_odds) {
  const std::uint64_t code = morton_code(cell);
  assert(empty_ || code < last_code_);
  for (int level = 1; !empty_ && level <= kDepth; ++level) {
    if (code >> (3 * level) == last_code_ >> (3 * level)) break;
    finish(level);
  }
  empty_ = false;
  last_code_ = code;
  add_child(1, static_cast<std::uint32_t>(code & 7), log_odds, true);
  if (!states_only_) put_value(log_odds, 0);
}

// The inner node of `level` on the way to the last cell gets a child; its bytes are the caller's.
void TreeEncoder::add_child(int level, std::uint32_t child, float log_odds, bool leaf) {
  Inner& inner = inner_[static_cast<std::size_t>(level)];
  const bool first = inner.children == 0;
  // In a file of states only there are but two values.
  const bool equal = first || (states_only_ ? occupied(log_odds) == occupied(inner.highest)
                                            : log_odds == inner.highest);
  inner.equal_leaves = inner.equal_leaves && leaf && equal;
  inner.highest = first ? log_odds : std::max(inner.highest, log_odds);
  inner.children |= 1U << child;
  inner.states |= (!leaf ? kInner : occupied(log_odds) ? kOccupied : kFree) << (2 * child);
  ++nodes_;
}

// All below the inner node of `level` is there: it becomes a child, or a leaf instead of its own.
void TreeEncoder::finish(int level) {
  const Inner inner = inner_[static_cast<std::size_t>(level)];
  inner_[static_cast<std::size_t>(level)] = {};
  const bool pruned = inner.equal_leaves && inner.children == kAllChildren;
  if (pruned) {
    nodes_ -= 8;
    if (!states_only_) backwards_.resize(backwards_.size() - 8 * kValueNode);
  }
  if (!states_only_) {
    put_value(inner.highest, pruned ? 0 : inner.children);
  } else if (!pruned) {
    for (const std::byte byte : little_endian(static_cast<std::uint16_t>(inner.states))) {
      backwards_.push_back(byte);
    }
    std::swap(backwards_.end()[-1], backwards_.end()[-2]);
  }
  if (level < kDepth) {
    const auto child = static_cast<std::uint32_t>(last_code_ >> (3 * level) & 7);
    add_child(level + 1, child, inner.highest, pruned);
  } else {
    ++nodes_;
  }
}

void TreeEncoder::put_value(float log_odds, std::uint32_t children) {
  backwards_.push_back(static_cast<std::byte>(children));
  const auto bytes = little_endian(log_odds);
  for (std::size_t i = bytes.size(); i > 0; --i) backwards_.push_back(bytes[i - 1]);
}

std::vector<std::byte> TreeEncoder::take_bytes() {
  for (int level = 1; !empty_ && level <= kDepth; ++level) finish(level);
  std::reverse(backwards_.begin(), backwards_.end());
  return std::move(backwards_);
}

}  // namespace rmap::octomap
