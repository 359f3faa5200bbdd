#include "io/pcd_header.hpp"

#include "io/point_columns.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <rmap/error.hpp>
#include <rmap/pose.hpp>

namespace rmap {

namespace {

constexpr std::array<std::string_view, 10> kKeys = {
    "VERSION", "FIELDS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};

constexpr std::size_t kMaxCount = 65535;  // numbers of one field; descriptors have some 100

// An entry of the header: the words behind a key.
struct Entry {
  std::size_t line = 0;  // 0: not there
  std::vector<std::string_view> words;
};

class HeaderParser {
 public:
  HeaderParser(const std::filesystem::path& file, std::string_view text)
      : file_(file), lines_(text) {}

  PcdHeader parse() {
    read_entries();
    PcdHeader header;
    header.size = lines_.offset();
    header.lines = lines_.number();
    header.data = data();
    header.points = points();
    header.viewpoint = viewpoint();
    lay_out(header);
    return header;
  }

 private:
  // Up to DATA, behind whose line the points begin.
  void read_entries() {
    while (!entry("DATA").line) {
      if (!lines_.next()) fail("the header has no DATA");
      std::string_view rest = lines_.line();
      const std::string_view key = next_word(rest);
      if (key.empty() || key.starts_with('#')) continue;
      const auto known = std::find(kKeys.begin(), kKeys.end(), key);
      if (known == kKeys.end()) {
        fail(lines_.number(), fmt::format("the header has {}, where one of {} is allowed",
                                          in_quotes(key), fmt::join(kKeys, ", ")));
      }
      Entry& entry = entries_[static_cast<std::size_t>(known - kKeys.begin())];
      if (entry.line) {
        fail(lines_.number(), fmt::format("{} stands in line {} already", key, entry.line));
      }
      entry.line = lines_.number();
      for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) {
        entry.words.push_back(word);
      }
    }
  }

  PcdData data() const {
    const std::string_view form = only_word("DATA");
    if (form == "ascii") return PcdData::ascii;
    if (form == "binary") return PcdData::binary;
    if (form == "binary_compressed") return PcdData::binary_compressed;
    fail(entry("DATA").line,
         fmt::format("DATA is {}, where ascii, binary and binary_compressed are allowed",
                     in_quotes(form)));
  }

  std::uint64_t points() const {
    const bool sized = entry("WIDTH").line || entry("HEIGHT").line;
    if (!sized) return number("POINTS");
    const std::uint64_t width = number("WIDTH");
    const std::uint64_t height = number("HEIGHT");
    std::uint64_t product = 0;
    if (__builtin_mul_overflow(width, height, &product)) {
      fail(entry("HEIGHT").line,
           fmt::format("WIDTH {} times HEIGHT {} is more than a file can hold", width, height));
    }
    if (entry("POINTS").line && number("POINTS") != product) {
      fail(entry("POINTS").line, fmt::format("POINTS is {}, which must be WIDTH {} times HEIGHT {}",
                                             number("POINTS"), width, height));
    }
    return product;
  }

  Pose viewpoint() const {
    const Entry& found = entry("VIEWPOINT");
    if (!found.line) return Pose::Identity();
    std::array<double, 7> numbers = {};
    for (std::size_t i = 0; i < found.words.size(); ++i) {
      const auto number = parse_double(found.words[i]);
      if (!number || i == numbers.size()) break;
      numbers[i] = *number;
      if (i + 1 < found.words.size() || i + 1 != numbers.size()) continue;
      try {
        return make_pose({numbers[0], numbers[1], numbers[2]},
                         Eigen::Quaterniond(numbers[3], numbers[4], numbers[5], numbers[6]));
      } catch (const Error& error) {
        fail(found.line, fmt::format("VIEWPOINT is no pose: {}", error.what()));
      }
    }
    fail(found.line,
         fmt::format("VIEWPOINT is {}, which must be seven numbers tx ty tz qw qx qy qz",
                     in_quotes(fmt::format("{}", fmt::join(found.words, " ")))));
  }

  void lay_out(PcdHeader& header) const {
    const std::vector<std::string_view>& words = required("FIELDS").words;
    const std::vector<std::string> names(words.begin(), words.end());
    std::vector<PcdField> fields;
    for (std::size_t i = 0; i < names.size(); ++i) {
      fields.push_back({.type = type(i), .offset = header.point_size, .word = header.words});
      header.point_size += size_of(fields[i].type) * count(i);
      header.words += count(i);
    }
    const auto found = find_point_fields(names);
    if (!found) {
      fail(entry("FIELDS").line,
           fmt::format("FIELDS is {}, which must have {}",
                       in_quotes(fmt::format("{}", fmt::join(names, " "))), kPointFieldNames));
    }
    header.coordinates = chosen(fields, found->point);
    if (found->origin) header.origins = chosen(fields, *found->origin);
  }

  std::array<PcdField, 3> chosen(const std::vector<PcdField>& fields,
                                 const std::array<std::size_t, 3>& places) const {
    std::array<PcdField, 3> result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t place = places[axis];
      if (count(place) != 1) {
        fail(entry("COUNT").line, fmt::format("COUNT of {} is {}, where 1 is allowed",
                                              required("FIELDS").words[place], count(place)));
      }
      result[axis] = fields[place];
    }
    return result;
  }

