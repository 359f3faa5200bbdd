#include "mappers/asking.hpp"

#include "clock.hpp"
#include "support/random.hpp"

#include <filesystem>
#include <stdexcept>
#include <unistd.h>

#include <fmt/format.h>

namespace rmap::bench {

namespace {

constexpr std::size_t kRounds = 5;
constexpr std::size_t kPoints = 100'000;
constexpr std::size_t kRays = 5'000;
constexpr double kNear = 0.5;    // metres from a surface, each axis
constexpr double kSpread = 0.1;  // metres beside a measured point
constexpr double kRange = 60;
constexpr double kLeastEqual = 0.999;

std::vector<Vector3d> points_near(const std::vector<Cell>& occupied, double resolution) {
  test::Random random(2);
  std::vector<Vector3d> points;
  const auto last = static_cast<std::int32_t>(occupied.size()) - 1;
  for (std::size_t i = 0; i < kPoints && last >= 0; ++i) {
    const Cell& cell = occupied[static_cast<std::size_t>(random.integer(0, last))];
    const Vector3d point =
        (cell.cast<double>() + Vector3d::Constant(0.5)) * resolution + random.point(-kNear, kNear);
    points.emplace_back(point.cast<float>().cast<double>());
  }
  return points;
}

std::vector<Ray> rays_into(const Sequence& sequence) {
  test::Random random(3);
  std::vector<Ray> rays;
  while (rays.size() < kRays) {
    const auto last = static_cast<std::int32_t>(sequence.scans.size()) - 1;
    const Scan& scan = sequence.scans[static_cast<std::size_t>(random.integer(0, last))];
    const auto end = static_cast<std::int32_t>(scan.points.size()) - 1;
    const Vector3f& point = scan.points[static_cast<std::size_t>(random.integer(0, end))];
    const Vector3d origin = scan.map_from_sensor.translation();
    const Vector3d direction = point.cast<double>() + random.point(-kSpread, kSpread) - origin;
    rays.push_back({origin, direction.normalized(), kRange});
  }
  return rays;
}

// What a map said to each question.
struct Said {
  std::vector<bool> occupied;
  std::vector<std::optional<Cell>> hits;
};

template <class Values>
double equal_share(const Values& a, const Values& b) {
  std::size_t equal = 0;
  for (std::size_t i = 0; i < a.size(); ++i) equal += a[i] == b[i] ? 1 : 0;
  return a.empty() ? 1 : static_cast<double>(equal) / static_cast<double>(a.size());
}

struct Laps {
  std::vector<double> iterate, query, cast, save, load;
};

std::filesystem::path scratch_file(const MapAnswers& map) {
  return std::filesystem::temp_directory_path() /
         fmt::format("rmap_bench_{}{}", ::getpid(), map.extension());
}

void require_all(std::size_t counted, std::size_t expected, const char* what) {
  if (counted != expected) {
    throw std::runtime_error(fmt::format("{} {} occupied cells of {}", what, counted, expected));
  }
}

// One round of all questions to one map.
Said ask_once(const MapAnswers& map, const std::vector<Vector3d>& points,
              const std::vector<Ray>& rays, Laps& laps, AnswerFigures& figures) {
  std::size_t iterated = 0;
  laps.iterate.push_back(seconds_of([&] { iterated = map.iterate(); }));
  Said said;
  said.occupied.reserve(points.size());
  laps.query.push_back(seconds_of([&] {
    for (const Vector3d& point : points) said.occupied.push_back(map.is_occupied(point));
  }));
  said.hits.reserve(rays.size());
  laps.cast.push_back(seconds_of([&] {
    for (const Ray& ray : rays) said.hits.push_back(map.first_occupied(ray));
  }));
  const std::filesystem::path file = scratch_file(map);
  ::sync();  // else who waits for the disk waits for what others wrote before
  laps.save.push_back(seconds_of([&] { map.save(file); }));
  figures.file_bytes = std::filesystem::file_size(file);
  std::size_t loaded = 0;
  laps.load.push_back(seconds_of([&] { loaded = map.load(file); }));
  std::filesystem::remove(file);
  require_all(loaded, iterated, "a loaded map has");
  return said;
}

}  // namespace

std::vector<AnswerFigures> ask(const std::vector<const MapAnswers*>& maps,
                               const std::vector<Cell>& occupied, const Sequence& sequence,
                               double resolution) {
  const std::vector<Vector3d> points = points_near(occupied, resolution);
  const std::vector<Ray> rays = rays_into(sequence);
  std::vector<AnswerFigures> figures(maps.size());
  std::vector<Laps> laps(maps.size());
  Said expected;
  for (std::size_t round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < maps.size(); ++i) {
      const Said said = ask_once(*maps[i], points, rays, laps[i], figures[i]);
      if (round > 0) continue;
      if (i == 0) expected = said;
      figures[i].equal_queries = equal_share(said.occupied, expected.occupied);
      figures[i].equal_casts = equal_share(said.hits, expected.hits);
      if (std::min(figures[i].equal_queries, figures[i].equal_casts) < kLeastEqual) {
        throw std::runtime_error(
            fmt::format("{}: the answers to {:.4f} of the points and {:.4f} of the rays only are "
                        "those of the reference",
                        sequence.name, figures[i].equal_queries, figures[i].equal_casts));
      }
    }
  }
  const auto each = [](const std::vector<double>& seconds, std::size_t number) {
    return median(seconds) / static_cast<double>(std::max<std::size_t>(number, 1)) * 1e9;
  };
  for (std::size_t i = 0; i < maps.size(); ++i) {
    figures[i].iterate_ns = each(laps[i].iterate, occupied.size());
    figures[i].query_ns = each(laps[i].query, points.size());
    figures[i].cast_ns = each(laps[i].cast, rays.size());
    figures[i].save_s = median(laps[i].save);
    figures[i].load_s = median(laps[i].load);
  }
  return figures;
}

}  // namespace rmap::bench
