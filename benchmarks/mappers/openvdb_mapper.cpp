#include "mappers/mapper.hpp"
#include "support/plain_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <openvdb/openvdb.h>

namespace rmap::bench {

namespace {

// OctoMap's numbers.
constexpr float kHit = 0.8472979F;
constexpr float kMiss = -0.4054651F;
constexpr float kLeast = -2.0F;
constexpr float kMost = 3.5F;

using Mask = std::uint64_t;
constexpr std::uint32_t kWords = 8;
constexpr std::uint32_t kVoxels = 512;

std::uint32_t word_of(const openvdb::Coord& voxel) {
  return static_cast<std::uint32_t>(voxel.x() & 7);
}
Mask bit_of(const openvdb::Coord& voxel) {
  return Mask{1} << (static_cast<std::uint32_t>(voxel.y() & 7) * 8 +
                     static_cast<std::uint32_t>(voxel.z() & 7));
}

// What a scan says: a voxel is active when a beam crossed it or ended in it, and its
// value tells whether one ended. The words of the last leaf are kept at hand.
class ScanGrid {
 public:
  void clear() {
    accessor_.clear();
    tree_.clear();
    words_ = nullptr;
  }
  // Whether the voxel was no end before.
  bool end(const openvdb::Coord& voxel) {
    find(voxel);
    Mask& ends = ends_[word_of(voxel)];
    const bool is_new = (ends & bit_of(voxel)) == 0;
    ends |= bit_of(voxel);
    words_[word_of(voxel)] |= bit_of(voxel);
    return is_new;
  }
  void cross(const openvdb::Coord& voxel) {
    find(voxel);
    words_[word_of(voxel)] |= bit_of(voxel);
  }
  // use(leaf's corner, seen, ends), the words of both masks.
  template <class Use>
  void for_each_leaf(Use&& use) {
    for (auto leaf = tree_.beginLeaf(); leaf; ++leaf) {
      use(leaf->origin(), &leaf->getValueMask().template getWord<Mask>(0), leaf->buffer().data());
    }
  }

 private:
  void find(const openvdb::Coord& voxel) {
    const openvdb::Coord corner = voxel & ~7;
    if (words_ != nullptr && corner == corner_) return;
    auto* leaf = accessor_.touchLeaf(voxel);
    words_ = &leaf->getValueMask().template getWord<Mask>(0);
    ends_ = leaf->buffer().data();
    corner_ = corner;
  }

  openvdb::BoolTree tree_{false};
  openvdb::tree::ValueAccessor<openvdb::BoolTree, false> accessor_{tree_};
  openvdb::Coord corner_;
  Mask* words_ = nullptr;
  Mask* ends_ = nullptr;
};

// Every voxel from the start to before the end, by the parameters at which a beam enters
// the next layer of each axis.
template <class Use>
void walk(const Vector3d& start, const Vector3d& end, Use&& use) {
  const Vector3d direction = end - start;
  openvdb::Coord voxel;
  openvdb::Coord step;
  Vector3d next;
  Vector3d between;
  std::int32_t left = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double first = std::floor(start[axis]);
    voxel[axis] = static_cast<std::int32_t>(first);
    left += std::abs(static_cast<std::int32_t>(std::floor(end[axis])) - voxel[axis]);
    step[axis] = direction[axis] < 0 ? -1 : 1;
    const double border = direction[axis] < 0 ? first : first + 1;
    const bool moves = direction[axis] != 0;
    next[axis] =
        moves ? (border - start[axis]) / direction[axis] : std::numeric_limits<double>::infinity();
    between[axis] = moves ? 1 / std::abs(direction[axis]) : std::numeric_limits<double>::infinity();
  }
  for (; left > 0; --left) {
    use(voxel);
    const int axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    voxel[axis] += step[axis];
    next[axis] += between[axis];
  }
}

// A mapper on OpenVDB in the known fast way: the scan goes into a grid of bits, which is
// then added to the map leaf by leaf.
class OpenvdbMapper : public Mapper {
 public:
  OpenvdbMapper(double resolution, bool per_end_cell)
      : to_cells_(1 / resolution), per_end_cell_(per_end_cell) {}

  void take(std::span<const Scan> scans) override { scans_ = scans; }
  void insert() override {
    for (const Scan& scan : scans_) {
      scan_.clear();
      cast(scan);
      merge();
    }
    scan_.clear();
  }

  std::size_t cell_count() const override { return tree_.activeVoxelCount(); }
  std::vector<Cell> occupied() const override {
    std::vector<Cell> occupied;
    for (auto value = tree_.cbeginValueOn(); value; ++value) {
      const openvdb::Coord at = value.getCoord();
      if (*value > 0) occupied.emplace_back(at.x(), at.y(), at.z());
    }
    std::sort(occupied.begin(), occupied.end(), test::MortonOrder());
    return occupied;
  }

 private:
  void cast(const Scan& scan) {
    const Vector3d origin = Vector3d(scan.map_from_sensor.translation()) * to_cells_;
    for (const Vector3f& point : scan.points) {
      const Vector3d end = point.cast<double>() * to_cells_;
      const auto layer = [&](int axis) { return static_cast<std::int32_t>(std::floor(end[axis])); };
      const bool is_new = scan_.end({layer(0), layer(1), layer(2)});
      if (per_end_cell_ && !is_new) continue;
      walk(origin, end, [&](const openvdb::Coord& voxel) { scan_.cross(voxel); });
    }
  }
  void merge() {
    scan_.for_each_leaf([&](const openvdb::Coord& corner, const Mask* seen, const Mask* ends) {
      auto* leaf = tree_.touchLeaf(corner);
      float* values = leaf->buffer().data();
      for (std::uint32_t word = 0; word < kWords; ++word) {
        for (Mask left = seen[word]; left != 0; left &= left - 1) {
          const auto at = static_cast<std::uint32_t>(std::countr_zero(left));
          float& value = values[word * (kVoxels / kWords) + at];
          const bool hit = ((ends[word] >> at) & 1) != 0;
          value = std::clamp(value + (hit ? kHit : kMiss), kLeast, kMost);
        }
        leaf->getValueMask().template getWord<Mask>(word) |= seen[word];
      }
    });
  }

  double to_cells_;
  bool per_end_cell_;
  std::span<const Scan> scans_;
  ScanGrid scan_;
  openvdb::FloatTree tree_{0.0F};
};

}  // namespace

std::vector<Contender> openvdb_contenders() {
  const auto make = [](bool per_end_cell) {
    return [per_end_cell](double resolution) {
      return std::make_unique<OpenvdbMapper>(resolution, per_end_cell);
    };
  };
  return {{.name = "openvdb", .make = make(false), .same_map = true},
          {.name = "openvdb per_end_cell", .make = make(true)}};
}

}  // namespace rmap::bench
