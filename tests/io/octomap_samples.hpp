#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rmap/octomap_file.hpp>

/// Files of OctoMap made by hand, right or wrong, after docs/formats/octomap.md.
namespace rmap::test {

/// The lines before the nodes.
std::string octomap_header(std::uint64_t nodes, bool states_only,
                           const std::string& resolution = "0.25",
                           const std::string& id = "OcTree");

/// A node of a `.ot`: its log-odds and its children, a bit each.
std::string value_node(float log_odds, unsigned children = 0);

/// Nodes of a `.ot` that lead to the lowest cell above 0 on all axes, `levels` of them.
std::string values_to_zero(std::size_t levels);

/// A `.ot` with these cells: those of the cube of 2 x 2 x 2 at 0, from the first on.
std::string value_file(const std::vector<float>& log_odds);

/// What import_octomap makes of these bytes.
OctomapImport imported(const std::string& content, const OctomapImportOptions& options = {});

/// The kind of error with which every way to read refuses these bytes.
ErrorKind octomap_refusal(const std::string& content);

}  // namespace rmap::test
