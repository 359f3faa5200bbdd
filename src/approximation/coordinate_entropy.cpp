#include "approximation/coordinate_entropy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace rmap {

namespace {

/// A histogram whose range is that of the coordinates, or a hash where that is far too wide.
double entropy_of(std::span<const double> coordinates) {
  const auto [low, high] = std::minmax_element(coordinates.begin(), coordinates.end());
  const double first = std::floor(*low);
  const double bins = std::floor(*high) - first + 2;
  const auto total = static_cast<double>(coordinates.size());
  const auto part = [&](double count) {
    return count > 0 ? -count / total * std::log(count / total) : 0;
  };
  const auto fill = [&](auto& histogram) {
    for (const double coordinate : coordinates) {
      const double at = coordinate - first;
      const auto below = static_cast<std::size_t>(at);
      const double share = at - static_cast<double>(below);
      histogram[below] += 1 - share;
      histogram[below + 1] += share;
    }
  };
  double entropy = 0;
  if (bins < 1 << 20) {
    std::vector<double> histogram(static_cast<std::size_t>(bins));
    fill(histogram);
    for (const double count : histogram) entropy += part(count);
    return entropy;
  }
  // Summed in the order of the bins, so that the result is the same everywhere.
  std::unordered_map<std::size_t, double> sparse;
  fill(sparse);
  std::vector<std::pair<std::size_t, double>> sorted(sparse.begin(), sparse.end());
  std::sort(sorted.begin(), sorted.end());
  for (const auto& [bin, count] : sorted) entropy += part(count);
  return entropy;
}

}  // namespace

CoordinateEntropy::CoordinateEntropy(std::span<const Vector3f> points, std::size_t most) {
  const std::size_t step = (points.size() + most - 1) / std::max<std::size_t>(most, 1);
  for (std::size_t i = 0; i < points.size(); i += step) {
    points_.push_back(points[i].cast<double>());
  }
}

double CoordinateEntropy::of(const Eigen::Matrix3d& axes, double bin) const {
  double entropy = 0;
  std::vector<double> coordinates(points_.size());
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d direction = axes.row(axis).transpose() / bin;
    std::transform(points_.begin(), points_.end(), coordinates.begin(),
                   [&](const Vector3d& point) { return direction.dot(point); });
    entropy += entropy_of(coordinates);
  }
  return entropy;
}

double crowding(std::span<const Vector3f> points, const Pose& frame, int axis,
                const Lattice& lattice, double shift) {
  std::unordered_map<std::int64_t, double> layers;
  for (const Vector3f& point : points) {
    const double at = lattice.to_cells(transformed(frame, point))[axis] + shift;
    if (std::abs(at) < kMaxCellIndex) ++layers[static_cast<std::int64_t>(std::floor(at))];
  }
  double squares = 0;
  for (const auto& [layer, count] : layers) squares += count * count;
  return squares;
}

}  // namespace rmap
