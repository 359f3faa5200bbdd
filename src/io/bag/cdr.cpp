#include "io/bag/cdr.hpp"

#include "io/text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr std::size_t kHeaderSize = 4;

Error cut_error(std::string_view what, std::uint64_t place, std::uint64_t size, std::size_t left) {
  return {ErrorKind::input,
          fmt::format("{} at byte {} takes {} bytes, and {} are left", what, place, size, left)};
}

}  // namespace

CdrReader::CdrReader(std::span<const std::byte> message) {
  if (message.size() < kHeaderSize) throw cut_error("its header", 0, kHeaderSize, message.size());
  const auto first = std::to_integer<unsigned>(message[0]);
  const auto form = std::to_integer<unsigned>(message[1]);
  // Plain CDR in versions 1 and 2, each with two byte orders; the other forms are for types
  // that ROS does not make.
  const bool version_1 = form <= 1;
  const bool version_2 = form == 6 || form == 7;
  if (first != 0 || (!version_1 && !version_2)) {
    throw Error(ErrorKind::input,
                fmt::format("it begins with {:02x} {:02x}, where plain CDR begins with 00 and one "
                            "of 00, 01, 06, 07",
                            first, form));
  }
  big_endian_ = form % 2 == 0;
  if (version_2) most_alignment_ = 4;
  content_ = message.subspan(kHeaderSize);
}

std::span<const std::byte> CdrReader::aligned(std::size_t alignment, std::uint64_t size,
                                              std::string_view what) {
  alignment = std::min(alignment, most_alignment_);
  const std::size_t begin = (position_ + alignment - 1) / alignment * alignment;
  const std::size_t left = begin > content_.size() ? 0 : content_.size() - begin;
  if (begin > content_.size() || size > left) {
    throw cut_error(what, kHeaderSize + begin, size, left);
  }
  position_ = begin + static_cast<std::size_t>(size);
  return content_.subspan(begin, static_cast<std::size_t>(size));
}

std::string_view CdrReader::text(std::string_view what) {
  const auto size = number<std::uint32_t>(what);
  if (size == 0) return {};  // some writers leave the zero out of an empty text
  const std::string_view text = as_text(aligned(1, size, what));
  if (text.back() != '\0') {
    throw Error(ErrorKind::input,
                fmt::format("{} is {}, and must end with a zero", what, in_quotes(text)));
  }
  return text.substr(0, text.size() - 1);
}

std::uint32_t CdrReader::count(std::size_t least_size, std::string_view what) {
  const auto count = number<std::uint32_t>(what);
  if (count > remaining() / least_size) {
    throw Error(ErrorKind::input,
                fmt::format("{} at byte {} are {}, which take at least {} bytes, and {} are left",
                            what, kHeaderSize + position_ - sizeof count, count,
                            std::uint64_t{count} * least_size, remaining()));
  }
  return count;
}

std::span<const std::byte> CdrReader::bytes(std::string_view what) {
  const auto size = number<std::uint32_t>(what);
  return aligned(1, size, what);
}

}  // namespace rmap
