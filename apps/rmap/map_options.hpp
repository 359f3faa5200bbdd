#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <rmap/map_file.hpp>
#include <rmap/options.hpp>

namespace rmap::command {

/// How a map is kept in memory, as options of a verb that loads one.
void add_load_options(CLI::App& app, LoadOptions& options);

/// All options of a map, as options of a verb that makes one.
class MapOptions {
 public:
  /// Adds the options; their values live as long as this object.
  void add_to(CLI::App& app);

  const Options& options() const { return options_; }
  /// The part of them that does not belong to a map and is chosen at loading.
  LoadOptions load_options() const;
  bool resolution_given() const { return resolution_->count() > 0; }

  /// Throws Error(input) when an option was given another value than the map in `file`
  /// was made with.
  void require_agreement(const Options& of_map, const std::filesystem::path& file) const;

 private:
  /// An option that belongs to the map.
  struct Field {
    const CLI::Option* option;
    std::function<std::string(const Options&)> text;
  };

  CLI::Option* add_field(CLI::App& app, const char* name, double Options::*field,
                         const std::string& help);
  template <class Enum>
  void add_field(CLI::App& app, const char* name, Enum Options::*field, const std::string& help);

  Options options_;
  const CLI::Option* resolution_ = nullptr;
  std::vector<Field> fields_;
};

}  // namespace rmap::command
