#include "support/checksums.hpp"
#include "support/cuboids.hpp"
#include "support/input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = rmap::fuzz::text_of(data, size);
  rmap::fuzz::fuzz_cuboids(bytes, ".rcs");
  rmap::fuzz::fuzz_cuboids(rmap::fuzz::with_rcs_checksum(bytes), ".rcs");
  return 0;
}
