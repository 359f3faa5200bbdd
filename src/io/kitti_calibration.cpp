#include "io/kitti_calibration.hpp"

#include "io/input_file.hpp"
#include "io/pose_math.hpp"
#include "io/text.hpp"

#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

// The numbers behind the key, row by row.
Pose parse_matrix(std::string_view text) {
  std::array<double, 12> numbers{};
  for (double& number : numbers) {
    const std::string_view word = next_word(text);
    const auto value = parse_double(word);
    if (!value) {
      throw Error(ErrorKind::input,
                  fmt::format("{} stands where one of the 12 numbers of a 3x4 matrix must be",
                              in_quotes(word)));
    }
    number = *value;
  }
  if (const std::string_view more = next_word(text); !more.empty()) {
    throw Error(ErrorKind::input,
                fmt::format("{} follows the 12 numbers of a 3x4 matrix", in_quotes(more)));
  }
  return matrix_pose(numbers.data());
}

}  // namespace

std::optional<Pose> read_kitti_calibration(const std::filesystem::path& file) {
  const std::vector<std::byte> bytes = InputFile(file).read_rest();
  LineReader lines(as_text(bytes));
  while (lines.next()) {
    std::string_view rest = lines.line();
    const std::string_view key = next_word(rest);
    if (key != "Tr:" && key != "Tr_velo_to_cam:") continue;
    try {
      return parse_matrix(rest);
    } catch (const Error& error) {
      throw Error(ErrorKind::input,
                  fmt::format("{}, line {}: {}", file.string(), lines.number(), error.what()));
    }
  }
  return std::nullopt;
}

}  // namespace rmap
