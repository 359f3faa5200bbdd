#include "io/rmap_compression.hpp"

#include <algorithm>
#include <new>

#include <zstd.h>

namespace rmap {

namespace {

constexpr int kLevel = 3;

}  // namespace

void Compressor::Free::operator()(ZSTD_CCtx_s* context) const { ZSTD_freeCCtx(context); }

Compressor::Compressor() : context_(ZSTD_createCCtx()) {
  if (context_ == nullptr) throw std::bad_alloc();
}

std::optional<std::span<const std::byte>> Compressor::compress(std::span<const std::byte> content) {
  frame_.resize(ZSTD_compressBound(content.size()));
  const std::size_t size = ZSTD_compressCCtx(context_.get(), frame_.data(), frame_.size(),
                                             content.data(), content.size(), kLevel);
  if (ZSTD_isError(size) != 0) throw std::bad_alloc();  // with room enough nothing else fails
  if (size >= content.size()) return std::nullopt;
  return std::span<const std::byte>(frame_).first(size);
}

void Decompressor::Free::operator()(ZSTD_DCtx_s* context) const { ZSTD_freeDCtx(context); }

Decompressor::Decompressor() : context_(ZSTD_createDCtx()) {
  if (context_ == nullptr) throw std::bad_alloc();
}

bool Decompressor::decompress(std::span<const std::byte> stored, std::span<std::byte> content) {
  const std::size_t frame = ZSTD_findFrameCompressedSize(stored.data(), stored.size());
  if (ZSTD_isError(frame) != 0) return false;
  const auto padding = stored.subspan(frame);
  if (!std::all_of(padding.begin(), padding.end(), [](std::byte b) { return b == std::byte{0}; })) {
    return false;
  }
  // One pass into a buffer of known size: no window is allocated, whatever the frame says.
  return ZSTD_decompressDCtx(context_.get(), content.data(), content.size(), stored.data(),
                             frame) == content.size();
}

}  // namespace rmap
