#include "io/bag/frame_tree.hpp"

#include "io/pose_math.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr std::size_t kMostLinks = 1000;

// The product of the links from the first down; the identity for none.
std::optional<Pose> product(const std::vector<const FrameTree::Link*>& links, std::int64_t stamp) {
  std::optional<Pose> result;
  for (const FrameTree::Link* link : links) {
    const auto pose = link->moves ? link->motion.at(stamp) : std::optional(link->fixed);
    if (!pose) return std::nullopt;
    // A single link is given as it is.
    result = result ? composed(*result, *pose) : *pose;
  }
  return result ? result : std::optional<Pose>(Pose::Identity());
}

bool any_moves(const std::vector<const FrameTree::Link*>& links) {
  return std::any_of(links.begin(), links.end(), [](const auto* link) { return link->moves; });
}

}  // namespace

void FrameTree::add(const StampedPose& transform, bool fixed) {
  const std::string& parent = transform.header.frame;
  const std::string& child = transform.child;
  if (parent == child) {
    throw Error(ErrorKind::input,
                fmt::format("the frame {} hangs in itself, and must hang in another one",
                            in_quotes(child)));
  }
  frames_.insert(parent);
  frames_.insert(child);
  const auto [place, is_new] = links_.try_emplace(child);
  Link& link = place->second;
  if (is_new) link.parent = parent;
  if (link.parent != parent) {
    throw Error(ErrorKind::input,
                fmt::format("the frame {} has two parents, {} and {}, where one is allowed",
                            in_quotes(child), in_quotes(link.parent), in_quotes(parent)));
  }
  if (fixed) {
    link.fixed = transform.pose;
  } else {
    link.moves = true;
    link.recorded.push_back({.stamp = transform.header.stamp, .pose = transform.pose});
  }
}

void FrameTree::finish() {
  // Each frame is walked over once: a walk ends where an earlier one has been.
  std::map<std::string_view, std::string_view> walked;  // frame, and where its walk began
  for (auto& [start, start_link] : links_) {
    std::string_view frame = start;
    for (auto link = links_.find(frame); link != links_.end(); link = links_.find(frame)) {
      const auto [place, is_new] = walked.try_emplace(link->first, start);
      if (!is_new && place->second != start) break;
      if (!is_new) {
        throw Error(ErrorKind::input,
                    fmt::format("the frames above {} hang in a circle: {} comes twice",
                                in_quotes(start), in_quotes(frame)));
      }
      frame = link->second.parent;
    }
    start_link.motion = Trajectory(std::exchange(start_link.recorded, {}));
  }
}

bool FrameTree::knows(std::string_view frame) const { return frames_.find(frame) != frames_.end(); }

std::string FrameTree::root_of(const std::string& frame) const {
  const auto links = links_above(frame);
  return links.empty() ? frame : links.back()->parent;
}

std::vector<const FrameTree::Link*> FrameTree::links_above(const std::string& frame) const {
  std::vector<const Link*> links;
  for (auto link = links_.find(frame); link != links_.end();
       link = links_.find(link->second.parent)) {
    links.push_back(&link->second);
    if (links.size() > kMostLinks) {
      throw Error(ErrorKind::limit, fmt::format("more than {} frames hang in one another above {}",
                                                kMostLinks, in_quotes(frame)));
    }
  }
  return links;
}

FrameChain::FrameChain(const FrameTree& tree, const std::string& target, const std::string& source)
    : to_source_(tree.links_above(source)), to_target_(tree.links_above(target)) {
  if (tree.root_of(target) != tree.root_of(source)) {
    throw Error(ErrorKind::input, fmt::format("no transforms connect the frames {} and {}",
                                              in_quotes(target), in_quotes(source)));
  }
  while (!to_source_.empty() && !to_target_.empty() && to_source_.back() == to_target_.back()) {
    to_source_.pop_back();
    to_target_.pop_back();
  }
  std::reverse(to_source_.begin(), to_source_.end());
  std::reverse(to_target_.begin(), to_target_.end());
}

bool FrameChain::moves() const { return any_moves(to_source_) || any_moves(to_target_); }

std::optional<Pose> FrameChain::at(std::int64_t stamp) const {
  const auto source = product(to_source_, stamp);
  const auto target = product(to_target_, stamp);
  if (!source || !target) return std::nullopt;
  return to_target_.empty() ? *source : composed(inverted(*target), *source);
}

}  // namespace rmap
