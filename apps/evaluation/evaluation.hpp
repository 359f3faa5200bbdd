#pragma once

#include "evaluation/checks.hpp"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace rmap::evaluation {

/// The experiments by name, in the order of the paper.
const std::vector<std::string>& experiment_names();

struct EvaluationOptions {
  std::set<std::string> experiments;  ///< empty: all
  /// Metres; accuracy is taken at the coarsest.
  std::vector<double> resolutions = {0.1, 0.2};
  int repetitions = 3;     ///< of what is short enough to be repeated
  bool is_campus = false;  ///< the sequence is the simulated campus, on which 99 % is demanded
};

struct Evaluation {
  std::vector<Json> sequences;
  std::vector<RTreeRow> rtree;
  std::vector<GridFindings> grid;
  std::vector<AccuracyRow> accuracy;
  std::vector<MultiresolutionFindings> multiresolution;
  CuboidFindings cuboids;
  std::vector<Check> checks;
};

/// All experiments on some sequences, at least one, and clouds. R-tree, query cuboids and the
/// cuboids of a sequence are those of the sequence with most beams. `step` is called with what is
/// done next.
Evaluation evaluate(const std::vector<Sequence>& sequences, const std::vector<CloudScene>& clouds,
                    const EvaluationOptions& options,
                    const std::function<void(const std::string&)>& step);

/// All results as one document, without machine and command.
Json to_json(const Evaluation& evaluation);

/// The same as tables: name of the file and its text.
std::vector<std::pair<std::string, std::string>> tables_of(const Evaluation& evaluation);

}  // namespace rmap::evaluation
