// Prints the boxes of a .urdf file as urdfdom reads them.

#include "print_box.hpp"

#include <urdf_parser/urdf_parser.h>

namespace {

void print(const urdf::Pose& pose, const urdf::Geometry& geometry) {
  const auto& box = dynamic_cast<const urdf::Box&>(geometry);
  print_box({pose.position.x, pose.position.y, pose.position.z},
            {pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.rotation.w},
            {box.dim.x, box.dim.y, box.dim.z});
}

}  // namespace

int main(int, char** arguments) {
  const auto robot = urdf::parseURDFFile(arguments[1]);
  if (robot == nullptr) return 1;
  const auto link = robot->getLink("cuboids");
  for (const auto& part : link->collision_array) print(part->origin, *part->geometry);
  for (const auto& part : link->visual_array) print(part->origin, *part->geometry);
}
