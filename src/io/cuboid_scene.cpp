#include "io/cuboid_formats.hpp"
#include "io/input_boxes.hpp"

#include <string>

#include <fmt/format.h>

namespace rmap {

namespace {

constexpr std::string_view kIdentity = "0 0 0\n0 0 0 1\n";

}  // namespace

// Since MoveIt 1.1.6 and in MoveIt 2: each object has a pose and subframes, each shape a pose and
// a colour, where 0 0 0 0 leaves the colour to whoever shows it.
void write_cuboid_scene(AtomicFile& file, const CuboidList& list) {
  const InputBoxes boxes(list);
  const std::string turn = joined(boxes.rotation().coeffs(), " ");
  file.write("cuboids\n");
  // A scene without any object is refused by MoveIt, an object without a shape is not.
  if (list.cuboids.empty()) file.write(fmt::format("* cuboids\n{}0\n0\n", kIdentity));
  for (std::size_t i = 0; i < list.cuboids.size(); ++i) {
    const CellBox& cells = list.cuboids[i].cells;
    file.write(fmt::format("* cuboid_{}\n{}\n{}\n1\nbox\n{}\n{}0 0 0 0\n0\n", i,
                           joined(boxes.center(cells), " "), turn, joined(boxes.size(cells), " "),
                           kIdentity));
  }
  file.write(".\n");
}

}  // namespace rmap
