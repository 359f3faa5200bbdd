#pragma once

#include "evaluation/history_experiment.hpp"
#include "evaluation/json.hpp"
#include "evaluation/sequence.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rmap::evaluation {

/// One map after one scan of a sequence [RMAP Fig. 8].
struct GridSample {
  std::size_t scan = 0;   ///< from 1
  double insert_ms = 0;   ///< of this scan; with complete history its preparation too
  double heap_bytes = 0;  ///< what the map has taken from the heap, counted
  /// Not measured after every scan.
  std::optional<double> extract_ms = {};  ///< going over all occupied cells, a median
  std::optional<std::uint64_t> occupied = {};
  /// rmap: the bytes that it says it uses. OctoMap: by the paper's formula, as it is pruned.
  std::optional<std::uint64_t> bytes = {};
};

/// A way to keep the map, over a sequence.
struct GridRun {
  std::string map = {};
  bool is_octomap = false;
  std::vector<GridSample> samples = {};  ///< one for each scan

  const GridSample& last() const { return samples.back(); }
  double insert_ms() const;  ///< median of a scan
};

/// The maps of one sequence at one resolution.
struct GridFindings {
  std::string sequence = {};
  double resolution = 0;
  std::vector<GridRun> runs = {};

  /// What there is to compare with after the same scans, bytes by formula.
  struct Reference {
    std::size_t scan = 0;
    std::uint64_t full_grid = 0;  ///< of the box around all ends and origins, a float a cell
    std::uint64_t points = 0;     ///< 12 bytes each
    /// OctoMap [RMAP 3.2]: 80 bytes an inner node, 16 a leaf.
    std::optional<std::uint64_t> uncompressed = {};
    std::optional<std::uint64_t> pruned = {};
    std::optional<std::uint64_t> maximum_likelihood = {};
  };
  std::vector<Reference> references = {};
  HistoryRow history = {};

  const GridRun* find(const std::string& map) const;
};

inline constexpr char kBlocks[] = "blocks";
inline constexpr char kBlocksComplete[] = "blocks, complete history";
inline constexpr char kOctomapRun[] = "OctoMap";

/// Rows for a table: one for each map and scan.
std::vector<Json> to_rows(const GridFindings& findings);
Json to_json(const GridFindings& findings);

struct GridExperimentOptions {
  double resolution = 0.1;
  std::size_t samples = 24;  ///< after about so many scans extraction and memory are measured
  int repetitions = 5;       ///< of an extraction
};

/// Inserts each scan into every map in turn, so that all are timed under the same conditions.
GridFindings grid_experiment(const Sequence& sequence, const GridExperimentOptions& options);

}  // namespace rmap::evaluation
