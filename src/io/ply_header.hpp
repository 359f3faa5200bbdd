#pragma once

#include "io/number_type.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rmap {

enum class PlyForm { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  NumberType type = NumberType::f32;
  /// Of the number of values before a list; nothing for a single value.
  std::optional<NumberType> list_size;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool has_list() const;
  /// Bytes of one in binary data; the element has no list.
  std::size_t size() const;
};

/// What the header of a PLY file says, not yet checked against the data.
struct PlyHeader {
  PlyForm form = PlyForm::ascii;
  std::vector<PlyElement> elements;  ///< in the order of the data
  std::size_t size = 0;              ///< bytes of the header
  std::size_t lines = 0;             ///< lines of the header
};

/// Whether a file that begins with `text` means to be a PLY file.
bool looks_like_ply(std::string_view text);

/// Reads the header that `text` begins with. Throws Error(input) naming `file` and line.
PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view text);

}  // namespace rmap
