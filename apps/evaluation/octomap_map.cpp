#include "evaluation/map_under_test.hpp"

#include <algorithm>

#include <octomap/octomap.h>

namespace rmap::evaluation {

namespace {

constexpr int kOrigin = 32768;  // key of the cell at 0

octomap::point3d point_of(const Vector3d& vector) {
  const Vector3f rounded = vector.cast<float>();
  return {rounded.x(), rounded.y(), rounded.z()};
}

Cell cell_of(const octomap::OcTreeKey& key) {
  return {key[0] - kOrigin, key[1] - kOrigin, key[2] - kOrigin};
}

// What a subtree becomes when its leaves are just occupied or free.
enum class Likely { mixed, occupied, free };

class OctreeForms {
 public:
  explicit OctreeForms(const octomap::OcTree& tree) : tree_(tree) {}

  OctomapMap::Forms count() {
    if (tree_.getRoot() != nullptr) visit(*tree_.getRoot(), tree_.getTreeDepth());
    return forms_;
  }

 private:
  // `levels`: how many there are below the node.
  Likely visit(const octomap::OcTreeNode& node, unsigned levels) {
    if (!tree_.nodeHasChildren(&node)) {
      ++forms_.pruned.leaf;
      ++forms_.maximum_likelihood.leaf;
      // 8^levels leaves, below 1 + 8 + ... inner nodes.
      const std::uint64_t leaves = std::uint64_t{1} << (3 * levels);
      forms_.uncompressed.leaf += leaves;
      forms_.uncompressed.inner += (leaves - 1) / 7;
      return tree_.isNodeOccupied(node) ? Likely::occupied : Likely::free;
    }
    ++forms_.pruned.inner;
    ++forms_.uncompressed.inner;
    ++forms_.maximum_likelihood.inner;
    std::uint64_t alike[3] = {};
    for (unsigned i = 0; i < 8; ++i) {
      if (!tree_.nodeChildExists(&node, i)) continue;
      ++alike[static_cast<int>(visit(*tree_.getNodeChild(&node, i), levels - 1))];
    }
    for (const Likely state : {Likely::occupied, Likely::free}) {
      if (alike[static_cast<int>(state)] < 8) continue;
      // Eight equal leaves become one, in the place of their parent.
      forms_.maximum_likelihood.leaf -= 7;
      --forms_.maximum_likelihood.inner;
      return state;
    }
    return Likely::mixed;
  }

  const octomap::OcTree& tree_;
  OctomapMap::Forms forms_;
};

class Octomap : public OctomapMap {
 public:
  explicit Octomap(double resolution) : tree_(resolution) {}

  void insert(const Scan& scan) override {
    if (!scan.origins.empty()) return insert_beams(scan);
    octomap::Pointcloud cloud;
    cloud.reserve(scan.points.size());
    for (const Vector3f& point : scan.points) cloud.push_back(point.x(), point.y(), point.z());
    tree_.insertPointCloud(cloud, point_of(scan.map_from_sensor.translation()));
  }

  std::size_t extract() const override {
    std::size_t count = 0;
    for_each_occupied([&](const octomap::OcTree::leaf_iterator& leaf) {
      count += std::size_t{1} << (3 * (tree_.getTreeDepth() - leaf.getDepth()));
    });
    return count;
  }

  std::optional<double> probability(const Cell& cell) const override {
    const Cell shifted = cell + Cell::Constant(kOrigin);
    if (shifted.minCoeff() < 0 || shifted.maxCoeff() > 65535) return std::nullopt;
    const octomap::OcTreeNode* node = tree_.search(octomap::OcTreeKey(
        static_cast<octomap::key_type>(shifted.x()), static_cast<octomap::key_type>(shifted.y()),
        static_cast<octomap::key_type>(shifted.z())));
    return node == nullptr ? std::nullopt : std::optional(node->getOccupancy());
  }

  std::vector<Cell> occupied_cells() const override {
    std::vector<Cell> occupied;
    for_each_occupied([&](const octomap::OcTree::leaf_iterator& leaf) {
      // A pruned leaf stands for the cells from its lowest key on.
      const int edge = 1 << (tree_.getTreeDepth() - leaf.getDepth());
      const Cell low = cell_of(leaf.getIndexKey());
      for (int z = 0; z < edge; ++z) {
        for (int y = 0; y < edge; ++y) {
          for (int x = 0; x < edge; ++x) occupied.push_back(low + Cell(x, y, z));
        }
      }
    });
    std::sort(occupied.begin(), occupied.end(), morton_less);
    return occupied;
  }

  Forms forms() const override { return OctreeForms(tree_).count(); }

 private:
  // insertPointCloud takes one origin. What it does, for an origin each: a cell is updated once
  // a scan, and one in which a beam ends is not cleared by others.
  void insert_beams(const Scan& scan) {
    octomap::KeySet free;
    octomap::KeySet occupied;
    octomap::KeyRay ray;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const octomap::point3d end = point_of(scan.points[i].cast<double>());
      if (tree_.computeRayKeys(point_of(scan.origins[i]), end, ray)) {
        free.insert(ray.begin(), ray.end());
      }
      octomap::OcTreeKey key;
      if (tree_.coordToKeyChecked(end, key)) occupied.insert(key);
    }
    for (const octomap::OcTreeKey& key : free) {
      if (occupied.count(key) == 0) tree_.updateNode(key, false);
    }
    for (const octomap::OcTreeKey& key : occupied) tree_.updateNode(key, true);
  }

  template <class Use>
  void for_each_occupied(const Use& use) const {
    for (auto leaf = tree_.begin_leafs(); leaf != tree_.end_leafs(); ++leaf) {
      if (tree_.isNodeOccupied(*leaf)) use(leaf);
    }
  }

  octomap::OcTree tree_;
};

}  // namespace

std::unique_ptr<OctomapMap> make_octomap(double resolution) {
  return std::make_unique<Octomap>(resolution);
}

std::string octomap_version() { return RMAP_EVALUATION_OCTOMAP; }

}  // namespace rmap::evaluation
