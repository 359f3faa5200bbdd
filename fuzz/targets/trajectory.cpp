#include "io/trajectory.hpp"

#include "io/pose_file.hpp"
#include "support/input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = rmap::fuzz::write_file(rmap::fuzz::text_of(data, size), "poses.tum");
  // Times for as many poses of KITTI as a small input holds: without, they are misused, not wrong.
  static const auto times = rmap::fuzz::write_file("1\n", "times.txt");
  rmap::fuzz::is_sound(file, [&] {
    if (rmap::has_times(file)) {
      rmap::read_trajectory(file);
    } else {
      rmap::read_trajectory(file, times);
    }
  });
  return 0;
}
