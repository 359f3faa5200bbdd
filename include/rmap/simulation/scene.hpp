#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <rmap/pose.hpp>
#include <rmap/simulation/shape.hpp>

namespace rmap {

/// The side that a closed surface is seen from. It does not change where rays
/// end, only which side is solid: that of a room's walls is the outer one.
enum class Side { outside, inside };

/// Where a moving object is at one time: `translation` (m) is added to its pose.
struct Waypoint {
  double time = 0;  ///< seconds
  Vector3d translation = Vector3d::Zero();
};

/// One surface of a scene and where it is when.
struct SceneObject {
  std::string name;
  Shape shape;
  Pose map_from_object = Pose::Identity();
  Side seen_from = Side::outside;
  /// Linear from waypoint to waypoint, their times strictly rising; at rest
  /// before the first and after the last. Empty: the object does not move.
  std::vector<Waypoint> motion = {};
  /// The object exists from this time (s) on ...
  double visible_from = -std::numeric_limits<double>::infinity();
  /// ... and no longer at this one.
  double visible_until = std::numeric_limits<double>::infinity();
};

/// Whether the object is always there and always in the same place.
bool is_static(const SceneObject& object);

/// Where a ray first meets a surface.
struct SurfaceHit {
  double range = 0;                    ///< from the ray's origin, metres
  Vector3d point = Vector3d::Zero();   ///< metres, map's frame
  Vector3d normal = Vector3d::Zero();  ///< length 1, towards the side that the ray came from
  std::size_t object = 0;              ///< index into Scene::objects()
};

/// A point of the true surface.
struct SurfaceSample {
  Vector3d point = Vector3d::Zero();   ///< metres, map's frame
  Vector3d normal = Vector3d::Zero();  ///< length 1, away from the solid
  std::size_t object = 0;              ///< index into Scene::objects()
};

/// A world of analytic surfaces, in the map's frame: what simulated sensors look
/// at, and the truth that maps of it are measured by. Rays meet every surface
/// from both sides. All answers are the same bits on every target.
class Scene {
 public:
  explicit Scene(std::string name = {}) : name_(std::move(name)) {}

  const std::string& name() const { return name_; }
  const std::vector<SceneObject>& objects() const { return objects_; }

  /// Throws Error(input) that names the object and the field when a size is not
  /// positive and finite, the pose is no pose (check_pose), the times of the
  /// waypoints do not rise, or the object is never visible.
  void add(SceneObject object);

  /// The first point within `max_range` (m, may be infinite) at which the ray
  /// meets a surface as it is at `time` (s); an origin on a surface meets it at
  /// range 0. `direction` may have any length but zero. Throws Error(input) when
  /// the origin or the direction is not finite, or the direction is zero. Exact
  /// but for the rounding of doubles. Cost: one cheap test per object, closed
  /// forms for those whose bounding sphere the ray meets.
  std::optional<SurfaceHit> first_hit(const Vector3d& origin, const Vector3d& direction,
                                      double max_range, double time = 0) const;

  /// Distance (m) from `point` to the nearest surface as it is at `time` (s),
  /// infinite in an empty scene. Within solids, where objects may overlap, hidden
  /// surfaces count too. Cost: one closed form per object.
  double distance_to_surface(const Vector3d& point, double time = 0) const;

  /// Whether `point` is strictly within a solid at `time` (s), where no sensor can be.
  bool solid_at(const Vector3d& point, double time = 0) const;

  /// Points of the static surface, in a fixed order, about one for each square
  /// of `spacing` (m) and none of its places farther than `spacing` from one.
  /// Parts that another static object covers (the floor under a cupboard) have
  /// none; a strip beside them, at most `spacing` wide, may lack them too. Throws
  /// Error(input) unless the spacing is positive and finite, Error(limit) when it
  /// would take more than 10^8 points.
  std::vector<SurfaceSample> sample_surface(double spacing) const;

  /// The whole scene carried elsewhere, motions too.
  Scene transformed(const Pose& new_from_old, std::string name) const;

 private:
  struct BoundingSphere {
    Vector3d center;
    double radius;
  };

  /// Whether `point` is within a static solid.
  bool covered(const Vector3d& point) const;

  std::string name_;
  std::vector<SceneObject> objects_;
  std::vector<BoundingSphere> bounds_;  ///< of each object at translation zero
};

}  // namespace rmap
