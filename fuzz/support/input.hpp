#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include <rmap/function_ref.hpp>

/// What a target must define: libFuzzer and the replay call it with one input after the other.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace rmap::fuzz {

/// The bytes that a target is given.
inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the process: `sentence` says what is wrong, a finding.
[[noreturn]] void fail(const std::string& sentence);

/// Writes a file of that name into a folder of this process, where it replaces the former one.
/// The folder lies where temporary files do and is removed in the end.
std::filesystem::path write_file(std::string_view bytes, const std::string& name);

/// Calls `read`, which reads `file`; whether the file was sound. It may be refused by an
/// Error(input) or Error(limit) that names it; every other exception is a finding, Error(io) too,
/// which would tell of memory that was asked for on the word of the file.
bool is_sound(const std::filesystem::path& file, FunctionRef<void()> read);

}  // namespace rmap::fuzz
