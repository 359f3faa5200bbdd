#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace rmap::command {

/// What `--help` says of a verb beside its options.
struct Help {
  std::string usage;                  ///< what stands behind the verb, as "SCANS... -o MAP"
  std::vector<std::string> text;      ///< paragraphs
  std::vector<std::string> examples;  ///< whole commands
};

/// Gives a verb its help. Examples name files as a walk through the verbs leaves them:
/// `street` is a folder of scans, `street.rmap` its map.
void set_help(CLI::App& app, Help help);

/// `text` broken into lines of at most `width` characters, each indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width);

}  // namespace rmap::command
