#include "io/text_points.hpp"

#include "io/point_columns.hpp"
#include "io/point_text.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

using Words = std::vector<std::string_view>;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kMapCollection = "MAPNODEID";

std::string_view without_comment(std::string_view line) {
  line = line.substr(0, line.find('#'));
  return line.substr(0, line.find("//"));
}

bool is_blank(const Words& words) {
  return std::all_of(words.begin(), words.end(),
                     [](std::string_view word) { return word.empty(); });
}

bool has_name(const Words& words) {
  return std::any_of(words.begin(), words.end(),
                     [](std::string_view word) { return !word.empty() && !parse_double(word); });
}

std::string_view without_quotes(std::string_view word) {
  const bool quoted = word.size() >= 2 && word.front() == '"' && word.back() == '"';
  return quoted ? word.substr(1, word.size() - 2) : word;
}

class TextPointReader {
 public:
  TextPointReader(const std::filesystem::path& file, std::string_view text,
                  const PointReadOptions& options, PointCloud& cloud)
      : file_(file), lines_(text), options_(options), cloud_(cloud) {}

  void read() {
    while (lines_.next()) {
      if (!points_) read_comment(lines_.line());
      const Words& words = split_.separators(without_comment(lines_.line()));
      if (is_blank(words)) continue;
      if (!points_) {
        if (read_head(words)) continue;
        columns_ = words.size();
        points_.emplace(commented_ && commented_columns_ == columns_
                            ? *commented_
                            : PointWords{.point = {0, 1, 2}, .origin = std::nullopt},
                        options_, cloud_);
      }
      read_point(words);
    }
    if (announced_ && *announced_ != cloud_.points.size()) {
      throw Error(ErrorKind::input,
                  fmt::format("{} announces {} points in its first line and holds {}",
                              file_.string(), *announced_, cloud_.points.size()));
    }
    if (cloud_.points.empty() && !announced_) {
      throw Error(ErrorKind::input, fmt::format("{} holds no point: a text of points has a line of "
                                                "at least three numbers for each",
                                                file_.string()));
    }
  }

 private:
  // Names of columns may stand in a comment before the points, as some programs write them.
  void read_comment(std::string_view line) {
    const std::size_t begin = line.find_first_not_of("#/ \t");
    const bool comment = line.starts_with('#') || line.starts_with("//");
    if (!comment || begin == std::string_view::npos) return;
    const Words& words = split_.separators(line.substr(begin));
    const auto fields = fields_of(words);
    if (!fields) return;
    commented_ = PointWords{.point = fields->point, .origin = fields->origin};
    commented_columns_ = words.size();
  }

  static std::optional<PointFields> fields_of(const Words& words) {
    std::vector<std::string> names;
    for (const std::string_view word : words) names.emplace_back(without_quotes(word));
    return find_point_fields(names);
  }

  // Whether the first line that says anything is no point: names or how many there are.
  bool read_head(const Words& words) {
    if (!announced_ && words.size() == 1) {
      announced_ = parse_unsigned(words.front());
      if (announced_) return true;
    }
    if (!has_name(words)) return false;
    if (words.front() == kMapCollection) {
      throw Error(ErrorKind::input,
                  fmt::format("{} is a collection of OctoMap maps, not points: its maps are read "
                              "one by one",
                              file_.string()));
    }
    const auto fields = fields_of(words);
    if (!fields) {
      fail(fmt::format("{} are neither a point nor the names of columns, among which must be {}",
                       in_quotes(fmt::format("{}", fmt::join(words, " "))), kPointFieldNames));
    }
    points_.emplace(PointWords{.point = fields->point, .origin = fields->origin}, options_, cloud_);
    columns_ = words.size();
    return true;
  }

  void read_point(const Words& words) {
    if (words.size() < 3) {
      fail(fmt::format("the point has {} numbers, which must be at least three", words.size()));
    }
    // A separator may end the line.
    const bool ended = words.size() == columns_ + 1 && words.back().empty();
    if (words.size() != columns_ && !ended) {
      fail(fmt::format("the point has {} columns, which must be {} as in the lines before",
                       words.size(), columns_));
    }
    points_->add(file_, lines_.number(), words);
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(ErrorKind::input,
                fmt::format("{}, line {}: {}", file_.string(), lines_.number(), problem));
  }

  const std::filesystem::path& file_;
  LineReader lines_;
  const PointReadOptions& options_;
  PointCloud& cloud_;
  WordSplitter split_;
  std::optional<PointTextReader> points_;
  std::optional<std::uint64_t> announced_;
  std::optional<PointWords> commented_;  // where a comment says the coordinates are
  std::size_t commented_columns_ = 0;
  std::size_t columns_ = 0;
};

}  // namespace

void read_text_points(InputFile& file, const PointReadOptions& options, PointCloud& cloud) {
  const std::vector<std::byte> bytes = file.read_rest();
  std::string_view text = as_text(bytes);
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  TextPointReader(file.path(), text, options, cloud).read();
}

}  // namespace rmap
