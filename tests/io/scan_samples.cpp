#include "io/scan_samples.hpp"

#include "io/files.hpp"

namespace rmap::test {

std::string Las::bytes() const {
  const std::size_t header_size = minor == 4 ? 375 : 227;
  std::string text(header_size, '\0');
  const auto put = [&](std::size_t at, const std::string& value) {
    text.replace(at, value.size(), value);
  };
  put(0, "LASF");
  put(24, std::string(1, '\1') + static_cast<char>(minor));
  put(94, raw(static_cast<std::uint16_t>(header_size)));
  put(96, raw(static_cast<std::uint32_t>(header_size + 7)));  // some bytes of a record between
  put(104, std::string(1, static_cast<char>(format)));
  put(105, raw(point_size));
  if (minor == 4) {
    put(247, raw(static_cast<std::uint64_t>(points.size())));
  } else {
    put(107, raw(static_cast<std::uint32_t>(points.size())));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto place = static_cast<std::size_t>(8 * axis);
    put(131 + place, raw(scale[axis]));
    put(155 + place, raw(offset[axis]));
  }
  text += "records";
  for (const auto& point : points) {
    for (const std::int32_t value : point) text += raw(value);
    text += std::string(point_size - 12u, '\x55');
  }
  return text;
}

std::string graph_vector(std::initializer_list<double> values) {
  std::string text = raw(static_cast<std::uint32_t>(values.size()));
  for (const double value : values) text += raw(value);
  return text;
}

}  // namespace rmap::test
