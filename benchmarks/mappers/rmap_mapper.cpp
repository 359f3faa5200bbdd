#include "mappers/mapper.hpp"

#include <rmap/cast_ray.hpp>
#include <rmap/cells.hpp>
#include <rmap/map_file.hpp>

namespace rmap::bench {

namespace {

class RmapMapper : public Mapper, private MapAnswers {
 public:
  RmapMapper(const Options& options, History history) : grid_(options), history_(history) {}

  void take(std::span<const Scan> scans) override { scans_ = scans; }
  void prepare() override {
    if (history_ == History::first_hit) return;
    for (const Scan& scan : scans_) grid_.prepare(scan);
  }
  void insert() override {
    for (const Scan& scan : scans_) grid_.insert(scan);
  }

  std::size_t cell_count() const override { return grid_.cell_count(); }
  std::vector<Cell> occupied() const override {
    std::vector<Cell> occupied;
    for (const auto& [cell, value] : cells(grid_, {.occupied_only = true})) {
      occupied.push_back(cell);
    }
    return occupied;
  }
  const MapAnswers* answers() const override { return this; }

 private:
  std::size_t iterate() const override {
    std::size_t count = 0;
    for_each_cell(grid_, {.occupied_only = true}, [&](const Cell&, Value) {
      ++count;
      return true;
    });
    return count;
  }
  bool is_occupied(const Vector3d& point) const override {
    return grid_.state(point) == State::occupied;
  }
  std::optional<Cell> first_occupied(const Ray& ray) const override {
    const auto hit = cast_ray(grid_, ray.origin, ray.direction, ray.max_range);
    return hit ? std::optional(hit->cell) : std::nullopt;
  }
  void save(const std::filesystem::path& file) const override { rmap::save(grid_, file); }
  std::size_t load(const std::filesystem::path& file) const override {
    return count_cells(rmap::load(file), {.occupied_only = true});
  }
  std::string extension() const override { return ".rmap"; }

  Grid grid_;
  History history_;
  std::span<const Scan> scans_;
};

Contender contender(const std::string& name, const Options& options,
                    History history = History::first_hit) {
  const bool is_exact = options.beams == Beams::all && history == History::complete;
  return {.name = name,
          .make =
              [options, history](double resolution) {
                Options at = options;
                at.resolution = resolution;
                return std::make_unique<RmapMapper>(at, history);
              },
          .same_map = is_exact,
          .asked = is_exact && options.threads == 1 && options.traversal == Traversal::inverse};
}

}  // namespace

std::vector<Contender> rmap_contenders() {
  const auto inverse = Traversal::inverse;
  const auto forward = Traversal::forward;
  const auto complete = History::complete;
  return {
      contender("rmap", {.traversal = inverse}),
      contender("rmap complete", {.traversal = inverse}, complete),
      contender("rmap 2 threads", {.traversal = inverse, .threads = 2}),
      contender("rmap complete 2 threads", {.traversal = inverse, .threads = 2}, complete),
      contender("rmap forward", {.traversal = forward}),
      contender("rmap forward complete", {.traversal = forward}, complete),
      contender("rmap forward 2 threads", {.traversal = forward, .threads = 2}),
      contender("rmap forward complete 2 threads", {.traversal = forward, .threads = 2}, complete),
      contender("rmap cells", {.layout = Layout::cells, .traversal = inverse}),
      contender("rmap per_end_cell", {.beams = Beams::per_end_cell, .traversal = inverse}),
  };
}

}  // namespace rmap::bench
