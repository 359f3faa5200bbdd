#pragma once

#include "io/bag/pose_messages.hpp"
#include "io/trajectory.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rmap/pose.hpp>

namespace rmap {

/// The frames of /tf and /tf_static: each hangs in its parent, fixed or moving.
///
/// Whatever order the transforms come in, the tree is the same: of fixed ones the last counts,
/// and a link that moves anywhere moves, whatever /tf_static says of it too.
class FrameTree {
 public:
  struct Link {
    std::string parent = {};
    bool moves = false;
    Pose fixed = Pose::Identity();         ///< parent_from_child of a link that does not move
    std::vector<TimedPose> recorded = {};  ///< those of one that moves, until finish()
    Trajectory motion = {};
  };

  /// Throws Error(input) for a frame with a second parent, or that hangs in itself.
  void add(const StampedPose& transform, bool fixed);
  /// To be called once, behind the last add(). Throws Error(input) when frames hang in a circle.
  void finish();

  /// The frames that hang in another one.
  const std::map<std::string, Link, std::less<>>& links() const { return links_; }
  /// Whether the frame is any transform's parent or child.
  bool knows(std::string_view frame) const;
  /// The frame at the top of the tree that `frame` hangs in: itself where it hangs in none.
  std::string root_of(const std::string& frame) const;

  /// Links from `frame` up to its root, the lowest first. Throws Error(limit) beyond 1000.
  std::vector<const Link*> links_above(const std::string& frame) const;

 private:
  std::map<std::string, Link, std::less<>> links_;  ///< by child
  std::set<std::string, std::less<>> frames_;
};

/// How to come from a frame to another one: worked out once, asked for many times.
class FrameChain {
 public:
  /// Throws Error(input) when no transforms connect the frames.
  FrameChain(const FrameTree& tree, const std::string& target, const std::string& source);

  /// Whether some link on the way moves.
  bool moves() const;

  /// target_from_source: the poses of the links multiplied from the upper to the lower, each
  /// that moves interpolated at the stamp. Nothing when one of them is not known then.
  std::optional<Pose> at(std::int64_t stamp) const;

 private:
  // Below their lowest common ancestor, the uppermost first.
  std::vector<const FrameTree::Link*> to_source_;
  std::vector<const FrameTree::Link*> to_target_;
};

}  // namespace rmap
