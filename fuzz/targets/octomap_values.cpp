#include "support/input.hpp"

#include <rmap/octomap_file.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = rmap::fuzz::write_file(rmap::fuzz::text_of(data, size), "map.ot");
  rmap::fuzz::is_sound(file, [&] { rmap::import_octomap(file, {.max_cells = 5000}); });
  return 0;
}
