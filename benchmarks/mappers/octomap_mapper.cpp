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

octomap::point3d to_octomap(const Vector3d& vector) {
  const Vector3f rounded = vector.cast<float>();
  return {rounded.x(), rounded.y(), rounded.z()};
}

class OctomapMapper : public Mapper, private MapAnswers {
 public:
  OctomapMapper(double resolution, Variant variant) : tree_(resolution), variant_(variant) {}

  void take(std::span<const Scan> scans) override {
    for (const Scan& scan : scans) {
      clouds_.emplace_back();
      clouds_.back().origin = to_octomap(scan.map_from_sensor.translation());
      clouds_.back().points.reserve(scan.points.size());
      for (const Vector3f& point : scan.points) {
        clouds_.back().points.push_back(point.x(), point.y(), point.z());
      }
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
    std::size_t count = 0;
    for (auto leaf = tree_.begin_leafs(); leaf != tree_.end_leafs(); ++leaf) {
      count += cells_of(leaf);
    }
    return count;
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

  template <class Leaf>
  std::size_t cells_of(const Leaf& leaf) const {
    return std::size_t{1} << (3 * (tree_.getTreeDepth() - leaf.getDepth()));
  }
  std::size_t iterate() const override {
    std::size_t count = 0;
    for (auto leaf = tree_.begin_leafs(); leaf != tree_.end_leafs(); ++leaf) {
      if (tree_.isNodeOccupied(*leaf)) count += cells_of(leaf);
    }
    return count;
  }
  bool is_occupied(const Vector3d& point) const override {
    const octomap::OcTreeNode* node = tree_.search(to_octomap(point));
    return node != nullptr && tree_.isNodeOccupied(node);
  }
  std::optional<Cell> first_occupied(const Ray& ray) const override {
    octomap::point3d end;
    if (!tree_.castRay(to_octomap(ray.origin), to_octomap(ray.direction), end, true,
                       ray.max_range)) {
      return std::nullopt;
    }
    octomap::OcTreeKey key;
    if (!tree_.coordToKeyChecked(end, key)) return std::nullopt;
    return Cell(key[0] - 32768, key[1] - 32768, key[2] - 32768);
  }
  void save(const std::filesystem::path& file) const override { tree_.write(file.string()); }
  std::size_t load(const std::filesystem::path& file) const override {
    // OctoMap tells of each file that it reads.
    std::streambuf* const told = std::cerr.rdbuf(nullptr);
    const std::unique_ptr<octomap::AbstractOcTree> read(
        octomap::AbstractOcTree::read(file.string()));
    std::cerr.rdbuf(told);
    std::cerr.clear();
    const auto& tree = dynamic_cast<const octomap::OcTree&>(*read);
    std::size_t count = 0;
    for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
      if (tree.isNodeOccupied(*leaf)) count += cells_of(leaf);
    }
    return count;
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
