#pragma once

#include <string>

#include <fmt/format.h>

#include <rmap/cell.hpp>

namespace rmap {

/// A box of cells in the words of a sentence: "from (0, 0, 0) to (8, 8, 8)".
inline std::string text_of(const CellBox& box) {
  return fmt::format("from ({}, {}, {}) to ({}, {}, {})", box.min.x(), box.min.y(), box.min.z(),
                     box.max.x(), box.max.y(), box.max.z());
}

}  // namespace rmap
