#include "io/octomap/header.hpp"

#include "io/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/lattice.hpp>

namespace rmap::octomap {

namespace {

constexpr std::string_view kStatesMagic = "# Octomap OcTree binary file";
constexpr std::string_view kValuesMagic = "# Octomap OcTree file";

// The trees whose nodes are known: a float each, then three bytes of a ColorOcTree. The time
// stamps of an OcTreeStamped are not in its file. "1" is what early releases called an OcTree.
constexpr std::array<std::string_view, 4> kKnownTrees{"OcTree", "ColorOcTree", "OcTreeStamped",
                                                      "1"};

/// `key value` in each line, comments, and `data` as the last one.
class HeaderReader {
 public:
  explicit HeaderReader(ByteReader& bytes) : bytes_(bytes) {}

  Header read() {
    read_first_line();
    while (line() != "data") {
      if (line_.empty() || line_.front() == '#') continue;
      read_entry(line_);
    }
    if (!id_) throw refusal("its header has no line \"id\"");
    if (!nodes_) throw refusal("its header has no line \"size\"");
    if (!resolution_) throw refusal("its header has no line \"res\"");
    check_resolution();
    return {.id = *id_ == "1" ? "OcTree" : *id_,
            .states_only = states_only_,
            .nodes = *nodes_,
            .resolution = *resolution_};
  }

 private:
  static constexpr std::size_t kLongestLine = 1000;
  static constexpr std::string_view kBlanks = " \t";

  Error refusal(std::string_view why) const {
    return Error(ErrorKind::input, fmt::format("{} is not a map of OctoMap (.bt, .ot): {}",
                                               bytes_.file().string(), why));
  }

  void read_first_line() {
    const std::string refused =
        fmt::format("it does not begin with \"{}\" or \"{}\"", kStatesMagic, kValuesMagic);
    // A file of another kind is called that, not cut off.
    if (bytes_.remaining() <= kValuesMagic.size()) throw refusal(refused);
    states_only_ = line().starts_with(kStatesMagic);
    if (!states_only_ && !line_.starts_with(kValuesMagic)) throw refusal(refused);
  }

  const std::string& line() {
    line_.clear();
    for (;;) {
      const auto byte = static_cast<char>(bytes_.take(1, "the header's line")[0]);
      if (byte == '\n') break;
      if (line_.size() == kLongestLine) throw refusal("a line of its header does not end");
      line_.push_back(byte);
    }
    if (!line_.empty() && line_.back() == '\r') line_.pop_back();
    return line_;
  }

  template <class Number>
  Number number(std::string_view key, std::string_view text) const {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) {
      throw refusal(fmt::format("\"{}\" in its header is followed by {}, not by a number", key,
                                in_quotes(text)));
    }
    return number;
  }

  void read_entry(std::string_view line) {
    const std::size_t space = std::min(line.find_first_of(kBlanks), line.size());
    const std::string_view key = line.substr(0, space);
    std::string_view value = line.substr(space);
    value.remove_prefix(std::min(value.find_first_not_of(kBlanks), value.size()));
    value = value.substr(0, value.find_last_not_of(kBlanks) + 1);
    if (key == "id") {
      if (std::find(kKnownTrees.begin(), kKnownTrees.end(), value) == kKnownTrees.end()) {
        throw refusal(
            fmt::format("it holds a tree of type {}: OcTree, ColorOcTree and "
                        "OcTreeStamped can be read",
                        in_quotes(value)));
      }
      id_ = value;
    } else if (key == "size") {
      nodes_ = number<std::uint64_t>(key, value);
    } else if (key == "res") {
      resolution_ = number<double>(key, value);
    }
  }

  void check_resolution() const {
    try {
      const Lattice lattice(*resolution_);
    } catch (const Error& error) {
      throw Error(error.kind(),
                  fmt::format("{} is of no use: its {}", bytes_.file().string(), error.what()));
    }
  }

  ByteReader& bytes_;
  std::string line_;
  bool states_only_ = false;
  std::optional<std::string> id_;
  std::optional<std::uint64_t> nodes_;
  std::optional<double> resolution_;
};

}  // namespace

Header read_header(ByteReader& bytes) { return HeaderReader(bytes).read(); }

std::string text_of(const Header& header) {
  return fmt::format(
      "{}\n# (feel free to add / change comments, but leave the first line as it is!)\n#\n"
      "id {}\nsize {}\nres {}\ndata\n",
      header.states_only ? kStatesMagic : kValuesMagic, header.id, header.nodes, header.resolution);
}

}  // namespace rmap::octomap
