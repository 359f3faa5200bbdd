#include "evaluation/grid_experiment.hpp"

#include "evaluation/heap_in_use.hpp"
#include "evaluation/map_under_test.hpp"
#include "evaluation/stopwatch.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rmap::evaluation {

namespace {

constexpr std::uint64_t kBytesOfFloat = 4;
constexpr std::uint64_t kBytesOfPoint = 12;

struct Contender {
  std::string name;
  std::unique_ptr<MapUnderTest> map;
  const RmapMap* ours = nullptr;
  const OctomapMap* octomap = nullptr;
};

std::vector<Contender> contenders(double resolution) {
  std::vector<Contender> all;
  const auto add = [&](const std::string& name, Options options, History history) {
    options.resolution = resolution;
    auto map = std::make_unique<RmapMap>(options, history);
    const RmapMap* ours = map.get();
    all.push_back({name, std::move(map), ours, nullptr});
  };
  for (const int branches : {8, 16, 32}) {
    add(fmt::format("cells, M = {}", branches), {.layout = Layout::cells, .max_branches = branches},
        History::first_hit);
  }
  add(kBlocks, {}, History::first_hit);
  add(kBlocksComplete, {}, History::complete);
  if (auto octomap = make_octomap(resolution)) {
    const OctomapMap* theirs = octomap.get();
    all.push_back({kOctomapRun, std::move(octomap), nullptr, theirs});
  }
  return all;
}

// The box around the ends of beams and where they began.
class SeenBox {
 public:
  explicit SeenBox(const Lattice& lattice) : lattice_(lattice) {}

  void add(const Scan& scan) {
    if (scan.origins.empty()) add(Vector3d(scan.map_from_sensor.translation()));
    for (const Vector3d& origin : scan.origins) add(origin);
    for (const Vector3f& point : scan.points) add(Vector3d(point.cast<double>()));
  }
  double cells() const { return any_ ? box_.volume() : 0; }

 private:
  void add(const Vector3d& point) {
    const auto cell = lattice_.find_cell(point);
    if (!cell) return;
    box_ = any_ ? united(box_, box_of(*cell)) : box_of(*cell);
    any_ = true;
  }

  Lattice lattice_;
  CellBox box_;
  bool any_ = false;
};

void measure(const Contender& one, int repetitions, GridSample& sample) {
  std::vector<double> times;
  std::size_t occupied = 0;
  for (int i = 0; i < repetitions; ++i) {
    times.push_back(milliseconds_of([&] { occupied = one.map->extract(); }));
    // Long ones need no repetition to be told from noise.
    if (times.back() > 100) break;
  }
  sample.extract_ms = median(times);
  sample.occupied = occupied;
  if (one.ours != nullptr) sample.bytes = one.ours->grid().bytes_in_use().total();
}

HistoryRow histories(const std::vector<Contender>& all) {
  std::vector<Cell> octomap;
  bool has_octomap = false;
  std::vector<Cell> first_hit, complete;
  for (const Contender& one : all) {
    if (one.name == kBlocks) first_hit = one.map->occupied_cells();
    if (one.name == kBlocksComplete) complete = one.map->occupied_cells();
    if (one.octomap == nullptr) continue;
    octomap = one.map->occupied_cells();
    has_octomap = true;
  }
  return compare_histories(first_hit, complete, has_octomap ? &octomap : nullptr);
}

// The time of a scan, and what the map has taken by it.
template <class Work>
void charge(GridSample& sample, double& heap, Work&& work) {
  settle_heap();
  const std::int64_t before = heap_in_use();
  sample.insert_ms += milliseconds_of(work);
  heap += static_cast<double>(heap_in_use() - before);
  sample.heap_bytes = heap;
}

GridFindings::Reference reference(std::size_t scan, const SeenBox& box, std::uint64_t points,
                                  const std::vector<Contender>& all) {
  GridFindings::Reference result{
      .scan = scan,
      .full_grid = static_cast<std::uint64_t>(box.cells()) * kBytesOfFloat,
      .points = points * kBytesOfPoint};
  for (const Contender& one : all) {
    if (one.octomap == nullptr) continue;
    const OctomapMap::Forms forms = one.octomap->forms();
    result.uncompressed = forms.uncompressed.bytes();
    result.pruned = forms.pruned.bytes();
    result.maximum_likelihood = forms.maximum_likelihood.bytes();
  }
  return result;
}

}  // namespace

