#include "support/input.hpp"
#include "support/scans.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rmap::fuzz::fuzz_scans(rmap::fuzz::text_of(data, size), "drive.db3");
  return 0;
}
