#include "io/rmap_checksum.hpp"

#include "io/bytes.hpp"

#include <new>

#include <xxhash.h>

namespace rmap {

void RmapChecksum::Free::operator()(XXH3_state_s* state) const { XXH3_freeState(state); }

RmapChecksum::RmapChecksum() : state_(XXH3_createState()) {
  if (state_ == nullptr) throw std::bad_alloc();
  XXH3_64bits_reset(state_.get());
}

void RmapChecksum::update(std::span<const std::byte> bytes) {
  XXH3_64bits_update(state_.get(), bytes.data(), bytes.size());
}

std::uint64_t RmapChecksum::close() {
  const std::uint64_t checksum = XXH3_64bits_digest(state_.get());
  XXH3_64bits_reset(state_.get());
  update(little_endian(checksum));
  return checksum;
}

}  // namespace rmap
