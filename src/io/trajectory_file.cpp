#include "io/decimal_time.hpp"
#include "io/input_file.hpp"
#include "io/memory.hpp"
#include "io/pose_math.hpp"
#include "io/text.hpp"
#include "io/trajectory.hpp"

#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr std::size_t kTum = 8;
constexpr std::size_t kKitti = 12;

Error line_error(const std::filesystem::path& file, std::size_t line, std::string_view problem) {
  return {ErrorKind::input, fmt::format("{}, line {}: {}", file.string(), line, problem)};
}

// What is left of a line without its comment.
std::string_view content_of(std::string_view line) { return line.substr(0, line.find('#')); }

struct Words {
  std::array<std::string_view, kKitti> words = {};
  std::size_t count = 0;
};

Words words_of(std::string_view text) {
  Words words;
  for (auto word = next_word(text); !word.empty(); word = next_word(text)) {
    if (words.count < words.words.size()) words.words[words.count] = word;
    ++words.count;
  }
  return words;
}

double number_of(std::string_view word) {
  const auto number = parse_double(word);
  if (!number) {
    throw Error(ErrorKind::input,
                fmt::format("{} is no number, which a pose is made of", in_quotes(word)));
  }
  return *number;
}

std::int64_t time_of(std::string_view word) {
  const auto time = parse_time(word);
  if (!time) {
    throw Error(ErrorKind::input, fmt::format("{} is no time: seconds as a decimal number, within "
                                              "+-9.2e9, are allowed",
                                              in_quotes(word)));
  }
  return *time;
}

TimedPose tum_pose(const Words& words, QuaternionOrder order) {
  std::array<double, kTum> n{};
  for (std::size_t i = 1; i < kTum; ++i) n[i] = number_of(words.words[i]);
  return {.stamp = time_of(words.words[0]),
          .pose = make_pose({n[1], n[2], n[3]}, quaternion_of(&n[4], order))};
}

TimedPose kitti_pose(const Words& words) {
  std::array<double, kKitti> n{};
  for (std::size_t i = 0; i < kKitti; ++i) n[i] = number_of(words.words[i]);
  return {.stamp = 0, .pose = matrix_pose(n.data())};
}

// Calls use(content) for each line that is not blank; its errors get the line's number.
template <class Use>
void for_each_line(const std::filesystem::path& file, Use&& use) {
  const std::vector<std::byte> bytes = InputFile(file).read_rest();
  LineReader lines(as_text(bytes));
  while (lines.next()) {
    const Words words = words_of(content_of(lines.line()));
    if (words.count == 0) continue;
    try {
      use(words);
    } catch (const Error& error) {
      throw line_error(file, lines.number(), error.what());
    }
  }
}

struct PoseLines {
  std::vector<TimedPose> poses;
  std::size_t form = 0;  // numbers a line; 0 without lines
};

PoseLines read_pose_lines(const std::filesystem::path& file, QuaternionOrder order) {
  PoseLines lines;
  for_each_line(file, [&](const Words& words) {
    if (words.count != kTum && words.count != kKitti) {
      throw Error(ErrorKind::input,
                  fmt::format("the pose has {} numbers, where 8 (TUM: time tx ty tz qx qy qz qw) "
                              "and 12 (KITTI: 3x4 matrix) are allowed",
                              words.count));
    }
    if (lines.form == 0) lines.form = words.count;
    if (words.count != lines.form) {
      throw Error(ErrorKind::input, fmt::format("the pose has {} numbers, which must be {} as in "
                                                "the lines before",
                                                words.count, lines.form));
    }
    lines.poses.push_back(words.count == kTum ? tum_pose(words, order) : kitti_pose(words));
  });
  return lines;
}

void give_times(std::vector<TimedPose>& poses, const std::filesystem::path& file,
                const std::filesystem::path& times_file) {
  const std::vector<std::int64_t> times = read_times(times_file);
  if (times.size() != poses.size()) {
    throw Error(ErrorKind::input,
                fmt::format("{} holds {} times and {} holds {} poses: there must be one time for "
                            "each pose",
                            times_file.string(), times.size(), file.string(), poses.size()));
  }
  for (std::size_t i = 0; i < poses.size(); ++i) poses[i].stamp = times[i];
}

}  // namespace

std::vector<std::int64_t> read_times(const std::filesystem::path& file) {
  std::vector<std::int64_t> times;
  for_each_line(file, [&](const Words& words) {
    if (words.count != 1) {
      throw Error(ErrorKind::input,
                  fmt::format("the line has {} words, where one time is allowed", words.count));
    }
    times.push_back(time_of(words.words[0]));
  });
  return times;
}

Trajectory read_trajectory(const std::filesystem::path& file, const std::filesystem::path& times,
                           QuaternionOrder order) {
  return with_memory_for(file, [&] {
    PoseLines lines = read_pose_lines(file, order);
    if (lines.form == 0) {
      throw Error(ErrorKind::input,
                  fmt::format("{} holds no pose: at least one is needed", file.string()));
    }
    if (lines.form == kKitti && times.empty()) {
      throw Error(ErrorKind::usage,
                  fmt::format("the poses of {} have no times: a file with a time for each is "
                              "needed beside it (--times)",
                              file.string()));
    }
    if (lines.form == kTum && !times.empty()) {
      throw Error(ErrorKind::usage,
                  fmt::format("the poses of {} have times of their own, so {} (--times) has no "
                              "meaning",
                              file.string(), times.string()));
    }
    if (lines.form == kKitti) give_times(lines.poses, file, times);
    return Trajectory(std::move(lines.poses));
  });
}

}  // namespace rmap
