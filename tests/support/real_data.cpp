#include "support/real_data.hpp"

#include <cstdlib>

namespace rmap::test {

std::filesystem::path data_folder() {
  const char* chosen = std::getenv("RMAP_DATA");
  const std::filesystem::path folder = chosen == nullptr ? RMAP_DEFAULT_DATA : chosen;
  return std::filesystem::is_directory(folder) ? folder : std::filesystem::path();
}

const std::vector<std::string>& sequence_names() {
  static const std::vector<std::string> kNames = {
      "street_kitti",  "hall_lidar",    "stationary_outdoor", "livingroom_depth",
      "kitchen_depth", "corridor_tilt", "corridor_2d"};
  return kNames;
}

std::filesystem::path sequence_folder(const std::string& name) {
  const auto data = data_folder();
  if (data.empty()) return {};
  const auto folder = data / "sequences" / name;
  return std::filesystem::is_directory(folder) ? folder : std::filesystem::path();
}

}  // namespace rmap::test
