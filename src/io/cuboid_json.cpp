#include "io/cuboid_formats.hpp"
#include "io/input_boxes.hpp"

#include <fmt/format.h>

namespace rmap {

void write_cuboid_json(AtomicFile& file, const CuboidList& list) {
  const Vector3d translation = list.frame.translation();
  const Eigen::Quaterniond rotation = rotation_of(list.frame);
  file.write(
      fmt::format("{{\n"
                  "\"format\": \"rmap cuboids\",\n"
                  "\"version\": 1,\n"
                  "\"resolution\": {},\n"
                  "\"frame\": {{\"translation\": [{}], \"quaternion\": [{}]}},\n"
                  "\"cuboids\": [",
                  list.resolution, joined(translation, ", "), joined(rotation.coeffs(), ", ")));
  const Lattice lattice(list.resolution);
  std::string_view separator = "\n";
  for (const Cuboid& cuboid : list.cuboids) {
    const Box box = lattice.metric(cuboid.cells);
    file.write(fmt::format("{}{{\"min\": [{}], \"max\": [{}], \"points\": {}, \"density\": {}}}",
                           separator, joined(box.min, ", "), joined(box.max, ", "), cuboid.points,
                           cuboid.density()));
    separator = ",\n";
  }
  file.write("\n]\n}\n");
}

}  // namespace rmap
