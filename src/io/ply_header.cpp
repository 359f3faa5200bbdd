#include "io/ply_header.hpp"

#include "io/text.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

// A file needs few; a hostile one could name a million properties for each byte of data.
constexpr std::size_t kMaxProperties = 1024;

constexpr std::array<std::pair<std::string_view, NumberType>, 16> kTypes = {
    {{"char", NumberType::i8},
     {"uchar", NumberType::u8},
     {"short", NumberType::i16},
     {"ushort", NumberType::u16},
     {"int", NumberType::i32},
     {"uint", NumberType::u32},
     {"float", NumberType::f32},
     {"double", NumberType::f64},
     {"int8", NumberType::i8},
     {"uint8", NumberType::u8},
     {"int16", NumberType::i16},
     {"uint16", NumberType::u16},
     {"int32", NumberType::i32},
     {"uint32", NumberType::u32},
     {"float32", NumberType::f32},
     {"float64", NumberType::f64}}};

class HeaderParser {
 public:
  HeaderParser(const std::filesystem::path& file, std::string_view text)
      : file_(file), lines_(text) {}

  PlyHeader parse() {
    if (!lines_.next() || lines_.line() != "ply") fail("a PLY file begins with the line ply");
    bool formatted = false;
    for (;;) {
      if (!lines_.next()) fail("the header has no line end_header");
      std::string_view rest = lines_.line();
      const std::string_view key = next_word(rest);
      if (key == "end_header") break;
      if (key.empty() || key == "comment" || key == "obj_info") continue;
      if (key == "format") {
        read_format(rest);
        formatted = true;
      } else if (key == "element") {
        read_element(rest);
      } else if (key == "property") {
        read_property(rest);
      } else {
        fail(
            fmt::format("the header has {}, where format, comment, obj_info, element, property "
                        "and end_header are allowed",
                        in_quotes(key)));
      }
    }
    if (!formatted) fail("the header has no line format");
    header_.size = lines_.offset();
    header_.lines = lines_.number();
    return std::move(header_);
  }

 private:
  void read_format(std::string_view rest) {
    const std::string_view form = next_word(rest);
    const std::string_view version = next_word(rest);
    if (form == "ascii") {
      header_.form = PlyForm::ascii;
    } else if (form == "binary_little_endian") {
      header_.form = PlyForm::little_endian;
    } else if (form == "binary_big_endian") {
      header_.form = PlyForm::big_endian;
    } else {
      fail(
          fmt::format("the format is {}, where ascii, binary_little_endian and "
                      "binary_big_endian are allowed",
                      in_quotes(form)));
    }
    if (version != "1.0") {
      fail(
          fmt::format("the version of the format is {}, where 1.0 is allowed", in_quotes(version)));
    }
  }

  void read_element(std::string_view rest) {
    PlyElement element{.name = std::string(next_word(rest)), .count = 0, .properties = {}};
    const std::string_view word = next_word(rest);
    const auto count = parse_unsigned(word);
    if (!count) {
      fail(
          fmt::format("the number of elements {} is {}, which must be a whole number from 0 to "
                      "2^64 - 1",
                      in_quotes(element.name), in_quotes(word)));
    }
    element.count = *count;
    header_.elements.push_back(std::move(element));
  }

  void read_property(std::string_view rest) {
    if (header_.elements.empty()) fail("a property stands before the first element");
    if (++properties_ > kMaxProperties) {
      fail(
          fmt::format("the header has more than {} properties, which are allowed", kMaxProperties));
    }
    PlyProperty property;
    std::string_view word = next_word(rest);
    if (word == "list") {
      property.list_size = type(next_word(rest));
      if (*property.list_size == NumberType::f32 || *property.list_size == NumberType::f64) {
        fail("the size of a list must be a whole number");
      }
      word = next_word(rest);
    }
    property.type = type(word);
    property.name = next_word(rest);
    header_.elements.back().properties.push_back(std::move(property));
  }

  NumberType type(std::string_view word) const {
    const auto known = std::find_if(kTypes.begin(), kTypes.end(),
                                    [&](const auto& entry) { return entry.first == word; });
    if (known == kTypes.end()) {
      fail(
          fmt::format("the type of a property is {}, where char, uchar, short, ushort, int, uint, "
                      "float, double and int8 to float64 are allowed",
                      in_quotes(word)));
    }
    return known->second;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(ErrorKind::input,
                fmt::format("{}, line {}: {}", file_.string(), lines_.number(), problem));
  }

  const std::filesystem::path& file_;
  LineReader lines_;
  PlyHeader header_;
  std::size_t properties_ = 0;
};

}  // namespace

bool PlyElement::has_list() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& property) { return property.list_size.has_value(); });
}

std::size_t PlyElement::size() const {
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties) bytes += size_of(property.type);
  return bytes;
}

bool looks_like_ply(std::string_view text) {
  return text.starts_with("ply\n") || text.starts_with("ply\r\n");
}

PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view text) {
  return HeaderParser(file, text).parse();
}

}  // namespace rmap
