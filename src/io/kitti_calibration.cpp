#include "io/kitti_calibration.hpp"

#include "io/input_file.hpp"
#include "io/text.hpp"

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

// The numbers behind the key, row by row.
Pose parse_matrix(std::string_view text) {
  Pose pose = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const std::string_view word = next_word(text);
      const auto number = parse_double(word);
      if (!number) {
        throw Error(ErrorKind::input,
                    fmt::format("{} stands where one of the 12 numbers of a 3x4 matrix must be",
                                in_quotes(word)));
      }
      pose(row, column) = *number;
    }
  }
  if (const std::string_view more = next_word(text); !more.empty()) {
    throw Error(ErrorKind::input,
                fmt::format("{} follows the 12 numbers of a 3x4 matrix", in_quotes(more)));
  }
  check_pose(pose);
  return pose;
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
