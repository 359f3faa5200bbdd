#include "io/trajectory.hpp"

#include "support/input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = rmap::fuzz::write_file(rmap::fuzz::text_of(data, size), "poses.tum");
  rmap::fuzz::is_sound(file, [&] { rmap::read_trajectory(file); });
  return 0;
}
