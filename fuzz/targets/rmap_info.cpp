#include "support/checksums.hpp"
#include "support/input.hpp"

#include <rmap/map_file.hpp>

namespace rmap::fuzz {
namespace {

void read_info(std::string_view bytes) {
  const auto file = write_file(bytes, "map.rmap");
  is_sound(file, [&] { read_map_info(file); });
}

}  // namespace
}  // namespace rmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = rmap::fuzz::text_of(data, size);
  rmap::fuzz::read_info(bytes);
  rmap::fuzz::read_info(rmap::fuzz::with_map_checksums(bytes));
  return 0;
}
