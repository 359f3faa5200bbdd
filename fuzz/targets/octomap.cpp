#include "support/input.hpp"

#include <rmap/octomap_file.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Few, so that expanding leaves takes no more time than reading them.
  constexpr std::uint64_t kMostCells = 5000;
  const auto file = rmap::fuzz::write_file(rmap::fuzz::text_of(data, size), "map.bt");
  rmap::fuzz::is_sound(file, [&] {
    const auto map = rmap::read_octomap(file, {.max_cells = kMostCells});
    if (map.occupied.size() > kMostCells) rmap::fuzz::fail("more cells than are allowed");
  });
  return 0;
}
