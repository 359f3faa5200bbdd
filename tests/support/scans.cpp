#include "support/scans.hpp"

#include <algorithm>
#include <numeric>

namespace rmap::test {

Pose random_pose(Random& random, double reach) {
  const Eigen::Quaterniond rotation(random.gaussian(1), random.gaussian(1), random.gaussian(1),
                                    random.gaussian(1) + 1e-3);
  return make_pose(random.point(-reach, reach), rotation);
}

Scan random_scan(Random& random, std::size_t points, double reach) {
  Scan scan{.map_from_sensor = random_pose(random, reach / 4)};
  for (std::size_t i = 0; i < points; ++i) {
    scan.points.push_back((random.direction() * random.real(0, reach)).cast<float>());
  }
  return scan;
}

Scan nasty_scan(BeamKind kind, Random& random, std::size_t points, double reach_cells,
                double resolution, bool own_origins, const Vector3d& center_cells) {
  constexpr std::size_t kBeamsOfAnOrigin = 4;
  Scan scan{.frame = Frame::map};
  Vector3d origin = nasty_beam(kind, random, reach_cells, center_cells).origin;
  scan.map_from_sensor.translation() = origin * resolution;
  for (std::size_t i = 0; i < points; ++i) {
    BeamEnds ends = nasty_beam(kind, random, reach_cells, center_cells);
    if (own_origins) {
      if (i % kBeamsOfAnOrigin == 0) origin = ends.origin;
      scan.origins.emplace_back(origin * resolution);
    }
    ends.end += origin - ends.origin;
    scan.points.push_back((ends.end * resolution).cast<float>());
  }
  return scan;
}

Scan shuffled(const Scan& scan, Random& random) {
  std::vector<std::size_t> order(scan.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random.engine());
  Scan mixed = scan;
  for (std::size_t i = 0; i < order.size(); ++i) {
    mixed.points[i] = scan.points[order[i]];
    if (!scan.origins.empty()) mixed.origins[i] = scan.origins[order[i]];
  }
  std::shuffle(mixed.no_returns.begin(), mixed.no_returns.end(), random.engine());
  return mixed;
}

Scan thinned(const Scan& scan, std::size_t stride) {
  Scan thin = scan;
  thin.points.clear();
  thin.origins.clear();
  for (std::size_t i = 0; i < scan.points.size(); i += stride) {
    thin.points.push_back(scan.points[i]);
    if (!scan.origins.empty()) thin.origins.push_back(scan.origins[i]);
  }
  return thin;
}

Scan map_scan(const Vector3d& origin, std::vector<Vector3f> points) {
  Scan scan{.frame = Frame::map, .points = std::move(points)};
  scan.map_from_sensor.translation() = origin;
  return scan;
}

}  // namespace rmap::test
