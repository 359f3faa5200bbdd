#pragma once

#include "json.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <rmap/grid.hpp>
#include <rmap/scan_filter.hpp>
#include <rmap/scan_source.hpp>

namespace rmap::command {

/// What a build did, over all its scans.
struct BuildReport {
  std::uint64_t scans = 0;
  std::uint64_t points = 0;  ///< read from the files
  InsertReport inserted = {};
  std::uint64_t prepared_cells = 0;  ///< made before the first insertion
  ScanFilter::Counts left_out = {};
  ScanNotes notes = {};

  double seconds_read = 0;
  double seconds_prepare = 0;
  double seconds_insert = 0;
  double seconds_save = 0;
};

/// What of the map is worth telling after it was built.
struct BuiltMap {
  std::filesystem::path output;
  std::size_t cells;
  std::size_t occupied;
  History history;
  BytesInUse bytes_in_use;
};

/// {"not_finite": ..., "ignored": ...}: all reasons for which a point had no effect.
Json json_of(const SkippedPoints& skipped, const ScanFilter::Counts& left_out);
/// The same in words: "3 not finite, 12 ignored", or "none".
std::string words_of(const SkippedPoints& skipped, const ScanFilter::Counts& left_out);

Json json_of(const BuildReport& report, const BuiltMap& map);
std::string words_of(const BuildReport& report, const BuiltMap& map);

/// What `build --dry-run` found.
struct CheckReport {
  std::uint64_t scans = 0;
  std::uint64_t points = 0;
  SkippedPoints skipped = {};
  ScanFilter::Counts left_out = {};
  ScanNotes notes = {};
  std::vector<std::string> problems = {};  ///< one sentence each
};

Json json_of(const CheckReport& report);
std::string words_of(const CheckReport& report);

}  // namespace rmap::command
