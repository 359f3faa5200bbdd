#pragma once

#include "evaluation/accuracy_experiment.hpp"
#include "evaluation/cuboid_experiment.hpp"
#include "evaluation/grid_experiment.hpp"
#include "evaluation/multiresolution_experiment.hpp"
#include "evaluation/rtree_experiment.hpp"

#include <span>
#include <string>
#include <vector>

namespace rmap::evaluation {

/// One finding of the paper, or one of ours beside it, and whether the results show it.
struct Check {
  std::string experiment = {};
  std::string subject = {};  ///< of which sequence, resolution, tree
  std::string claim = {};    ///< a sentence
  std::string shown = {};    ///< the figures that decide
  bool holds = false;
  bool judged = true;  ///< false: reported only, as where a sequence is too short
};

Json to_json(const Check& check);

/// Larger M: fewer nodes and less memory; cells one by one: more overlap within a node; times are
/// told [RMAP 3.1].
std::vector<Check> check_rtree(std::span<const RTreeRow> rows);
/// Less memory than every form of OctoMap, less time to insert a scan and to go over the occupied
/// cells [RMAP 3.2].
std::vector<Check> check_grid(const GridFindings& findings);
/// 99 % of the cells right [RMAP 3.2] where `demands_paper`; and beside OctoMap by the balanced
/// accuracy: no worse with complete history, at most 0.5 points with first-hit.
std::vector<Check> check_accuracy(const std::vector<AccuracyRow>& rows, const std::string& sequence,
                                  double resolution, bool demands_paper);
/// First-hit history adds false cells and loses none; complete history has OctoMap's set.
std::vector<Check> check_history(const HistoryRow& row);
/// Fewer query cuboids than cells, coarser ones farther away [RMAP Fig. 2c].
std::vector<Check> check_multiresolution(const MultiresolutionFindings& findings);
/// Fewer cuboids and more points left out as sigma falls or omega rises; less memory than points
/// and than an OctoMap of the ends [RMAP 3.3].
std::vector<Check> check_cuboids(const CuboidFindings& findings, const std::string& scene);

}  // namespace rmap::evaluation
