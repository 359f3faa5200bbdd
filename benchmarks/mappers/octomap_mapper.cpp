#include "mappers/mapper.hpp"
#include "support/octomap_twin.hpp"

#include <iostream>

#include <octomap/octomap.h>

namespace rmap::bench {

namespace {

struct Variant {
  bool lazy = false;
  bool discretize = false;
};

// Cells of the leaves for which wanted(leaf) holds; those pruned to one leaf counted singly.
template <class Wanted>
std::size_t count_cells(const octomap::OcTree& tree, const Wanted& wanted) {
  std::size_t count = 0;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    if (wanted(*leaf)) count += std::size_t{1} << (3 * (tree.getTreeDepth() - leaf.getDepth()));
  }
  return count;
}

std::size_t count_occupied(const octomap::OcTree& tree) {
  return count_cells(tree,
                     [&](const octomap::OcTreeNode& node) { return tree.isNodeOccupied(node); });
}

class OctomapMapper : public Mapper, private MapAnswers {
 public:
  OctomapMapper(double resolution, Variant variant) : tree_(resolution), variant_(variant) {}

  void take(std::span<const Scan> scans) override {
    for (const Scan& scan : scans) {
      clouds_.push_back(
          {test::octomap_cloud(scan), test::octomap_point(scan.map_from_sensor.translation())});
    }
  }
  void insert() override {
    for (const Cloud& cloud : clouds_) {
      tree_.insertPointCloud(cloud.points, cloud.origin, -1, variant_.lazy, variant_.discretize);
    }
    if (variant_.lazy) {
      tree_.updateInnerOccupancy();
      tree_.prune();
    }
  }

  std::size_t cell_count() const override {
    return count_cells(tree_, [](const octomap::OcTreeNode&) { return true; });
  }
  std::vector<Cell> occupied() const override {
    octomap::OcTree expanded(tree_);
    const auto cells = test::occupied_cells(expanded);
    return {cells.begin(), cells.end()};
  }
  const MapAnswers* answers() const override { return this; }

 private:
  struct Cloud {
    octomap::Pointcloud points;
    octomap::point3d origin;
  };

  std::size_t iterate() const override { return count_occupied(tree_); }
  bool is_occupied(const Vector3d& point) const override {
    const octomap::OcTreeNode* node = tree_.search(test::octomap_point(point));
    return node != nullptr && tree_.isNodeOccupied(node);
  }
  std::optional<Cell> first_occupied(const Ray& ray) const override {
    octomap::point3d end;
    if (!tree_.castRay(test::octomap_point(ray.origin), test::octomap_point(ray.direction), end,
                       true, ray.max_range)) {
      return std::nullopt;
    }
    octomap::OcTreeKey key;
    if (!tree_.coordToKeyChecked(end, key)) return std::nullopt;
    return test::cell_of(key);
  }
  void save(const std::filesystem::path& file) const override { tree_.write(file.string()); }
  std::size_t load(const std::filesystem::path& file) const override {
    // OctoMap tells of each file that it reads.
    std::streambuf* const told = std::cerr.rdbuf(nullptr);
    const std::unique_ptr<octomap::AbstractOcTree> read(
        octomap::AbstractOcTree::read(file.string()));
    std::cerr.rdbuf(told);
    std::cerr.clear();
    return count_occupied(dynamic_cast<const octomap::OcTree&>(*read));
  }
  std::string extension() const override { return ".ot"; }

  octomap::OcTree tree_;
  Variant variant_;
  std::vector<Cloud> clouds_;
};

Contender contender(const std::string& name, Variant variant) {
  return {.name = name,
          .make =
              [variant](double resolution) {
                return std::make_unique<OctomapMapper>(resolution, variant);
              },
          .same_map = !variant.discretize,
          .asked = !variant.discretize && !variant.lazy};
}

}  // namespace

std::vector<Contender> octomap_contenders() {
  return {contender("octomap", {}), contender("octomap lazy", {.lazy = true}),
          contender("octomap discretize", {.discretize = true})};
}

}  // namespace rmap::bench
