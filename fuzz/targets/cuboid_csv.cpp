#include "support/cuboids.hpp"
#include "support/input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rmap::fuzz::fuzz_cuboids(rmap::fuzz::text_of(data, size), ".csv");
  return 0;
}
