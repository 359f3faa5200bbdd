#include "support/input.hpp"

#include <algorithm>

#include <rmap/scan_files.hpp>

namespace rmap::fuzz {
namespace {

void fuzz_poses(std::string_view bytes) {
  const auto file = write_file(bytes, "poses.txt");
  std::vector<Pose> poses;
  if (!is_sound(file, [&] { poses = read_poses(file); })) return;
  const auto copy = write_file("", "copy.txt");
  write_poses(copy, poses);
  const auto same = [](const Pose& a, const Pose& b) { return a.matrix() == b.matrix(); };
  if (!std::ranges::equal(read_poses(copy), poses, same)) fail("poses do not come back");
}

}  // namespace
}  // namespace rmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rmap::fuzz::fuzz_poses(rmap::fuzz::text_of(data, size));
  return 0;
}
