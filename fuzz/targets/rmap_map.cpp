// Maps whose checksums are right whatever else is wrong: what loads must be the same map in both
// layouts, say the same of itself, and come back when it is saved.
#include "support/checksums.hpp"
#include "support/input.hpp"

#include <optional>

#include <rmap/map_file.hpp>

namespace rmap::fuzz {
namespace {

std::optional<Grid> loaded(const std::filesystem::path& file, Layout layout) {
  std::optional<Grid> grid;
  is_sound(file, [&] { grid = load(file, {.layout = layout}); });
  return grid;
}

void check_info(const std::filesystem::path& file, const Grid& grid) {
  MapFileInfo info;
  if (!is_sound(file, [&] { info = read_map_info(file); })) fail("info of a sound map is refused");
  if (info.cells != grid.cell_count() || info.scans != grid.scan_poses().size()) {
    fail("info gives other counts than the map has");
  }
}

void fuzz_map(std::string_view bytes) {
  const auto file = write_file(bytes, "map.rmap");
  const auto blocks = loaded(file, Layout::blocks);
  const auto cells = loaded(file, Layout::cells);
  if (blocks.has_value() != cells.has_value()) fail("one layout loads what the other refuses");
  if (!blocks) return;
  if (!same_map(*blocks, *cells)) fail("the layouts hold different maps");
  check_info(file, *blocks);
  const auto copy = write_file("", "copy.rmap");
  save(*cells, copy);
  if (!same_map(load(copy), *blocks)) fail("the map does not come back");
}

}  // namespace
}  // namespace rmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rmap::fuzz;
  fuzz_map(with_map_checksums(with_map_counts(text_of(data, size))));
  return 0;
}
