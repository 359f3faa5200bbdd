#include "io/rmap_content.hpp"

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap::wire {

std::span<const std::byte> ContentDecoder::decode(const ChunkHeader& header,
                                                  std::span<const std::byte> stored) {
  const auto refuse = [](const std::string& predicate) {
    throw Error(ErrorKind::input, predicate);
  };
  if ((header.flags & ~(kRequired | kCompressed)) != 0) {
    refuse(fmt::format("has flags {:#x}: version {} knows {:#x}", header.flags, kFormatVersion,
                       kRequired | kCompressed));
  }
  if (!header.compressed()) {
    if (header.raw_size != header.stored_size) {
      refuse(fmt::format("is not compressed and takes {} bytes, but announces {}",
                         header.stored_size, header.raw_size));
    }
    return stored;
  }
  if (header.raw_size > kMaxContentSize) {
    refuse(fmt::format("announces {} bytes once decompressed: at most {} are allowed",
                       header.raw_size, kMaxContentSize));
  }
  content_.resize(static_cast<std::size_t>(header.raw_size));
  if (!decompressor_.decompress(stored, content_)) {
    refuse(
        fmt::format("does not decompress: it must be one zstd frame of {} bytes, followed by "
                    "zeros",
                    header.raw_size));
  }
  return content_;
}

}  // namespace rmap::wire
