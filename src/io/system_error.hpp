#pragma once

#include <filesystem>
#include <string_view>

#include <rmap/error.hpp>

namespace rmap {

/// "cannot <action> <file>: <the system's reason>", for a value of errno.
Error system_error(std::string_view action, const std::filesystem::path& file, int code);

}  // namespace rmap
