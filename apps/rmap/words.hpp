#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <rmap/approximate.hpp>
#include <rmap/box_query.hpp>
#include <rmap/cast_ray.hpp>
#include <rmap/cuboid_frame.hpp>
#include <rmap/grid.hpp>
#include <rmap/scan_read_options.hpp>
#include <rmap/simulation/scene.hpp>

namespace rmap::command {

/// A value of an enumeration and the word for it on the command line and in answers:
/// the library's name.
template <class Enum>
struct Word {
  std::string_view word;
  Enum value;
};

/// The files that scans are written to.
enum class ScanEnding { bin, pcd };

/// Which cells of a map leave for other programs.
enum class CellChoice { occupied, all };

/// All words of an enumeration.
template <class Enum>
std::span<const Word<Enum>> words();

template <>
std::span<const Word<BadPoints>> words<BadPoints>();
template <>
std::span<const Word<Beams>> words<Beams>();
template <>
std::span<const Word<CellChoice>> words<CellChoice>();
template <>
std::span<const Word<Criterion>> words<Criterion>();
template <>
std::span<const Word<CuboidMethod>> words<CuboidMethod>();
template <>
std::span<const Word<CuboidPhase>> words<CuboidPhase>();
template <>
std::span<const Word<CuboidWeight>> words<CuboidWeight>();
template <>
std::span<const Word<Face>> words<Face>();
template <>
std::span<const Word<Frame>> words<Frame>();
template <>
std::span<const Word<History>> words<History>();
template <>
std::span<const Word<Layout>> words<Layout>();
template <>
std::span<const Word<QuaternionOrder>> words<QuaternionOrder>();
template <>
std::span<const Word<Saturation>> words<Saturation>();
template <>
std::span<const Word<ScanEnding>> words<ScanEnding>();
template <>
std::span<const Word<Side>> words<Side>();
template <>
std::span<const Word<Split>> words<Split>();
template <>
std::span<const Word<State>> words<State>();
template <>
std::span<const Word<Traversal>> words<Traversal>();

template <class Enum>
std::string_view word_of(Enum value) {
  for (const auto& entry : words<Enum>()) {
    if (entry.value == value) return entry.word;
  }
  return "";
}

/// Whether two words are the same but for `-` in place of `_`: first-hit is first_hit.
bool same_word(std::string_view a, std::string_view b);

template <class Enum>
std::optional<Enum> find_word(std::string_view text) {
  for (const auto& entry : words<Enum>()) {
    if (same_word(entry.word, text)) return entry.value;
  }
  return std::nullopt;
}

/// The words as a list: "blocks or cells".
template <class Enum>
std::string word_list() {
  std::string list;
  const auto all = words<Enum>();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) list += i + 1 == all.size() ? " or " : ", ";
    list += all[i].word;
  }
  return list;
}

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number);
/// A number with the word for what is counted: "1 scan", "1,234 scans".
std::string counted(std::uint64_t number, std::string_view noun);
/// Bytes as people read them: "3.4 MiB".
std::string readable_bytes(std::uint64_t bytes);
/// A name that a stranger gave, fit for a terminal: control characters as \xNN.
std::string printable(std::string_view text);
/// "(1, 2.5, 3)".
std::string in_brackets(const Vector3d& vector);
/// "(0, 0, 0) to (1, 2, 3)".
std::string readable_box(const Box& box);

}  // namespace rmap::command
