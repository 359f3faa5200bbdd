#pragma once

#include "mappers/mapper.hpp"
#include "mappers/sequences.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rmap::bench {

/// How far the occupied cells of a map are those of the reference.
struct Agreement {
  std::size_t both = 0;
  std::size_t here_only = 0;
  std::size_t reference_only = 0;
};

/// Medians of what it takes to ask a map, and the share of answers equal to the reference's.
struct AnswerFigures {
  double iterate_ns = 0;  ///< an occupied cell
  double query_ns = 0;    ///< a point near surfaces
  double cast_ns = 0;     ///< a ray
  double save_s = 0;
  double load_s = 0;
  std::size_t file_bytes = 0;
  double equal_queries = 1;
  double equal_casts = 1;
};

/// What one mapper showed on one sequence at one resolution. Times are medians.
struct Figures {
  std::string mapper;
  std::size_t repetitions = 0;
  double ns_per_beam = 0;    ///< all passes
  double prepare_share = 0;  ///< of that, in the passes before insertion
  double ratio = 0;          ///< the reference's time over this one's
  std::size_t cells = 0;     ///< that exist
  std::size_t occupied = 0;
  std::size_t bytes = 0;       ///< held by the finished map, counted at operator new
  std::size_t peak_bytes = 0;  ///< held at most while it was made
  std::optional<Agreement> agreement = {};
  std::optional<AnswerFigures> answers = {};
};

struct Case {
  std::string sequence;
  std::size_t scans = 0;
  std::size_t beams = 0;
  double resolution = 0;
  std::vector<Figures> figures = {};
};

struct ContestOptions {
  std::size_t repetitions = 5;
  /// Seconds after which a mapper is not repeated in a case; it is timed once at least.
  double patience = 0;  ///< 0: endless
};

/// Builds the map of a sequence with each contender; the first is the reference. First once with
/// every allocation counted and the answers checked, then so many times, interleaved, for the
/// clock. Throws std::runtime_error when a map or an answer is not the reference's that must be.
Case run_case(const Sequence& sequence, double resolution, const std::vector<Contender>& contenders,
              const ContestOptions& options);

/// Cost of one more scan at the end of a drive, in a map of its last fifth and in the map
/// of it all. Nanoseconds a beam, medians.
struct Growth {
  std::string sequence;
  std::size_t short_cells = 0;
  std::size_t long_cells = 0;
  double short_ns = 0;
  double long_ns = 0;
};
Growth measure_growth(const Sequence& drive, double resolution, std::size_t repetitions);

}  // namespace rmap::bench
