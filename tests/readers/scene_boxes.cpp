// Prints the boxes of a .scene file. MoveIt itself is in no package of Debian, but the library that
// it reads shapes with is; what surrounds them is read here in the steps of
// PlanningScene::loadGeometryFromStream.

#include "print_box.hpp"

#include <fstream>
#include <geometric_shapes/shape_operations.h>
#include <memory>
#include <string>

#include <Eigen/Geometry>

namespace {

Eigen::Isometry3d next_pose(std::istream& in) {
  double x = 0, y = 0, z = 0, qx = 0, qy = 0, qz = 0, qw = 0;
  in >> x >> y >> z >> qx >> qy >> qz >> qw;
  return Eigen::Translation3d(x, y, z) * Eigen::Quaterniond(qw, qx, qy, qz);
}

bool read_object(std::istream& in) {
  std::string id;
  std::getline(in, id);
  const Eigen::Isometry3d object = next_pose(in);
  unsigned shapes = 0;
  in >> shapes;
  for (unsigned i = 0; i < shapes; ++i) {
    const std::unique_ptr<shapes::Shape> shape(shapes::constructShapeFromText(in));
    if (shape == nullptr || shape->type != shapes::BOX) return false;
    const Eigen::Isometry3d pose = object * next_pose(in);
    float red = 0, green = 0, blue = 0, alpha = 0;
    if (!(in >> red >> green >> blue >> alpha)) return false;
    const Eigen::Vector3d center = pose.translation();
    const Eigen::Quaterniond turn(pose.linear());
    const double* size = static_cast<const shapes::Box&>(*shape).size;
    print_box({center.x(), center.y(), center.z()}, {turn.x(), turn.y(), turn.z(), turn.w()},
              {size[0], size[1], size[2]});
  }
  unsigned subframes = 1;
  return (in >> subframes) && subframes == 0;
}

}  // namespace

int main(int, char** arguments) {
  std::ifstream in(arguments[1]);
  std::string name;
  std::getline(in, name);
  int objects = 0;
  for (std::string marker; in >> marker;) {
    if (marker == ".") return objects > 0 ? 0 : 1;  // MoveIt refuses a scene without objects
    if (marker != "*" || !read_object(in)) return 1;
    ++objects;
  }
  return 1;
}
