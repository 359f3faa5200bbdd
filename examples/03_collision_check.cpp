// May the robot go there? A ball against the map, and a look ahead.
#include <iostream>

#include <rmap/rmap.hpp>

int main() {
  rmap::Grid grid({.resolution = 0.05});
  for (const rmap::Scan& scan : rmap::make_simulation("room")) grid.insert(scan);

  // A robot of radius 0.25 m on its way through the room.
  const rmap::Vector3d start(-2.2, 0, 0.6);
  const rmap::Vector3d step(0.2, 0, 0);
  for (int i = 0; i <= 26; ++i) {
    const rmap::Vector3d place = start + i * step;
    if (rmap::any_occupied(grid, {.center = place, .radius = 0.25})) {
      std::cout << "the ball at x = " << place.x() << " m touches something\n";
      break;
    }
  }

  // The same way as a ray: what is in front, how far, and through which side.
  if (const auto hit = rmap::cast_ray(grid, start, step, 10.0)) {
    std::cout << "the ray meets a cell after " << hit->distance << " m at x = " << hit->point.x()
              << ", y = " << hit->point.y() << ", z = " << hit->point.z()
              << (hit->face == rmap::Face::min_x ? ", on the side that faces us\n" : "\n");
  }

  // The cells that are nearest: all that come nearer than 0.5 m.
  const rmap::CellSelection near{.sphere = rmap::Sphere{start, 0.5}, .occupied_only = true};
  std::cout << rmap::count_cells(grid, near) << " occupied cells within 0.5 m of the start\n";

  // Free by assumption is not the same as seen to be free. Behind the wall nobody has looked.
  const rmap::State behind = grid.state({4.0, 0, 1});
  std::cout << "behind the wall: "
            << (behind == rmap::State::assumed_free ? "assumed free, never seen\n" : "seen\n");
}
