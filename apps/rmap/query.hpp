#pragma once

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>

#include <rmap/grid.hpp>

namespace rmap::command {

/// What all queries share.
struct QueryArguments {
  std::filesystem::path map;
  bool json = false;
};

/// Loads the map that is asked. Throws UsageError when none is named.
Grid load_map(const QueryArguments& arguments);

// The queries of `rmap query MAP`, as verbs below it.

void add_point_query(CLI::App& query, const std::shared_ptr<QueryArguments>& shared);
void add_box_query(CLI::App& query, const std::shared_ptr<QueryArguments>& shared);
void add_cast_query(CLI::App& query, const std::shared_ptr<QueryArguments>& shared);
void add_cells_query(CLI::App& query, const std::shared_ptr<QueryArguments>& shared);

}  // namespace rmap::command
