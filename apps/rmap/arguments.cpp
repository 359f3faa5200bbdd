#include "arguments.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap::command {

namespace {

constexpr char kBoxForm[] = "six numbers x0,y0,z0,x1,y1,z1 in metres";
constexpr char kVectorForm[] = "three numbers x,y,z";
constexpr char kSphereForm[] = "four numbers x,y,z,radius in metres, the radius not negative";
constexpr char kAnyNumber[] = "...";  // the mark of such arguments in the help

bool is_separator(char character) {
  return character == ',' || character == ' ' || character == '\t' || character == '\r';
}

std::string refusal(std::string_view name, std::string_view text, std::string_view allowed) {
  return fmt::format("{} is \"{}\": it must be {}", name, text, allowed);
}

template <class Integer>
std::optional<Integer> parse_integer(std::string_view text) {
  Integer value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Vector3d> parse_vector(std::string_view text) {
  std::array<double, 3> n{};
  if (!parse_numbers(text, n)) return std::nullopt;
  return Vector3d(n[0], n[1], n[2]);
}

std::optional<Box> parse_box(std::string_view text) {
  std::array<double, 6> n{};
  if (!parse_numbers(text, n)) return std::nullopt;
  return Box{.min = {n[0], n[1], n[2]}, .max = {n[3], n[4], n[5]}};
}

std::optional<Sphere> parse_sphere(std::string_view text) {
  std::array<double, 4> n{};
  if (!parse_numbers(text, n) || n[3] < 0) return std::nullopt;
  return Sphere{.center = {n[0], n[1], n[2]}, .radius = n[3]};
}

// What stands for the value in the help and in messages of the parser.
CLI::Option* with_placeholder(CLI::Option* option, const char* placeholder) {
  return option->type_name(placeholder)->option_text(placeholder);
}

// An option whose value `parse` makes of its text.
template <class Target, class Parse>
CLI::Option* add_parsed(CLI::App& app, const std::string& names, Target& target,
                        const std::string& help, Parse parse, std::string allowed,
                        const char* placeholder) {
  const auto read = [names, &target, parse, allowed = std::move(allowed)](const std::string& text) {
    const auto value = parse(text);
    if (!value) throw CLI::ValidationError(refusal(names, text, allowed));
    target = *value;
  };
  return with_placeholder(app.add_option_function<std::string>(names, read, help), placeholder);
}

// An option whose text the target takes as it is.
template <class Target>
CLI::Option* add_assigned(CLI::App& app, const std::string& names, Target& target,
                          const char* placeholder, const std::string& help) {
  const auto read = [&target](const std::string& text) { target = text; };
  return with_placeholder(app.add_option_function<std::string>(names, read, help), placeholder);
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  // from_chars knows no plus sign, people do.
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool parse_numbers(std::string_view text, std::span<double> numbers) {
  const auto skip_blanks = [&] {
    while (!text.empty() && text.front() != ',' && is_separator(text.front())) {
      text.remove_prefix(1);
    }
  };
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    skip_blanks();
    if (i > 0 && text.starts_with(',')) text.remove_prefix(1);
    skip_blanks();
    std::size_t length = 0;
    while (length < text.size() && !is_separator(text[length])) ++length;
    const auto number = parse_number(text.substr(0, length));
    if (!number || std::isnan(*number)) return false;
    numbers[i] = *number;
    text.remove_prefix(length);
  }
  skip_blanks();
  return text.empty();
}

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

Vector3d vector_argument(std::string_view name, std::string_view text) {
  const auto vector = parse_vector(text);
  if (!vector) throw UsageError(refusal(name, text, kVectorForm));
  return *vector;
}

Box box_argument(std::string_view name, std::string_view text) {
  const auto box = parse_box(text);
  if (!box) throw UsageError(refusal(name, text, kBoxForm));
  return *box;
}

void require_volume(std::string_view name, const Box& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min[axis] < box.max[axis]) continue;
    throw Error(ErrorKind::input,
                fmt::format("{} is an empty box: {} runs from {} to {} m, and must rise", name,
                            "xyz"[axis], box.min[axis], box.max[axis]));
  }
}

