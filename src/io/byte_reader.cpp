#include "io/byte_reader.hpp"

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

std::span<const std::byte> ByteReader::take(std::uint64_t count, std::string_view what) {
  if (count > remaining()) {
    throw Error(ErrorKind::input,
                fmt::format("{} is cut off: {} at byte {} takes {} bytes, and {} are left",
                            file_.string(), what, offset(), count, remaining()));
  }
  const auto taken = bytes_.subspan(position_, static_cast<std::size_t>(count));
  position_ += taken.size();
  return taken;
}

}  // namespace rmap
