#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace rmap {

/// Compresses the contents of chunks with zstd, one frame each: equal contents are
/// equal bytes, with one release of zstd.
class Compressor {
 public:
  Compressor();

  /// The frame, or nothing when it would not be smaller. Valid until the next call.
  std::optional<std::span<const std::byte>> compress(std::span<const std::byte> content);

 private:
  struct Free {
    void operator()(ZSTD_CCtx_s* context) const;
  };

  std::unique_ptr<ZSTD_CCtx_s, Free> context_;
  std::vector<std::byte> frame_;
};

/// Decompresses frames that may come from anybody.
class Decompressor {
 public:
  Decompressor();

  /// Fills `content` from `stored`: one frame, then nothing but zeros. False when
  /// `stored` is not that, or holds more or less than `content` has room for.
  bool decompress(std::span<const std::byte> stored, std::span<std::byte> content);

 private:
  struct Free {
    void operator()(ZSTD_DCtx_s* context) const;
  };

  std::unique_ptr<ZSTD_DCtx_s, Free> context_;
};

}  // namespace rmap
