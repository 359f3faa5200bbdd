#include "io/bag/unpack.hpp"

#include "io/bytes.hpp"

#include <memory>
#include <new>

#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr std::uint64_t kFree = std::uint64_t{32} << 20;
constexpr std::uint64_t kMostRatio = 1000;      // of all pieces, which bounds time
constexpr std::uint64_t kMostPieceRatio = 100;  // of one, which bounds memory

struct FreeLz4 {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};

std::unique_ptr<LZ4F_dctx, FreeLz4> make_lz4() {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0) {
    throw std::bad_alloc();
  }
  return std::unique_ptr<LZ4F_dctx, FreeLz4>(context);
}

}  // namespace

void UnpackBudget::take(std::uint64_t packed, std::uint64_t unpacked) {
  if (unpacked > kMostUnpacked) {
    throw Error(ErrorKind::limit, fmt::format("it says that it unpacks to {} bytes, and {} are "
                                              "allowed",
                                              unpacked, kMostUnpacked));
  }
  if (unpacked > kFree && (unpacked - kFree) / kMostPieceRatio > packed) {
    throw Error(ErrorKind::limit,
                fmt::format("its {} bytes say that they unpack to {}: that is more than {} bytes "
                            "and {} times the packed size, which are allowed",
                            packed, unpacked, kFree, kMostPieceRatio));
  }
  packed_ += packed;
  unpacked_ += unpacked;
  if (unpacked_ > kFree && (unpacked_ - kFree) / kMostRatio > packed_) {
    throw Error(ErrorKind::limit,
                fmt::format("its {} bytes say that they unpack to {}, and with what came before "
                            "that is more than {} bytes and {} times the packed size, which are "
                            "allowed",
                            packed, unpacked, kFree, kMostRatio));
  }
}

bool unpack_zstd(std::span<const std::byte> packed, std::span<std::byte> content) {
  // One pass into a buffer of known size: no window is allocated, whatever the frame says.
  return ZSTD_decompress(content.data(), content.size(), packed.data(), packed.size()) ==
         content.size();
}

bool unpack_lz4(std::span<const std::byte> packed, std::span<std::byte> content) {
  const auto context = make_lz4();
  for (;;) {
    std::size_t taken = packed.size();
    std::size_t given = content.size();
    const std::size_t hint =
        LZ4F_decompress(context.get(), content.data(), &given, packed.data(), &taken, nullptr);
    if (LZ4F_isError(hint) != 0) return false;
    packed = packed.subspan(taken);
    content = content.subspan(given);
    if (hint == 0) return packed.empty() && content.empty();
    if (taken == 0 && given == 0) return false;
  }
}

bool is_packed_message(std::span<const std::byte> message) {
  return message.size() >= 4 && load_little<std::uint32_t>(message.data()) == ZSTD_MAGICNUMBER;
}

void unpack_message(std::span<const std::byte> message, UnpackBudget& budget,
                    std::vector<std::byte>& content) {
  const unsigned long long size = ZSTD_getFrameContentSize(message.data(), message.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN) {
    throw Error(ErrorKind::input, "it is compressed by zstd, and does not say its size");
  }
  budget.take(message.size(), size);
  content.resize(size);
  if (!unpack_zstd(message, content)) {
    throw Error(ErrorKind::input,
                fmt::format("it is compressed by zstd, and does not unpack to the {} bytes that "
                            "it announces",
                            size));
  }
}

}  // namespace rmap
