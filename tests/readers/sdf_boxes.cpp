// Prints the boxes of a .sdf file as sdformat reads them.

#include "print_box.hpp"

#include <iostream>
#include <sdf/sdf.hh>

namespace {

void print(const ignition::math::Pose3d& pose, const sdf::Geometry& geometry) {
  const auto size = geometry.BoxShape()->Size();
  print_box({pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()},
            {pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z(), pose.Rot().W()},
            {size.X(), size.Y(), size.Z()});
}

}  // namespace

int main(int, char** arguments) {
  sdf::Root root;
  const sdf::Errors errors = root.Load(arguments[1]);
  for (const sdf::Error& error : errors) std::cerr << error << '\n';
  if (!errors.empty() || !root.Model()->Static()) return 1;
  const sdf::Link& link = *root.Model()->LinkByIndex(0);
  for (uint64_t i = 0; i < link.CollisionCount(); ++i) {
    print(link.CollisionByIndex(i)->RawPose(), *link.CollisionByIndex(i)->Geom());
  }
  for (uint64_t i = 0; i < link.VisualCount(); ++i) {
    print(link.VisualByIndex(i)->RawPose(), *link.VisualByIndex(i)->Geom());
  }
}
