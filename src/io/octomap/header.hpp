#pragma once

#include "io/byte_reader.hpp"

#include <string>

namespace rmap::octomap {

/// Levels below the root: a node of level n has an edge of 2^n cells.
inline constexpr int kDepth = 16;
/// Cells have indices from -kHalf to kHalf - 1.
inline constexpr std::int32_t kHalf = 1 << (kDepth - 1);

/// What the lines before the nodes say.
struct Header {
  std::string id = "OcTree";  ///< type of the tree
  bool states_only = false;   ///< `.bt`: two bits for each child; else `.ot`: values
  std::uint64_t nodes = 0;
  double resolution = 0;  ///< metres

  bool colors() const { return id == "ColorOcTree"; }
};

/// Reads up to and with the line `data`. Throws Error(input).
Header read_header(ByteReader& bytes);

/// The lines, as OctoMap writes them.
std::string text_of(const Header& header);

}  // namespace rmap::octomap
