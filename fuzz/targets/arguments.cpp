// One text as the value of every kind of argument that the command has.
#include "rmap/arguments.hpp"

#include "rmap/cuboid_input.hpp"
#include "support/input.hpp"

#include <array>
#include <cmath>

namespace rmap::command {
namespace {

// Values or a UsageError; the command answers both.
template <class Parse>
void parse_argument(Parse&& parse) {
  try {
    parse();
  } catch (const UsageError&) {
    return;
  }
}

void parse_texts(const std::string& text) {
  parse_number(text);
  std::array<double, 6> numbers{};
  for (std::size_t count = 1; count <= numbers.size(); ++count) {
    if (!parse_numbers(text, std::span(numbers).first(count))) continue;
    if (std::isnan(numbers[count - 1])) fuzz::fail("nan is taken for a number");
  }
  parse_argument([&] { vector_argument("ORIGIN", text); });
  parse_argument([&] { box_argument("BOX", text); });
  parse_argument([&] { check_pose(frame_argument(text).given); });
}

// As a verb of the command has them.
void parse_options(const std::string& text) {
  double number = 0;
  int integer = 0;
  std::uint64_t seed = 0;
  std::optional<Vector3d> vector;
  std::optional<Sphere> sphere;
  std::vector<Box> boxes;
  Layout layout = Layout::blocks;
  CLI::App app;
  add_number(app, "--number", number, "");
  add_integer(app, "--integer", integer, "", 1);
  add_seed(app, "--seed", seed, "");
  add_vector(app, "--vector", vector, "");
  add_sphere(app, "--sphere", sphere, "");
  add_boxes(app, "--box", boxes, "");
  add_word(app, "--layout", layout, "");
  for (const char* name : {"number", "integer", "seed", "vector", "sphere", "box", "layout"}) {
    try {
      app.parse(std::vector{"--" + std::string(name) + "=" + text});
    } catch (const CLI::ParseError&) {
      continue;
    }
    if (integer != 0 && integer < 1) fuzz::fail("an integer below the least one");
    if (sphere && sphere->radius < 0) fuzz::fail("a sphere with a negative radius");
  }
}

}  // namespace
}  // namespace rmap::command

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(rmap::fuzz::text_of(data, size));
  rmap::command::parse_texts(text);
  rmap::command::parse_options(text);
  return 0;
}