  NumberType type(std::size_t field) const {
    const char kind = letter(field);
    switch (size(field)) {
      case 1:
        return kind == 'I' ? NumberType::i8 : NumberType::u8;
      case 2:
        return kind == 'I' ? NumberType::i16 : NumberType::u16;
      case 4:
        return kind == 'F' ? NumberType::f32 : kind == 'I' ? NumberType::i32 : NumberType::u32;
      default:
        return kind == 'F' ? NumberType::f64 : kind == 'I' ? NumberType::i64 : NumberType::u64;
    }
  }

  char letter(std::size_t field) const {
    const std::string_view word = of_field("TYPE", field);
    if (word != "F" && word != "I" && word != "U") {
      fail(entry("TYPE").line, fmt::format("TYPE of field {} is {}, where F, I and U are allowed",
                                           name(field), in_quotes(word)));
    }
    return word[0];
  }

  std::size_t size(std::size_t field) const {
    const std::string_view word = of_field("SIZE", field);
    const bool real = letter(field) == 'F';
    const auto value = parse_unsigned(word);
    const bool allowed =
        value && (*value == 4 || *value == 8 || (!real && (*value == 1 || *value == 2)));
    if (!allowed) {
      fail(entry("SIZE").line,
           fmt::format("SIZE of field {} is {}, where {} are allowed for TYPE {}", name(field),
                       in_quotes(word), real ? "4 and 8" : "1, 2, 4 and 8", letter(field)));
    }
    return static_cast<std::size_t>(*value);
  }

  std::size_t count(std::size_t field) const {
    if (!entry("COUNT").line) return 1;
    const std::string_view word = of_field("COUNT", field);
    const auto value = parse_unsigned(word);
    if (!value || *value < 1 || *value > kMaxCount) {
      fail(entry("COUNT").line, fmt::format("COUNT of field {} is {}, where 1 to {} are allowed",
                                            name(field), in_quotes(word), kMaxCount));
    }
    return static_cast<std::size_t>(*value);
  }

  std::string name(std::size_t field) const { return in_quotes(entry("FIELDS").words[field]); }

  // The word of an entry that has one for each field.
  std::string_view of_field(std::string_view key, std::size_t field) const {
    const Entry& found = required(key);
    const std::size_t fields = entry("FIELDS").words.size();
    if (found.words.size() != fields) {
      fail(found.line, fmt::format("{} has {} entries, which must be one for each of the {} FIELDS",
                                   key, found.words.size(), fields));
    }
    return found.words[field];
  }

  std::uint64_t number(std::string_view key) const {
    const std::string_view word = only_word(key);
    const auto value = parse_unsigned(word);
    if (!value) {
      fail(entry(key).line, fmt::format("{} is {}, which must be a whole number from 0 to 2^64 - 1",
                                        key, in_quotes(word)));
    }
    return *value;
  }

  std::string_view only_word(std::string_view key) const {
    const Entry& found = required(key);
    if (found.words.size() != 1) {
      fail(found.line,
           fmt::format("{} has {} entries, which must be one", key, found.words.size()));
    }
    return found.words[0];
  }

  const Entry& required(std::string_view key) const {
    const Entry& found = entry(key);
    if (!found.line) fail(fmt::format("the header has no {}", key));
    return found;
  }

  const Entry& entry(std::string_view key) const {
    const auto known = std::find(kKeys.begin(), kKeys.end(), key);
    return entries_[static_cast<std::size_t>(known - kKeys.begin())];
  }

  [[noreturn]] void fail(std::size_t line, const std::string& problem) const {
    throw Error(ErrorKind::input, fmt::format("{}, line {}: {}", file_.string(), line, problem));
  }
  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(ErrorKind::input,
                fmt::format("{} is no sound PCD file: {}", file_.string(), problem));
  }

  const std::filesystem::path& file_;
  LineReader lines_;
  std::array<Entry, kKeys.size()> entries_;
};

}  // namespace

bool looks_like_pcd(std::string_view text) {
  LineReader lines(text);
  while (lines.next()) {
    std::string_view rest = lines.line();
    const std::string_view key = next_word(rest);
    if (key == "#" && next_word(rest) == ".PCD") return true;
    if (key.empty() || key.starts_with('#')) continue;
    return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
  }
  return false;
}

PcdHeader parse_pcd_header(const std::filesystem::path& file, std::string_view text) {
  return HeaderParser(file, text).parse();
}

}  // namespace rmap
