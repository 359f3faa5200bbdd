#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <rmap/box.hpp>
#include <rmap/grid.hpp>

namespace rmap::command {

/// Keeps the order of the keys: answers read as they are written.
using Json = nlohmann::ordered_json;

/// A count that the library keeps as a double: an integer, beyond 2^63 rounded.
Json json_of_count(double count);
/// [x, y, z]
Json json_of(const Vector3d& vector);
Json json_of(const Cell& cell);
/// {"min": [x, y, z], "max": [x, y, z]}
Json json_of(const Box& box);
Json json_of(const CellBox& box);
/// The part of the options that belongs to the map; infinity is null.
Json json_of(const Options& options);
Json json_of(const BytesInUse& bytes);
Json json_of(const RTreeStatistics& statistics);

/// The text of `json` over several lines, with a line break at the end. Bytes that are no
/// UTF-8, as they may stand in names of files, are replaced.
std::string text_of(const Json& json);

/// One answer of a verb, over several lines.
void print_json(const Json& answer);
/// One answer of many, on one line.
void print_json_line(const Json& answer);

}  // namespace rmap::command