CLI::Option* add_number(CLI::App& app, const std::string& names, double& target,
                        const std::string& help) {
  return add_parsed(app, names, target, help, parse_number, "a number", "NUMBER");
}

CLI::Option* add_number(CLI::App& app, const std::string& names, std::optional<double>& target,
                        const std::string& help) {
  return add_parsed(app, names, target, help, parse_number, "a number", "NUMBER");
}

CLI::Option* add_integer(CLI::App& app, const std::string& names, int& target,
                         const std::string& help, int least) {
  const auto parse = [least](std::string_view text) {
    const auto value = parse_integer<int>(text);
    return value && *value >= least ? value : std::nullopt;
  };
  return add_parsed(
      app, names, target, help, parse,
      fmt::format("a whole number from {} to {}", least, std::numeric_limits<int>::max()), "COUNT");
}

CLI::Option* add_seed(CLI::App& app, const std::string& names, std::uint64_t& target,
                      const std::string& help) {
  return add_parsed(app, names, target, help, parse_integer<std::uint64_t>,
                    "a whole number from 0 to 2^64 - 1", "NUMBER");
}

CLI::Option* add_count(CLI::App& app, const std::string& names, std::uint64_t& target,
                       const std::string& help) {
  return add_parsed(app, names, target, help, parse_integer<std::uint64_t>,
                    "a whole number from 0 to 2^64 - 1", "COUNT");
}

CLI::Option* add_vector(CLI::App& app, const std::string& names, std::optional<Vector3d>& target,
                        const std::string& help) {
  return add_parsed(app, names, target, help, parse_vector, kVectorForm, "X,Y,Z");
}

CLI::Option* add_box(CLI::App& app, const std::string& names, std::optional<Box>& target,
                     const std::string& help) {
  return add_parsed(app, names, target, help, parse_box, kBoxForm, "BOX");
}

CLI::Option* add_boxes(CLI::App& app, const std::string& names, std::vector<Box>& target,
                       const std::string& help) {
  const auto read = [names, &target](const std::vector<std::string>& texts) {
    target.clear();
    for (const std::string& text : texts) {
      const auto box = parse_box(text);
      if (!box) throw CLI::ValidationError(refusal(names, text, kBoxForm));
      target.push_back(*box);
    }
  };
  return with_placeholder(
      app.add_option_function<std::vector<std::string>>(names, read, help)->allow_extra_args(false),
      "BOX");
}

CLI::Option* add_sphere(CLI::App& app, const std::string& names, std::optional<Sphere>& target,
                        const std::string& help) {
  return add_parsed(app, names, target, help, parse_sphere, kSphereForm, "X,Y,Z,R");
}

CLI::Option* add_path(CLI::App& app, const std::string& names, std::filesystem::path& target,
                      const std::string& help, const char* placeholder) {
  return add_assigned(app, names, target, placeholder, help);
}

CLI::Option* add_paths(CLI::App& app, const std::string& names,
                       std::vector<std::filesystem::path>& target, const std::string& help) {
  const auto read = [&target](const std::vector<std::string>& texts) {
    target.assign(texts.begin(), texts.end());
  };
  return app.add_option_function<std::vector<std::string>>(names, read, help)
      ->option_text(kAnyNumber);
}

CLI::Option* add_text(CLI::App& app, const std::string& names, std::string& target,
                      const char* placeholder, const std::string& help) {
  return with_placeholder(app.add_option(names, target, help), placeholder);
}

CLI::Option* add_text(CLI::App& app, const std::string& names, std::optional<std::string>& target,
                      const char* placeholder, const std::string& help) {
  return add_assigned(app, names, target, placeholder, help);
}

CLI::Option* add_texts(CLI::App& app, const std::string& name, std::vector<std::string>& target,
                       const std::string& help) {
  return app.add_option(name, target, help)->option_text(kAnyNumber);
}

CLI::Option* add_json_flag(CLI::App& app, bool& target) {
  return app.add_flag("--json", target, "Answer in JSON, for programs.");
}

}  // namespace rmap::command
