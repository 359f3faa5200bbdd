#include "evaluation/map_under_test.hpp"

namespace rmap::evaluation {

std::unique_ptr<OctomapMap> make_octomap(double /*resolution*/) { return nullptr; }

std::string octomap_version() { return {}; }

}  // namespace rmap::evaluation
