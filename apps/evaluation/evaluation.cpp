#include "evaluation/evaluation.hpp"

#include "evaluation/tables.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rmap::evaluation {

namespace {

const Sequence& largest(const std::vector<Sequence>& sequences) {
  return *std::max_element(
      sequences.begin(), sequences.end(),
      [](const Sequence& a, const Sequence& b) { return a.beams() < b.beams(); });
}

template <class Rows>
std::vector<Json> rows_of(const Rows& rows) {
  std::vector<Json> json;
  for (const auto& row : rows) json.push_back(to_json(row));
  return json;
}

std::vector<HistoryRow> histories(const Evaluation& evaluation) {
  std::vector<HistoryRow> rows;
  for (const GridFindings& findings : evaluation.grid) rows.push_back(findings.history);
  return rows;
}

class Evaluator {
 public:
  Evaluator(const EvaluationOptions& options, const std::function<void(const std::string&)>& step)
      : options_(options), step_(step) {}

  Evaluation run(const std::vector<Sequence>& sequences, const std::vector<CloudScene>& clouds) {
    for (const Sequence& sequence : sequences) {
      result_.sequences.push_back(to_json(sequence));
    }
    const Sequence& main = largest(sequences);
    const double fine = *std::min_element(options_.resolutions.begin(), options_.resolutions.end());
    if (wanted("rtree")) {
      step_(fmt::format("R-trees of {}", main.name));
      result_.rtree =
          rtree_experiment(main, {.resolution = fine, .repetitions = options_.repetitions});
      add(check_rtree(result_.rtree));
    }
    for (const Sequence& sequence : sequences) grids(sequence);
    for (const Sequence& sequence : sequences) accuracy(sequence);
    if (wanted("multiresolution")) {
      step_(fmt::format("query cuboids of {}", main.name));
      result_.multiresolution.push_back(multiresolution_experiment(main, fine));
      add(check_multiresolution(result_.multiresolution.back()));
    }
    if (wanted("cuboids")) {
      for (const CloudScene& cloud : clouds) cuboids(cloud);
      cuboids({main.name, main.source, fine, all_points(main)});
    }
    return std::move(result_);
  }

 private:
  bool wanted(const std::string& experiment) const {
    return options_.experiments.empty() || options_.experiments.contains(experiment);
  }
  void add(const std::vector<Check>& checks) {
    result_.checks.insert(result_.checks.end(), checks.begin(), checks.end());
  }

  // History is read off the maps that the grids make.
  void grids(const Sequence& sequence) {
    if (!wanted("grid") && !wanted("history")) return;
    for (const double resolution : options_.resolutions) {
      step_(fmt::format("maps of {} at {} m", sequence.name, resolution));
      result_.grid.push_back(grid_experiment(sequence, {.resolution = resolution}));
      if (wanted("grid")) add(check_grid(result_.grid.back()));
      if (wanted("history")) add(check_history(result_.grid.back().history));
    }
  }

  void accuracy(const Sequence& sequence) {
    if (!wanted("accuracy")) return;
    const double resolution =
        *std::max_element(options_.resolutions.begin(), options_.resolutions.end());
    step_(fmt::format("accuracy of {} at {} m", sequence.name, resolution));
    const std::vector<AccuracyRow> rows = accuracy_experiment(sequence, resolution);
    result_.accuracy.insert(result_.accuracy.end(), rows.begin(), rows.end());
    if (!rows.empty()) {
      // Of finer cells than the paper's more are right.
      constexpr double kResolutionOfThePaper = 0.2;
      const bool demands_paper = options_.is_campus && resolution <= kResolutionOfThePaper;
      add(check_accuracy(rows, sequence.name, resolution, demands_paper));
    }
  }

  void cuboids(const CloudScene& cloud) {
    step_(fmt::format("cuboids of {} at {} m", cloud.name, cloud.resolution));
    cuboid_experiment(cloud, options_.repetitions, result_.cuboids);
    add(check_cuboids(result_.cuboids, cloud.name));
  }

  const EvaluationOptions& options_;
  const std::function<void(const std::string&)>& step_;
  Evaluation result_;
};

}  // namespace

const std::vector<std::string>& experiment_names() {
  static const std::vector<std::string> kNames = {
      "rtree", "grid", "accuracy", "history", "multiresolution", "cuboids"};
  return kNames;
}

Evaluation evaluate(const std::vector<Sequence>& sequences, const std::vector<CloudScene>& clouds,
                    const EvaluationOptions& options,
                    const std::function<void(const std::string&)>& step) {
  return Evaluator(options, step).run(sequences, clouds);
}

Json to_json(const Evaluation& evaluation) {
  return {{"sequences", evaluation.sequences},
          {"rtree", rows_of(evaluation.rtree)},
          {"grid", rows_of(evaluation.grid)},
          {"accuracy", rows_of(evaluation.accuracy)},
          {"history", rows_of(histories(evaluation))},
          {"multiresolution", rows_of(evaluation.multiresolution)},
          {"cuboids",
           {{"clouds", rows_of(evaluation.cuboids.clouds)},
            {"rows", rows_of(evaluation.cuboids.rows)}}},
          {"checks", rows_of(evaluation.checks)}};
}

std::vector<std::pair<std::string, std::string>> tables_of(const Evaluation& evaluation) {
  std::vector<Json> grid, references, boxes;
  for (const GridFindings& findings : evaluation.grid) {
    for (const Json& row : to_rows(findings)) grid.push_back(row);
    const Json document = to_json(findings);
    for (const Json& reference : document["references"]) {
      Json row{{"sequence", findings.sequence}, {"resolution_m", findings.resolution}};
      row.update(reference);
      references.push_back(row);
    }
  }
  for (const MultiresolutionFindings& findings : evaluation.multiresolution) {
    for (const Json& row : to_rows(findings)) boxes.push_back(row);
  }
  std::vector<std::pair<std::string, std::string>> tables;
  const auto add = [&](const char* name, const std::vector<Json>& rows) {
    if (!rows.empty()) tables.emplace_back(name, csv_of(rows));
  };
  add("sequences.csv", evaluation.sequences);
  add("rtree.csv", rows_of(evaluation.rtree));
  add("grid.csv", grid);
  add("grid_references.csv", references);
  add("accuracy.csv", rows_of(evaluation.accuracy));
  add("history.csv", rows_of(histories(evaluation)));
  add("query_cuboids.csv", boxes);
  add("clouds.csv", rows_of(evaluation.cuboids.clouds));
  add("cuboids.csv", rows_of(evaluation.cuboids.rows));
  add("checks.csv", rows_of(evaluation.checks));
  return tables;
}

}  // namespace rmap::evaluation
