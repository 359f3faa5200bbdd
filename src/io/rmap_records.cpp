#include "io/rmap_records.hpp"

#include "io/rmap_format.hpp"

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap::wire {

namespace {

// The numbers of OPTS, in their order in the file.
constexpr std::array kNumbers = {&Options::resolution,         &Options::prob_hit,
                                 &Options::prob_miss,          &Options::clamp_min,
                                 &Options::clamp_max,          &Options::prior,
                                 &Options::occupied_threshold, &Options::free_probability,
                                 &Options::min_range,          &Options::max_range};

// Choices by their number in the file, which is not their number in memory.
constexpr std::array kSaturations = {Saturation::clamp, Saturation::freeze};
constexpr std::array kBeams = {Beams::all, Beams::per_end_cell};
constexpr std::array kHistories = {History::first_hit, History::complete};

template <class Choice, std::size_t kCount>
std::uint32_t number_of(Choice choice, const std::array<Choice, kCount>& choices) {
  std::uint32_t number = 0;
  while (choices[number] != choice) ++number;
  return number;
}

template <class Choice, std::size_t kCount>
Choice choice_of(const std::byte* bytes, const char* name,
                 const std::array<Choice, kCount>& choices) {
  const auto number = load_little<std::uint32_t>(bytes);
  if (number < kCount) return choices[number];
  throw Error(ErrorKind::input,
              fmt::format("has {} for {}: at most {} is known", number, name, kCount - 1));
}

void require_size(std::span<const std::byte> content, std::size_t size) {
  if (content.size() == size) return;
  throw Error(ErrorKind::input,
              fmt::format("has {} bytes of content: it must have {}", content.size(), size));
}

}  // namespace

std::vector<std::byte> encoded_options(const Options& options) {
  std::vector<std::byte> content;
  for (const auto number : kNumbers) append_without_negative_zero(content, options.*number);
  append(content, number_of(options.saturation, kSaturations));
  append(content, number_of(options.beams, kBeams));
  return content;
}

Options decoded_options(std::span<const std::byte> content) {
  require_size(content, kOptionsSize);
  Options options;
  const std::byte* next = content.data();
  for (const auto number : kNumbers) {
    options.*number = load_little<double>(next);
    next += sizeof(double);
  }
  options.saturation = choice_of(next, "saturation", kSaturations);
  options.beams = choice_of(next + sizeof(std::uint32_t), "beams", kBeams);
  try {
    check_options(options);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("holds options that are not allowed: {}", error.what()));
  }
  return options;
}

std::vector<std::byte> encoded_history(History history) {
  std::vector<std::byte> content;
  append(content, number_of(history, kHistories));
  return content;
}

History decoded_history(std::span<const std::byte> content) {
  require_size(content, sizeof(std::uint32_t));
  return choice_of(content.data(), "the history", kHistories);
}

std::vector<std::byte> encoded_poses(std::span<const Pose> poses) {
  std::vector<std::byte> content;
  content.reserve(poses.size() * kPoseSize);
  for (const Pose& pose : poses) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        append_without_negative_zero(content, pose(row, column));
      }
    }
  }
  return content;
}

void decode_poses(std::span<const std::byte> content, std::uint64_t stored_size,
                  std::vector<Pose>& poses) {
  const auto least = least_size_of_poses(content.size() / kPoseSize);
  if (stored_size < least) {
    throw Error(ErrorKind::input,
                fmt::format("takes {} bytes for {} bytes of poses: it must take at least {}",
                            stored_size, content.size(), least));
  }
  if (content.empty() || content.size() % kPoseSize != 0) {
    throw Error(ErrorKind::input,
                fmt::format("has {} bytes of content: it must have a multiple of {}, and at least "
                            "one",
                            content.size(), kPoseSize));
  }
  for (std::size_t offset = 0; offset < content.size(); offset += kPoseSize) {
    Pose pose = Pose::Identity();
    const std::byte* next = &content[offset];
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        pose(row, column) = load_little<double>(next);
        next += sizeof(double);
      }
    }
    try {
      check_pose(pose);
    } catch (const Error& error) {
      throw Error(error.kind(),
                  fmt::format("holds no pose at byte {} of its content: {}", offset, error.what()));
    }
    poses.push_back(pose);
  }
}

}  // namespace rmap::wire
