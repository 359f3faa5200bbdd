#include "io/point_text.hpp"

#include "io/text.hpp"

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

// Nobody has so many; a hostile line of commas would take 16 times its length.
constexpr std::size_t kMostColumns = 65536;
constexpr std::string_view kBlanks = " \t\r\v\f";

[[noreturn]] void fail(const std::filesystem::path& file, std::size_t line, std::size_t axis,
                       std::string_view word) {
  throw Error(ErrorKind::input, fmt::format("{}, line {}: {} is {}, which must be a number",
                                            file.string(), line, "xyz"[axis], in_quotes(word)));
}

std::string_view trimmed(std::string_view word) {
  const std::size_t begin = word.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return word.substr(begin, word.find_last_not_of(kBlanks) - begin + 1);
}

}  // namespace

const std::vector<std::string_view>& WordSplitter::blanks(std::string_view line) {
  words_.clear();
  for (auto word = next_word(line); !word.empty(); word = next_word(line)) words_.push_back(word);
  return words_;
}

const std::vector<std::string_view>& WordSplitter::separators(std::string_view line) {
  const char separator = line.find(';') != std::string_view::npos ? ';' : ',';
  words_.clear();
  if (line.find(separator) == std::string_view::npos) {
    for (auto word = next_word(line); !word.empty() && words_.size() < kMostColumns;
         word = next_word(line)) {
      words_.push_back(word);
    }
    return words_;
  }
  for (bool more = true; more && words_.size() < kMostColumns;) {
    const std::size_t end = line.find(separator);
    more = end != std::string_view::npos;
    words_.push_back(trimmed(line.substr(0, end)));
    if (more) line.remove_prefix(end + 1);
  }
  return words_;
}

PointTextReader::PointTextReader(const PointWords& places, const PointReadOptions& options,
                                 PointCloud& cloud)
    : places_(places),
      offset_(options.in_map || places.origin ? options.offset : Vector3d::Zero()),
      cloud_(cloud) {
  cloud_.shifted = true;
}

void PointTextReader::add(const std::filesystem::path& file, std::size_t line,
                          std::span<const std::string_view> words) {
  if (cloud_.points.size() == kMaxPointsPerFile) {
    throw Error(ErrorKind::limit, fmt::format("{} holds more than {} points, which are allowed in "
                                              "a file",
                                              file.string(), kMaxPointsPerFile));
  }
  Vector3f point;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view word = words[places_.point[axis]];
    const int row = static_cast<int>(axis);
    if (offset_[row] == 0) {
      const auto value = parse_float(word);
      if (!value) fail(file, line, axis, word);
      point[row] = *value;
    } else {
      const auto value = parse_double(word);
      if (!value) fail(file, line, axis, word);
      point[row] = static_cast<float>(*value - offset_[row]);
    }
  }
  cloud_.points.push_back(point);
  if (!places_.origin) return;
  Vector3d origin;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view word = words[(*places_.origin)[axis]];
    const auto value = parse_double(word);
    if (!value) fail(file, line, axis, word);
    const int row = static_cast<int>(axis);
    origin[row] = *value - offset_[row];
  }
  cloud_.origins.push_back(origin);
}

}  // namespace rmap
