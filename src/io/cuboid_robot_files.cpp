#include "io/cuboid_formats.hpp"
#include "io/input_boxes.hpp"

#include <string>

#include <fmt/format.h>

namespace rmap {

namespace {

// The numbers of one box as these formats have them.
struct BoxText {
  std::string center;
  std::string size;
};

BoxText text_of(const InputBoxes& boxes, const CellBox& cells) {
  return {.center = joined(boxes.center(cells), " "), .size = joined(boxes.size(cells), " ")};
}

std::string wxyz(const Eigen::Quaterniond& rotation) {
  return joined(Eigen::Vector4d(rotation.w(), rotation.x(), rotation.y(), rotation.z()), " ");
}

constexpr std::string_view kXml = "<?xml version=\"1.0\"?>\n";

}  // namespace

void write_cuboid_urdf(AtomicFile& file, const CuboidList& list) {
  const InputBoxes boxes(list);
  const std::string turn = joined(boxes.roll_pitch_yaw(), " ");
  file.write(kXml);
  file.write("<robot name=\"cuboids\">\n<link name=\"cuboids\">\n");
  for (std::size_t i = 0; i < list.cuboids.size(); ++i) {
    const BoxText box = text_of(boxes, list.cuboids[i].cells);
    for (const std::string_view element : {"collision", "visual"}) {
      file.write(
          fmt::format("<{0} name=\"cuboid_{1}\"><origin xyz=\"{2}\" rpy=\"{3}\"/>"
                      "<geometry><box size=\"{4}\"/></geometry></{0}>\n",
                      element, i, box.center, turn, box.size));
    }
  }
  file.write("</link>\n</robot>\n");
}

void write_cuboid_sdf(AtomicFile& file, const CuboidList& list) {
  const InputBoxes boxes(list);
  const std::string turn = joined(boxes.roll_pitch_yaw(), " ");
  file.write(kXml);
  // What is used here is the same in all versions since; Gazebo Classic reads no later one.
  file.write(
      "<sdf version=\"1.6\">\n<model name=\"cuboids\">\n<static>true</static>\n"
      "<link name=\"cuboids\">\n");
  for (std::size_t i = 0; i < list.cuboids.size(); ++i) {
    const BoxText box = text_of(boxes, list.cuboids[i].cells);
    for (const std::string_view element : {"collision", "visual"}) {
      file.write(
          fmt::format("<{0} name=\"{0}_{1}\"><pose>{2} {3}</pose>"
                      "<geometry><box><size>{4}</size></box></geometry></{0}>\n",
                      element, i, box.center, turn, box.size));
    }
  }
  file.write("</link>\n</model>\n</sdf>\n");
}

void write_cuboid_mjcf(AtomicFile& file, const CuboidList& list) {
  const InputBoxes boxes(list);
  const std::string turn = wxyz(boxes.rotation());
  file.write(kXml);
  file.write("<mujoco model=\"cuboids\">\n<worldbody>\n");
  for (std::size_t i = 0; i < list.cuboids.size(); ++i) {
    const CellBox& cells = list.cuboids[i].cells;
    file.write(
        fmt::format("<geom name=\"cuboid_{}\" type=\"box\" pos=\"{}\" quat=\"{}\" size=\"{}\"/>\n",
                    i, joined(boxes.center(cells), " "), turn, joined(boxes.size(cells) / 2, " ")));
  }
  file.write("</worldbody>\n</mujoco>\n");
}

}  // namespace rmap
