#pragma once

#include <filesystem>
#include <new>
#include <stdexcept>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

/// read(), whose lack of memory becomes an Error(io) that names the file.
template <class Read>
auto with_memory_for(const std::filesystem::path& file, Read&& read) {
  const auto error = [&] {
    return Error(ErrorKind::io,
                 fmt::format("cannot read {}: there is not enough memory for it", file.string()));
  };
  try {
    return read();
  } catch (const std::bad_alloc&) {
    throw error();
  } catch (const std::length_error&) {
    throw error();
  }
}

}  // namespace rmap
