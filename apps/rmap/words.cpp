#include "words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace rmap::command {

template <>
std::span<const Word<BadPoints>> words<BadPoints>() {
  static constexpr std::array kWords = {
      Word<BadPoints>{"skip", BadPoints::skip},
      Word<BadPoints>{"error", BadPoints::error},
  };
  return kWords;
}

template <>
std::span<const Word<Beams>> words<Beams>() {
  static constexpr std::array kWords = {
      Word<Beams>{"all", Beams::all},
      Word<Beams>{"per_end_cell", Beams::per_end_cell},
  };
  return kWords;
}

template <>
std::span<const Word<CellChoice>> words<CellChoice>() {
  static constexpr std::array kWords = {
      Word<CellChoice>{"occupied", CellChoice::occupied},
      Word<CellChoice>{"all", CellChoice::all},
  };
  return kWords;
}

template <>
std::span<const Word<Criterion>> words<Criterion>() {
  static constexpr std::array kWords = {
      Word<Criterion>{"mean", Criterion::mean},
      Word<Criterion>{"max", Criterion::max},
  };
  return kWords;
}

template <>
std::span<const Word<CuboidMethod>> words<CuboidMethod>() {
  static constexpr std::array kWords = {
      Word<CuboidMethod>{"auto", CuboidMethod::automatic},
      Word<CuboidMethod>{"cover", CuboidMethod::cover},
      Word<CuboidMethod>{"split", CuboidMethod::split},
      Word<CuboidMethod>{"runs", CuboidMethod::runs},
      Word<CuboidMethod>{"midpoint", CuboidMethod::midpoint},
  };
  return kWords;
}

template <>
std::span<const Word<CuboidPhase>> words<CuboidPhase>() {
  static constexpr std::array kWords = {
      Word<CuboidPhase>{"zero", CuboidPhase::zero},
      Word<CuboidPhase>{"centre", CuboidPhase::centre},
  };
  return kWords;
}

template <>
std::span<const Word<CuboidWeight>> words<CuboidWeight>() {
  static constexpr std::array kWords = {
      Word<CuboidWeight>{"points", CuboidWeight::points},
      Word<CuboidWeight>{"cells", CuboidWeight::cells},
  };
  return kWords;
}

template <>
std::span<const Word<Face>> words<Face>() {
  static constexpr std::array kWords = {
      Word<Face>{"none", Face::none},   Word<Face>{"min_x", Face::min_x},
      Word<Face>{"max_x", Face::max_x}, Word<Face>{"min_y", Face::min_y},
      Word<Face>{"max_y", Face::max_y}, Word<Face>{"min_z", Face::min_z},
      Word<Face>{"max_z", Face::max_z},
  };
  return kWords;
}

template <>
std::span<const Word<Frame>> words<Frame>() {
  static constexpr std::array kWords = {
      Word<Frame>{"sensor", Frame::sensor},
      Word<Frame>{"world", Frame::map},
  };
  return kWords;
}

template <>
std::span<const Word<History>> words<History>() {
  static constexpr std::array kWords = {
      Word<History>{"complete", History::complete},
      Word<History>{"first_hit", History::first_hit},
  };
  return kWords;
}

template <>
std::span<const Word<Layout>> words<Layout>() {
  static constexpr std::array kWords = {
      Word<Layout>{"blocks", Layout::blocks},
      Word<Layout>{"cells", Layout::cells},
  };
  return kWords;
}

template <>
std::span<const Word<QuaternionOrder>> words<QuaternionOrder>() {
  static constexpr std::array kWords = {
      Word<QuaternionOrder>{"xyzw", QuaternionOrder::xyzw},
      Word<QuaternionOrder>{"wxyz", QuaternionOrder::wxyz},
  };
  return kWords;
}

template <>
std::span<const Word<Saturation>> words<Saturation>() {
  static constexpr std::array kWords = {
      Word<Saturation>{"clamp", Saturation::clamp},
      Word<Saturation>{"freeze", Saturation::freeze},
  };
  return kWords;
}

template <>
std::span<const Word<ScanEnding>> words<ScanEnding>() {
  static constexpr std::array kWords = {
      Word<ScanEnding>{"bin", ScanEnding::bin},
      Word<ScanEnding>{"pcd", ScanEnding::pcd},
  };
  return kWords;
}

template <>
std::span<const Word<Side>> words<Side>() {
  static constexpr std::array kWords = {
      Word<Side>{"outside", Side::outside},
      Word<Side>{"inside", Side::inside},
  };
  return kWords;
}

template <>
std::span<const Word<Split>> words<Split>() {
  static constexpr std::array kWords = {
      Word<Split>{"quadratic", Split::quadratic},
      Word<Split>{"linear", Split::linear},
  };
  return kWords;
}

template <>
std::span<const Word<State>> words<State>() {
  static constexpr std::array kWords = {
      Word<State>{"occupied", State::occupied},
      Word<State>{"free", State::free},
      Word<State>{"assumed_free", State::assumed_free},
  };
  return kWords;
}

template <>
std::span<const Word<Traversal>> words<Traversal>() {
  static constexpr std::array kWords = {
      Word<Traversal>{"automatic", Traversal::automatic},
      Word<Traversal>{"inverse", Traversal::inverse},
      Word<Traversal>{"forward", Traversal::forward},
  };
  return kWords;
}

bool same_word(std::string_view a, std::string_view b) {
  const auto plain = [](char character) { return character == '-' ? '_' : character; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return plain(x) == plain(y); });
}

std::string grouped(std::uint64_t number) {
  std::string text = fmt::format("{}", number);
  for (std::size_t place = text.size(); place > 3;) {
    place -= 3;
    text.insert(place, 1, ',');
  }
  return text;
}

std::string counted(std::uint64_t number, std::string_view noun) {
  return fmt::format("{} {}{}", grouped(number), noun, number == 1 ? "" : "s");
}

std::string readable_bytes(std::uint64_t bytes) {
  if (bytes < 1024) return fmt::format("{} B", bytes);
  double number = static_cast<double>(bytes);
  const char* unit = "";
  for (const char* larger : {"KiB", "MiB", "GiB", "TiB"}) {
    if (number < 1024) break;
    number /= 1024;
    unit = larger;
  }
  return fmt::format("{:.1f} {}", number, unit);
}

std::string printable(std::string_view text) {
  std::string result;
  for (const char character : text) {
    const auto code = static_cast<unsigned char>(character);
    if (code < ' ' || code == 0x7f) {
      result += fmt::format("\\x{:02x}", code);
    } else {
      result += character;
    }
  }
  return result;
}

std::string in_brackets(const Vector3d& vector) {
  const auto readable = [](double metres) {
    // Far from the origin six digits end before the decimal point.
    return std::abs(metres) < 1000 ? fmt::format("{:.6g}", metres) : fmt::format("{:.3f}", metres);
  };
  return fmt::format("({}, {}, {})", readable(vector.x()), readable(vector.y()),
                     readable(vector.z()));
}

std::string readable_box(const Box& box) {
  return fmt::format("{} to {}", in_brackets(box.min), in_brackets(box.max));
}

}  // namespace rmap::command
