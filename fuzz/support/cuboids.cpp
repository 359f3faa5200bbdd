#include "support/cuboids.hpp"

#include "support/input.hpp"

#include <rmap/cuboid_files.hpp>

namespace rmap::fuzz {

void fuzz_cuboids(std::string_view bytes, const std::string& ending) {
  const auto file = write_file(bytes, "cuboids" + ending);
  CuboidList list;
  if (!is_sound(file, [&] { list = read_cuboids(file); })) return;
  const auto copy = write_file("", "copy" + ending);
  write_cuboids(copy, list);
  const CuboidList again = read_cuboids(copy);
  if (again.resolution != list.resolution || again.frame.matrix() != list.frame.matrix() ||
      again.cuboids != list.cuboids) {
    fail("cuboids do not come back");
  }
}

}  // namespace rmap::fuzz
