#include "io/kitti_calibration.hpp"
#include "support/input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = rmap::fuzz::write_file(rmap::fuzz::text_of(data, size), "calib.txt");
  rmap::fuzz::is_sound(file, [&] { rmap::read_kitti_calibration(file); });
  return 0;
}
