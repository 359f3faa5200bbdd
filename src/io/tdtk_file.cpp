#include "io/tdtk_file.hpp"

#include "io/point_text.hpp"
#include "io/text.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr double kMetresPerUnit = 0.01;

// From x right, y up, z ahead to x ahead, y left, z up.
Vector3d right_handed(const Vector3d& left_handed) {
  return {left_handed.z(), -left_handed.x(), left_handed.y()};
}

// Of angles about x, y and z as 3DTK applies them, in its axes.
Eigen::Matrix3d rotation_of(const Vector3d& angles) {
  const Vector3d s = angles.array().sin();
  const Vector3d c = angles.array().cos();
  Eigen::Matrix3d rotation;
  rotation << c.y() * c.z(), -c.y() * s.z(), s.y(), s.x() * s.y() * c.z() + c.x() * s.z(),
      c.x() * c.z() - s.x() * s.y() * s.z(), -s.x() * c.y(), s.x() * s.z() - c.x() * s.y() * c.z(),
      c.x() * s.y() * s.z() + s.x() * c.z(), c.x() * c.y();
  return rotation;
}

}  // namespace

void read_3dtk(InputFile& file, const PointReadOptions& options, PointCloud& cloud) {
  const std::vector<std::byte> bytes = file.read_rest();
  const Vector3d offset = options.in_map ? options.offset : Vector3d::Zero();
  cloud.shifted = true;
  // As text of other axes and units: points in double until they are turned.
  LineReader lines(as_text(bytes));
  WordSplitter split;
  while (lines.next()) {
    const std::string_view line = lines.line().substr(0, lines.line().find('#'));
    const std::vector<std::string_view>& words = split.blanks(line);
    if (words.empty()) continue;
    Vector3d point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto number = axis < words.size() ? parse_double(words[axis]) : std::nullopt;
      if (!number) {
        throw Error(ErrorKind::input,
                    fmt::format("{}, line {}: {} is no point of 3DTK, which begins with the three "
                                "numbers x y z",
                                file.path().string(), lines.number(), in_quotes(line)));
      }
      point[static_cast<int>(axis)] = *number;
    }
    cloud.points.push_back((right_handed(point) * kMetresPerUnit - offset).cast<float>());
  }
}

Pose read_3dtk_pose(const std::filesystem::path& file) {
  InputFile input(file);
  const std::vector<std::byte> bytes = input.read_rest();
  std::array<double, 6> numbers = {};
  std::size_t count = 0;
  LineReader lines(as_text(bytes));
  while (lines.next()) {
    std::string_view rest = lines.line();
    for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) {
      const auto number = parse_double(word);
      if (!number || !std::isfinite(*number) || count == numbers.size()) {
        throw Error(ErrorKind::input,
                    fmt::format("{}, line {}: {} must not be there: a pose of 3DTK is x y z and "
                                "three angles in degrees",
                                file.string(), lines.number(), in_quotes(word)));
      }
      numbers[count++] = *number;
    }
  }
  if (count < numbers.size()) {
    throw Error(ErrorKind::input,
                fmt::format("{} holds {} numbers: a pose of 3DTK is x y z and three angles in "
                            "degrees",
                            file.string(), count));
  }
  Eigen::Matrix3d turn;  // from 3DTK's axes to ours
  turn << 0, 0, 1, -1, 0, 0, 0, 1, 0;
  const Vector3d angles = Vector3d(numbers[3], numbers[4], numbers[5]) * (std::numbers::pi / 180);
  Pose pose = Pose::Identity();
  pose.linear() = turn * rotation_of(angles) * turn.transpose();
  pose.translation() = right_handed({numbers[0], numbers[1], numbers[2]}) * kMetresPerUnit;
  check_pose(pose);
  return pose;
}

}  // namespace rmap
