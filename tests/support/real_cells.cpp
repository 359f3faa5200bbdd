#include "support/real_cells.hpp"

#include "support/random.hpp"
#include "support/real_data.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include <rmap/octomap_file.hpp>
#include <rmap/scan_source.hpp>

namespace rmap::test {

namespace {

namespace fs = std::filesystem;

CellScene octomap_scene(const std::string& name, const fs::path& file) {
  CellScene scene{.name = name};
  if (!fs::exists(file)) return scene;
  const OctomapCells map = read_octomap(file);
  scene.resolution = map.resolution;
  for (const Cell& cell : map.occupied) scene.cells.push_back({cell, 1});
  scene.cells = sorted_cells(std::move(scene.cells));
  return scene;
}

CellScene merged_scans(const std::string& name, const std::string& sequence) {
  constexpr double kResolution = 0.1;
  CellScene scene{.name = name, .resolution = kResolution};
  const fs::path folder = sequence_folder(sequence);
  if (folder.empty()) return scene;
  for (const Scan& scan : read_scans(folder)) {
    const auto quantized = quantize(scan.points, Lattice(kResolution), scan.map_from_sensor);
    scene.cells.insert(scene.cells.end(), quantized.cells.begin(), quantized.cells.end());
  }
  scene.cells = sorted_cells(std::move(scene.cells));
  return scene;
}

/// A triangle mesh in a PLY file of text.
struct Mesh {
  std::vector<Vector3d> vertices;
  std::vector<std::array<std::size_t, 3>> triangles;
};

Mesh read_mesh(const fs::path& file) {
  std::ifstream in(file);
  std::size_t vertices = 0;
  std::size_t faces = 0;
  for (std::string line; std::getline(in, line) && line.rfind("end_header", 0) != 0;) {
    std::istringstream words(line);
    std::string element, kind;
    std::size_t count = 0;
    if (words >> element >> kind >> count && element == "element") {
      (kind == "vertex" ? vertices : faces) = count;
    }
  }
  Mesh mesh;
  std::string line;
  for (std::size_t i = 0; i < vertices && std::getline(in, line); ++i) {
    std::istringstream numbers(line);
    Vector3d vertex;
    numbers >> vertex.x() >> vertex.y() >> vertex.z();
    mesh.vertices.push_back(vertex);
  }
  for (std::size_t i = 0; i < faces && std::getline(in, line); ++i) {
    std::istringstream numbers(line);
    int corners = 0;
    std::array<std::size_t, 3> triangle{};
    numbers >> corners >> triangle[0] >> triangle[1] >> triangle[2];
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

/// Points on the mesh, as many on a triangle as its area asks for.
std::vector<Vector3f> sampled(const Mesh& mesh, int count, std::uint64_t seed) {
  std::vector<double> areas;
  double area = 0;
  for (const auto& triangle : mesh.triangles) {
    const Vector3d& corner = mesh.vertices[triangle[0]];
    area += (mesh.vertices[triangle[1]] - corner).cross(mesh.vertices[triangle[2]] - corner).norm();
    areas.push_back(area);
  }
  Random random(seed);
  std::vector<Vector3f> points;
  for (int i = 0; i < count; ++i) {
    const auto at = std::upper_bound(areas.begin(), areas.end() - 1, random.real(0, area));
    const auto& triangle = mesh.triangles[static_cast<std::size_t>(at - areas.begin())];
    double u = random.real(0, 1);
    double v = random.real(0, 1);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Vector3d& corner = mesh.vertices[triangle[0]];
    const Vector3d point = corner + u * (mesh.vertices[triangle[1]] - corner) +
                           v * (mesh.vertices[triangle[2]] - corner);
    points.push_back(point.cast<float>());
  }
  return points;
}

CellScene bunny(const fs::path& file) {
  CellScene scene{.name = "bunny"};
  if (!fs::exists(file)) return scene;
  const Mesh mesh = read_mesh(file);
  Vector3d low = mesh.vertices.front();
  Vector3d high = low;
  for (const Vector3d& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  scene.resolution = (high - low).maxCoeff() / 200;
  scene.cells = quantize(sampled(mesh, 1000000, 1), Lattice(scene.resolution)).cells;
  return scene;
}

/// Samples rectangles.
class Sampler {
 public:
  Sampler(double density, double noise, std::uint64_t seed)
      : density_(density), noise_(noise), random_(seed) {}

  void rectangle(const Vector3d& corner, const Vector3d& a, const Vector3d& b) {
    const Vector3d across = a.cross(b);
    const int count = static_cast<int>(across.norm() * density_);
    for (int i = 0; i < count; ++i) {
      const Vector3d point = corner + random_.real(0, 1) * a + random_.real(0, 1) * b +
                             random_.gaussian(noise_) * across.normalized();
      points_.push_back(point.cast<float>());
    }
  }
  void box(const Vector3d& low, const Vector3d& high) {
    const Vector3d edges = high - low;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d a = edges[(axis + 1) % 3] * Vector3d::Unit((axis + 1) % 3);
      const Vector3d b = edges[(axis + 2) % 3] * Vector3d::Unit((axis + 2) % 3);
      rectangle(low, a, b);
      rectangle(low + edges[axis] * Vector3d::Unit(axis), a, b);
    }
  }
  std::vector<Vector3f> points() && { return std::move(points_); }

 private:
  double density_;
  double noise_;
  Random random_;
  std::vector<Vector3f> points_;
};

constexpr double kHalfCell = 0.025;  // of cells of 5 cm

}  // namespace

const std::vector<std::string>& cell_scene_names() {
  static const std::vector<std::string> kNames{"office", "street", "hall",
                                               "bunny",  "fr_079", "fr_campus"};
  return kNames;
}

CellScene real_cell_scene(const std::string& name) {
  const fs::path data = data_folder();
  if (name == "street") return merged_scans(name, "street_kitti");
  if (name == "hall") return merged_scans(name, "hall_lidar");
  if (data.empty()) return {.name = name};
  if (name == "office") return octomap_scene(name, data / "maps/geb079.bt");
  if (name == "bunny") return bunny(data / "clouds/bunny.ply");
  return octomap_scene(name, data / "maps" / (name + ".bt"));
}

std::vector<Vector3f> room_points(double density, double noise, std::uint64_t seed) {
  Sampler sampler(density, noise, seed);
  const Vector3d corner = Vector3d::Constant(kHalfCell);
  sampler.box(corner, corner + Vector3d(6, 5, 2.7));
  Random random(seed + 1);
  for (int i = 0; i < 11; ++i) {
    const auto tenth = [&](int low, int high) { return 0.1 * random.integer(low, high); };
    const Vector3d low = corner + Vector3d(tenth(3, 45), tenth(3, 35), 0);
    sampler.box(low, low + Vector3d(tenth(4, 12), tenth(2, 8), tenth(4, 13)));
  }
  return std::move(sampler).points();
}

std::vector<Vector3f> wall_points(int walls, double density, double noise, std::uint64_t seed) {
  Sampler sampler(density, noise, seed);
  const Vector3d corner = Vector3d::Constant(kHalfCell);
  const Vector3d x(6, 0, 0), y(0, 5, 0), z(0, 0, 2.7);
  if (walls > 0) sampler.rectangle(corner, x, y);
  if (walls > 1) sampler.rectangle(corner, x, z);
  if (walls > 2) sampler.rectangle(corner, y, z);
  return std::move(sampler).points();
}

}  // namespace rmap::test