double GridRun::insert_ms() const {
  std::vector<double> times;
  for (const GridSample& sample : samples) times.push_back(sample.insert_ms);
  return median(times);
}

const GridRun* GridFindings::find(const std::string& map) const {
  const auto found =
      std::find_if(runs.begin(), runs.end(), [&](const GridRun& run) { return run.map == map; });
  return found == runs.end() ? nullptr : &*found;
}

GridFindings grid_experiment(const Sequence& sequence, const GridExperimentOptions& options) {
  const std::vector<Scan>& scans = sequence.scans;
  GridFindings findings{.sequence = sequence.name, .resolution = options.resolution};
  std::vector<Contender> all = contenders(options.resolution);
  std::vector<double> heap(all.size(), 0);
  for (const Contender& one : all) {
    findings.runs.push_back({one.name, one.octomap != nullptr, std::vector<GridSample>()});
    // Their own growth is not to be counted as the maps'.
    findings.runs.back().samples.resize(scans.size());
  }
  // The pass before the pass, each scan's share of it on its own sample.
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].ours == nullptr || all[i].ours->wanted_history() != History::complete) continue;
    for (std::size_t scan = 0; scan < scans.size(); ++scan) {
      charge(findings.runs[i].samples[scan], heap[i], [&] { all[i].map->prepare(scans[scan]); });
    }
  }
  SeenBox box{Lattice(options.resolution)};
  std::uint64_t points = 0;
  const std::size_t stride = std::max<std::size_t>(1, scans.size() / options.samples);
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    box.add(scans[scan]);
    points += scans[scan].points.size();
    const bool is_measured = scan + 1 == scans.size() || (scan + 1) % stride == 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      GridSample& sample = findings.runs[i].samples[scan];
      sample.scan = scan + 1;
      charge(sample, heap[i], [&] { all[i].map->insert(scans[scan]); });
      if (is_measured) measure(all[i], options.repetitions, sample);
    }
    if (!is_measured) continue;
    const GridFindings::Reference at = reference(scan + 1, box, points, all);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].octomap != nullptr) findings.runs[i].samples[scan].bytes = at.pruned;
    }
    findings.references.push_back(at);
  }
  findings.history = histories(all);
  findings.history.sequence = sequence.name;
  findings.history.resolution = options.resolution;
  findings.history.scans = scans.size();
  return findings;
}

std::vector<Json> to_rows(const GridFindings& findings) {
  std::vector<Json> rows;
  const auto optional = [](const auto& value) { return value ? Json(*value) : Json(nullptr); };
  for (const GridRun& run : findings.runs) {
    for (const GridSample& sample : run.samples) {
      rows.push_back({{"sequence", findings.sequence},
                      {"resolution_m", findings.resolution},
                      {"map", run.map},
                      {"scan", sample.scan},
                      {"insert_ms", sample.insert_ms},
                      {"heap_bytes", sample.heap_bytes},
                      {"extract_ms", optional(sample.extract_ms)},
                      {"occupied", optional(sample.occupied)},
                      {"bytes", optional(sample.bytes)}});
    }
  }
  return rows;
}

Json to_json(const GridFindings& findings) {
  const auto optional = [](const auto& value) { return value ? Json(*value) : Json(nullptr); };
  Json references = Json::array();
  for (const GridFindings::Reference& at : findings.references) {
    references.push_back({{"scan", at.scan},
                          {"full_grid_bytes", at.full_grid},
                          {"points_bytes", at.points},
                          {"octomap_uncompressed_bytes", optional(at.uncompressed)},
                          {"octomap_pruned_bytes", optional(at.pruned)},
                          {"octomap_maximum_likelihood_bytes", optional(at.maximum_likelihood)}});
  }
  return {{"sequence", findings.sequence},
          {"resolution_m", findings.resolution},
          {"samples", to_rows(findings)},
          {"references", references}};
}

}  // namespace rmap::evaluation
