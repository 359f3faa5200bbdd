#include "support/input.hpp"

#include <rmap/map_repair.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = rmap::fuzz::write_file(rmap::fuzz::text_of(data, size), "map.rmap");
  rmap::fuzz::is_sound(file, [&] {
    rmap::check_map_file(file);
    rmap::repair_map(file);
  });
  return 0;
}
