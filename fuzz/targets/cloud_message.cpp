#include "io/bag/point_cloud.hpp"
#include "support/input.hpp"

#include <span>
#include <vector>

#include <rmap/error.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto message = std::as_bytes(std::span(data, size));
  std::vector<rmap::Vector3f> points;
  try {
    rmap::decode_cloud(message, points);
  } catch (const rmap::Error&) {
    // Refused, as it may be.
  }
  return 0;
}
