#include "io/system_error.hpp"

#include <system_error>

#include <fmt/format.h>

namespace rmap {

Error system_error(std::string_view action, const std::filesystem::path& file, int code) {
  return {ErrorKind::io, fmt::format("cannot {} {}: {}", action, file.string(),
                                     std::generic_category().message(code))};
}

}  // namespace rmap
