#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <rmap/scan.hpp>

namespace rmap::bench {

/// Scans in the map's frame, with float32 points and origins.
struct Sequence {
  std::string name;
  std::vector<Scan> scans;

  std::size_t beams() const;
};

/// How much of each sequence is wanted.
struct Share {
  std::size_t scans = 0;   ///< the first so many; 0: all
  std::size_t stride = 1;  ///< every so-manieth point
};

/// The sequences in the folder `data`/sequences, and a simulated street. `names`: those alone;
/// empty: all. Throws Error(input) for a name that is none of them.
std::vector<Sequence> read_sequences(const std::filesystem::path& data,
                                     const std::vector<std::string>& names, const Share& share);

/// A drive through a simulated city, `metres` long, with a scan every 5 m.
Sequence simulate_drive(double metres);

}  // namespace rmap::bench
