#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include <yaml.h>

namespace rmap {

/// A YAML text from its start to its end, in time and memory proportional to it. Refused are what
/// would cost more and what no recorder writes: anchors, aliases, directives, and nodes in more
/// than 64 others. All errors are Error(input) with the name of `file` and
/// the place.
class YamlReader {
 public:
  /// `text` must outlive the reader.
  YamlReader(const std::filesystem::path& file, std::string_view text);

  /// Whether the next node is a mapping with that key; its value is the next node then.
  bool enter_value(std::string_view key);

  /// The items of the next node, if it is a sequence of scalars.
  std::optional<std::vector<std::string>> read_texts();

  /// Reads what is left, so that the whole is known to be sound.
  void finish();

 private:
  void advance();
  void skip_node();
  [[noreturn]] void fail(std::size_t line, std::string_view problem) const;

  // What libyaml allocates, freed as it wants it.
  template <class T, void (*kDelete)(T*)>
  struct Freed : T {
    Freed() : T{} {}
    ~Freed() { kDelete(this); }
    Freed(const Freed&) = delete;
    Freed& operator=(const Freed&) = delete;
  };

  std::filesystem::path file_;
  Freed<yaml_parser_t, yaml_parser_delete> parser_;
  Freed<yaml_event_t, yaml_event_delete> event_;  // the next one
  int depth_ = 0;                                 // nodes around it
};

}  // namespace rmap
