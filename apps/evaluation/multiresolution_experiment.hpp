#pragma once

#include "evaluation/json.hpp"
#include "evaluation/sequence.hpp"

#include <string>
#include <vector>

#include <rmap/multiresolution.hpp>

namespace rmap::evaluation {

/// One scan's map in query cuboids that are fine near the sensor and coarse far away
/// [RMAP 2.2, Fig. 2c].
struct MultiresolutionFindings {
  std::string sequence = {};
  double resolution = 0;
  Vector3d sensor = Vector3d::Zero();
  double fine_within = 0;  ///< metres up to which every query cuboid is one cell
  std::size_t cells = 0;   ///< of the map
  std::size_t cuboids = 0;

  /// The query cuboids of one size.
  struct Size {
    double edge = 0;  ///< metres
    std::size_t cuboids = 0;
    std::size_t occupied = 0;  ///< by their largest probability
    double nearest = 0;        ///< to the sensor, metres
    double farthest = 0;
  };
  std::vector<Size> sizes = {};

  struct Drawn {
    Box box;
    double mean;  ///< [RMAP eq. 1]
    double max;
  };
  std::vector<Drawn> boxes = {};  ///< all, metres
};

Json to_json(const MultiresolutionFindings& findings);
std::vector<Json> to_rows(const MultiresolutionFindings& findings);

/// Of the first scan. The edge that is wanted is the distance by 40: twice the size at twice the
/// distance, as the spacing of a lidar's points.
MultiresolutionFindings multiresolution_experiment(const Sequence& sequence, double resolution);

}  // namespace rmap::evaluation
