#pragma once

#include <string>
#include <string_view>

/// Files with checksums let nothing through that was changed at random: what is behind the
/// checksums is reached when they are made to fit again. After docs/formats/, on its own.
namespace rmap::fuzz {

/// The bytes of a `.rmap` file with the checksums that fit, as far as its chunks can be followed.
std::string with_map_checksums(std::string_view bytes);

/// The same file with the counts of its header and of END as its chunks announce them; it stays as
/// it is when a chunk of cells is compressed, or when the reserved field of the header is not 0.
std::string with_map_counts(std::string_view bytes);

/// The bytes of a `.rcs` file with the checksum that fits.
std::string with_rcs_checksum(std::string_view bytes);

}  // namespace rmap::fuzz
