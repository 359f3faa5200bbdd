#include "io/pose_file.hpp"

#include "io/atomic_file.hpp"
#include "io/input_file.hpp"
#include "io/memory.hpp"
#include "io/pose_math.hpp"
#include "io/text.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

constexpr std::size_t kMostNumbers = 16;
constexpr std::size_t kHeadSize = 65536;  // enough for the first line behind some comments
constexpr double kLastRowTolerance = 1e-6;

struct Numbers {
  std::array<double, kMostNumbers> values = {};
  std::size_t count = 0;
};

Error line_error(const std::filesystem::path& file, std::size_t line, std::string_view problem) {
  return {ErrorKind::input, fmt::format("{}, line {}: {}", file.string(), line, problem)};
}

Numbers parse_numbers(const std::filesystem::path& file, std::size_t line, std::string_view text) {
  Numbers numbers;
  for (auto word = next_word(text); !word.empty(); word = next_word(text)) {
    const auto value = parse_double(word);
    if (!value) {
      throw line_error(file, line,
                       fmt::format("{} is no number, which a pose is made of", in_quotes(word)));
    }
    if (numbers.count < kMostNumbers) numbers.values[numbers.count] = *value;
    ++numbers.count;
  }
  return numbers;
}

bool is_form(std::size_t count) { return count == 7 || count == 8 || count == 12 || count == 16; }

void check_last_row(const Numbers& numbers) {
  const double* row = &numbers.values[12];
  const bool sound =
      std::abs(row[0]) <= kLastRowTolerance && std::abs(row[1]) <= kLastRowTolerance &&
      std::abs(row[2]) <= kLastRowTolerance && std::abs(row[3] - 1) <= kLastRowTolerance;
  if (!sound) {
    throw Error(ErrorKind::input, fmt::format("the last row of the 4x4 matrix is {} {} {} {}, "
                                              "which must be 0 0 0 1",
                                              row[0], row[1], row[2], row[3]));
  }
}

Pose quaternion_pose(const double* values, QuaternionOrder order) {
  return make_pose({values[0], values[1], values[2]}, quaternion_of(values + 3, order));
}

Pose to_pose(const Numbers& numbers, QuaternionOrder order) {
  switch (numbers.count) {
    case 7:
      return quaternion_pose(numbers.values.data(), order);
    case 8:
      return quaternion_pose(numbers.values.data() + 1, order);
    case 16:
      check_last_row(numbers);
      return matrix_pose(numbers.values.data());
    default:
      return matrix_pose(numbers.values.data());
  }
}

std::vector<Pose> parsed_poses(const std::filesystem::path& file, QuaternionOrder order) {
  const std::vector<std::byte> bytes = InputFile(file).read_rest();
  std::vector<Pose> poses;
  std::size_t form = 0;  // numbers a line
  LineReader lines(as_text(bytes));
  while (lines.next()) {
    const std::string_view line = lines.line();
    const Numbers numbers = parse_numbers(file, lines.number(), line.substr(0, line.find('#')));
    if (numbers.count == 0) continue;
    if (!is_form(numbers.count)) {
      throw line_error(file, lines.number(),
                       fmt::format("the pose has {} numbers, where 12 (3x4 matrix), 16 (4x4 "
                                   "matrix), 7 (tx ty tz qx qy qz qw) and 8 (time, then these 7) "
                                   "are allowed",
                                   numbers.count));
    }
    if (form == 0) form = numbers.count;
    if (numbers.count != form) {
      throw line_error(file, lines.number(),
                       fmt::format("the pose has {} numbers, which must be {} as in the lines "
                                   "before",
                                   numbers.count, form));
    }
    try {
      poses.push_back(to_pose(numbers, order));
    } catch (const Error& error) {
      throw line_error(file, lines.number(), error.what());
    }
  }
  return poses;
}

}  // namespace

std::vector<Pose> read_poses(const std::filesystem::path& file, QuaternionOrder order) {
  return with_memory_for(file, [&] { return parsed_poses(file, order); });
}

bool has_times(const std::filesystem::path& file) {
  const std::vector<std::byte> head = InputFile(file).head(kHeadSize);
  LineReader lines(as_text(head));
  while (lines.next()) {
    std::string_view rest = lines.line().substr(0, lines.line().find('#'));
    std::size_t words = 0;
    while (!next_word(rest).empty()) ++words;
    if (words > 0) return words == 8;
  }
  return false;
}

void write_poses(const std::filesystem::path& file, std::span<const Pose> poses) {
  AtomicFile output(file);
  for (const Pose& pose : poses) {
    std::string line;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        line += fmt::format("{:.17g} ", pose(row, column));
      }
    }
    line.back() = '\n';
    output.write(line);
  }
  output.commit();
}

}  // namespace rmap
