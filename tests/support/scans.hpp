#pragma once

#include "support/nasty_beams.hpp"

#include <rmap/scan.hpp>

namespace rmap::test {

/// A random rigid pose with its translation within +-reach metres.
Pose random_pose(Random& random, double reach);

/// A scan in the sensor's frame from a random pose, with points all around.
Scan random_scan(Random& random, std::size_t points, double reach);

/// A scan in the map's frame whose beams are all of one nasty kind at the given
/// resolution, from one origin, or from one for each four points. Coordinates
/// are multiples of the resolution where the kind wants that, as near as float32 has them.
Scan nasty_scan(BeamKind kind, Random& random, std::size_t points, double reach_cells,
                double resolution, bool own_origins,
                const Vector3d& center_cells = Vector3d::Zero());

/// The same scan with its points in another order.
Scan shuffled(const Scan& scan, Random& random);

/// Every `stride`-th point of a scan.
Scan thinned(const Scan& scan, std::size_t stride);

/// One scan in the map's frame.
Scan map_scan(const Vector3d& origin, std::vector<Vector3f> points);

}  // namespace rmap::test
