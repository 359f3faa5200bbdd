#include "mappers/contest.hpp"

#include "clock.hpp"
#include "counted_heap.hpp"
#include "mappers/asking.hpp"
#include "support/plain_grid.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <rmap/grid.hpp>

namespace rmap::bench {

namespace {

// Cells of a map that must be the reference's may differ where beams touch borders of cells.
constexpr double kMostDifferent = 1e-3;

Agreement agreement_of(const std::vector<Cell>& cells, const std::vector<Cell>& reference) {
  std::vector<Cell> both;
  std::set_intersection(cells.begin(), cells.end(), reference.begin(), reference.end(),
                        std::back_inserter(both), test::MortonOrder());
  return {both.size(), cells.size() - both.size(), reference.size() - both.size()};
}

void require_same_map(const Case& of, const Figures& figures) {
  const Agreement& agreement = *figures.agreement;
  const auto different = static_cast<double>(agreement.here_only + agreement.reference_only);
  if (different <= kMostDifferent * static_cast<double>(agreement.both)) return;
  throw std::runtime_error(fmt::format(
      "{} at {} m: the map of {} has {} occupied cells that the reference has not, and lacks {}",
      of.sequence, of.resolution, figures.mapper, agreement.here_only, agreement.reference_only));
}

// Builds each map once with its memory counted, compares it, and asks those that are to be asked.
void check(Case& result, const Sequence& sequence, const std::vector<Contender>& contenders) {
  std::vector<std::unique_ptr<Mapper>> kept;
  std::vector<const MapAnswers*> asked;
  std::vector<std::size_t> places;
  std::vector<Cell> reference;
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    auto mapper = contenders[i].make(result.resolution);
    mapper->take(sequence.scans);
    Figures figures{.mapper = contenders[i].name};
    {
      const HeapCount heap;
      mapper->prepare();
      mapper->insert();
      figures.bytes = heap.in_use();
      figures.peak_bytes = heap.peak();
    }
    const std::vector<Cell> occupied = mapper->occupied();
    if (i == 0) reference = occupied;
    figures.cells = mapper->cell_count();
    figures.occupied = occupied.size();
    figures.agreement = agreement_of(occupied, reference);
    if (contenders[i].same_map) require_same_map(result, figures);
    result.figures.push_back(figures);
    if (contenders[i].asked && mapper->answers() != nullptr) {
      asked.push_back(mapper->answers());
      places.push_back(i);
      kept.push_back(std::move(mapper));
    }
  }
  const auto answers = ask(asked, reference, sequence, result.resolution);
  for (std::size_t i = 0; i < places.size(); ++i) result.figures[places[i]].answers = answers[i];
}

}  // namespace

std::vector<Contender> all_contenders() {
  std::vector<Contender> all = octomap_contenders();
  for (const auto& more : {rmap_contenders(), openvdb_contenders()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

Case run_case(const Sequence& sequence, double resolution, const std::vector<Contender>& contenders,
              const ContestOptions& options) {
  Case result{.sequence = sequence.name,
              .scans = sequence.scans.size(),
              .beams = sequence.beams(),
              .resolution = resolution};
  check(result, sequence, contenders);

  struct Times {
    std::vector<double> prepare, all;
    double spent = 0;
  };
  std::vector<Times> times(contenders.size());
  for (std::size_t round = 0; round < options.repetitions; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      if (round > 0 && options.patience > 0 && times[i].spent >= options.patience) continue;
      const auto mapper = contenders[i].make(resolution);
      mapper->take(sequence.scans);
      const double prepare = seconds_of([&] { mapper->prepare(); });
      const double insert = seconds_of([&] { mapper->insert(); });
      times[i].prepare.push_back(prepare);
      times[i].all.push_back(prepare + insert);
      times[i].spent += prepare + insert;
    }
  }
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    Figures& figures = result.figures[i];
    const double seconds = median(times[i].all);
    figures.repetitions = times[i].all.size();
    figures.ns_per_beam = seconds / static_cast<double>(result.beams) * 1e9;
    figures.prepare_share = median(times[i].prepare) / seconds;
    figures.ratio = result.figures.front().ns_per_beam / figures.ns_per_beam;
  }
  return result;
}

Growth measure_growth(const Sequence& drive, double resolution, std::size_t repetitions) {
  const std::span<const Scan> scans(drive.scans);
  const std::span<const Scan> last = scans.last(scans.size() / 10);
  std::size_t beams = 0;
  for (const Scan& scan : last) beams += scan.points.size();

  Growth growth{.sequence = drive.name};
  const auto cost = [&](std::span<const Scan> before, std::size_t& cells) {
    Grid grid({.resolution = resolution});
    for (const Scan& scan : before) grid.insert(scan);
    cells = grid.cell_count();
    const double seconds = seconds_of([&] {
      for (const Scan& scan : last) grid.insert(scan);
    });
    return seconds / static_cast<double>(beams) * 1e9;
  };
  std::vector<double> of_short;
  std::vector<double> of_long;
  for (std::size_t round = 0; round < repetitions; ++round) {
    of_short.push_back(cost(scans.last(2 * last.size()).first(last.size()), growth.short_cells));
    of_long.push_back(cost(scans.first(scans.size() - last.size()), growth.long_cells));
  }
  growth.short_ns = median(of_short);
  growth.long_ns = median(of_long);
  return growth;
}

}  // namespace rmap::bench
