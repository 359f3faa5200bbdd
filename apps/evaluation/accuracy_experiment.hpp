#pragma once

#include "evaluation/json.hpp"
#include "evaluation/sequence.hpp"

#include <string>
#include <vector>

namespace rmap::evaluation {

/// How one map stands to the scans that were held out, at one threshold [RMAP 3.2]. Each end cell
/// and each path cell counts once for each scan held out.
struct AccuracyRow {
  std::string sequence = {};
  double resolution = 0;
  std::string map = {};  ///< empty: the map that holds nothing
  double threshold = 0;  ///< a cell is occupied when its probability is above
  std::size_t scans_held_out = 0;
  std::size_t scans_inserted = 0;
  /// Whether the sequence is long enough to judge a map by: 6 scans.
  bool judged = false;

  std::uint64_t ends = 0;
  std::uint64_t ends_right = 0;  ///< occupied
  std::uint64_t path = 0;
  std::uint64_t path_right = 0;    ///< not occupied, unknown ones too
  std::uint64_t path_unknown = 0;  ///< of these, those of which the map holds nothing

  double share_of_ends() const;
  double share_of_path() const;
  /// The paper's single number: of all cells, those right.
  double percentage() const;
  /// The mean of the two shares, percent: what a map that holds nothing gets 50 of.
  double balanced() const;
  /// The same two where a path cell of which the map holds nothing counts as wrong.
  double percentage_unknown_wrong() const;
  double balanced_unknown_wrong() const;
};

Json to_json(const AccuracyRow& row);

/// The names of the maps in the rows.
inline constexpr char kEmptyMap[] = "empty map";
inline constexpr char kFirstHit[] = "rmap, first-hit history";
inline constexpr char kComplete[] = "rmap, complete history";
inline constexpr char kOctomap[] = "OctoMap";

/// Maps of four fifths of the scans, asked what every fifth saw: the 5th, the 10th, and so on; of
/// fewer than 5 scans the last. Thresholds 0.9, the paper's, and 0.5. None of a single scan.
std::vector<AccuracyRow> accuracy_experiment(const Sequence& sequence, double resolution);

/// The row of a map; null when there is none.
const AccuracyRow* find_row(const std::vector<AccuracyRow>& rows, const std::string& sequence,
                            const std::string& map, double resolution, double threshold);

}  // namespace rmap::evaluation
