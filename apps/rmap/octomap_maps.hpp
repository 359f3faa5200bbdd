#pragma once

#include "json.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <rmap/octomap_file.hpp>

namespace rmap::command {

/// Whether a name ends as maps of OctoMap do.
bool is_octomap(const std::filesystem::path& file);

/// How a map of OctoMap becomes one of ours, as options of a verb.
class OctomapOptions {
 public:
  /// Adds the options; their values live as long as this object.
  void add_to(CLI::App& app);

  OctomapImportOptions import_options() const;
  /// Those that are no use unless a map of OctoMap is read.
  const std::vector<const CLI::Option*>& options() const { return options_; }

 private:
  OctomapImportOptions import_;
  std::optional<double> clamp_min_;
  std::optional<double> clamp_max_;
  std::optional<double> occupied_threshold_;
  std::vector<const CLI::Option*> options_;
};

/// A map of either kind. Of one of OctoMap also what became of its leaves.
struct AnyMap {
  Grid grid;
  Json json = nullptr;  ///< null for a map of ours
  std::string words = {};
};

/// Reads a map by its ending. Throws Error as its reader.
AnyMap read_any_map(const std::filesystem::path& file, const OctomapImportOptions& options);

/// What a file of OctoMap holds of a map, and what it does not.
Json json_of(const OctomapExport& report, const Grid& grid);
std::string words_of(const OctomapExport& report, const Grid& grid, bool states_only);

}  // namespace rmap::command
