#include "io/bag/metadata.hpp"

#include "support/input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = rmap::fuzz::write_file(rmap::fuzz::text_of(data, size), rmap::kMetadataName);
  rmap::fuzz::is_sound(file, [&] { rmap::read_bag_files(file.parent_path()); });
  return 0;
}
