#pragma once

#include "words.hpp"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include <rmap/box.hpp>
#include <rmap/cells.hpp>

namespace rmap::command {

/// The command was called in a way that makes no sense: exit code 2, where an Error of
/// the library gives 1.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A whole number or a number with a point, in the C locale, all of `text`; `inf` and `nan`
/// are some.
std::optional<double> parse_number(std::string_view text);
/// Exactly `numbers.size()` numbers separated by commas or blanks, none of them `nan`. False
/// when `text` is anything else.
bool parse_numbers(std::string_view text, std::span<double> numbers);

/// What stands between the commas of `text`, empty parts too.
std::vector<std::string> split_at_commas(const std::string& text);

/// Three numbers as a vector, six as a box; what they are for, in messages, is `name`.
/// Throw UsageError.
Vector3d vector_argument(std::string_view name, std::string_view text);
Box box_argument(std::string_view name, std::string_view text);

/// Throws Error(input) naming the option, the axis and its borders when `box` is empty.
void require_volume(std::string_view name, const Box& box);

// Options of a verb: each writes what is given to `target`, which holds the default,
// and refuses everything else as a usage error that names the option. Numbers may be
// `nan`: who uses them says what is allowed.

CLI::Option* add_number(CLI::App& app, const std::string& names, double& target,
                        const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& names, std::optional<double>& target,
                        const std::string& help);
CLI::Option* add_integer(CLI::App& app, const std::string& names, int& target,
                         const std::string& help, int least = std::numeric_limits<int>::min());
CLI::Option* add_seed(CLI::App& app, const std::string& names, std::uint64_t& target,
                      const std::string& help);
CLI::Option* add_count(CLI::App& app, const std::string& names, std::uint64_t& target,
                       const std::string& help);
CLI::Option* add_vector(CLI::App& app, const std::string& names, std::optional<Vector3d>& target,
                        const std::string& help);
CLI::Option* add_box(CLI::App& app, const std::string& names, std::optional<Box>& target,
                     const std::string& help);
CLI::Option* add_boxes(CLI::App& app, const std::string& names, std::vector<Box>& target,
                       const std::string& help);
CLI::Option* add_sphere(CLI::App& app, const std::string& names, std::optional<Sphere>& target,
                        const std::string& help);
CLI::Option* add_path(CLI::App& app, const std::string& names, std::filesystem::path& target,
                      const std::string& help, const char* placeholder = "FILE");
CLI::Option* add_paths(CLI::App& app, const std::string& names,
                       std::vector<std::filesystem::path>& target, const std::string& help);
/// A text as it is.
CLI::Option* add_text(CLI::App& app, const std::string& names, std::string& target,
                      const char* placeholder, const std::string& help);
/// The same where no text is not an empty one.
CLI::Option* add_text(CLI::App& app, const std::string& names, std::optional<std::string>& target,
                      const char* placeholder, const std::string& help);
/// Any number of arguments, as they are.
CLI::Option* add_texts(CLI::App& app, const std::string& name, std::vector<std::string>& target,
                       const std::string& help);
CLI::Option* add_json_flag(CLI::App& app, bool& target);

/// An option whose value is one of the words of `Enum`.
template <class Enum>
CLI::Option* add_word(CLI::App& app, const std::string& names, Enum& target,
                      const std::string& help) {
  const auto read = [names, &target](const std::string& text) {
    const auto value = find_word<Enum>(text);
    if (!value) {
      throw CLI::ValidationError(names + " is \"" + text + "\": it must be " + word_list<Enum>());
    }
    target = *value;
  };
  return app.add_option_function<std::string>(names, read, help)
      ->type_name("WORD")
      ->option_text("WORD");
}

}  // namespace rmap::command
