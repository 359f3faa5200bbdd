#include "cuboid_report.hpp"

#include "words.hpp"

#include <numbers>

#include <fmt/format.h>

#include <rmap/cuboid_tree.hpp>

namespace rmap::command {

namespace {

double ratio(std::uint64_t a, std::uint64_t b) {
  return b == 0 ? 0 : static_cast<double>(a) / static_cast<double>(b);
}

}  // namespace

CuboidEvaluation evaluate_cuboids(std::span<const CountedCell> cells,
                                  std::span<const Cuboid> cuboids) {
  CuboidEvaluation evaluation{cuboid_error(cells, cuboids), cuboid_bytes(cells, cuboids), {}};
  for (const int branches : {8, 16, 32}) {
    evaluation.rtree_bytes.emplace_back(
        branches, cuboid_tree(cuboids, {.max_branches = branches}).statistics().bytes_in_use);
  }
  return evaluation;
}

Json json_of(const CuboidError& error) {
  return {{"cells", error.cells},
          {"points", error.points},
          {"cuboids", error.cuboids},
          {"volume", error.volume},
          {"lost_cells", error.lost_cells},
          {"lost_points", error.lost_points},
          {"lost_beyond_one", error.lost_beyond_one},
          {"farthest_lost",
           error.cuboids == 0 && error.lost_cells > 0 ? Json(nullptr) : Json(error.farthest_lost)},
          {"false_cells", error.false_cells},
          {"false_share", error.false_share()},
          {"farthest_false", error.farthest_false}};
}

Json json_of(const CuboidBytes& bytes) {
  return {{"plain", bytes.plain},           {"packed", bytes.packed},
          {"raw_points", bytes.raw_points}, {"voxel_keys", bytes.voxel_keys},
          {"octomap", bytes.octomap},       {"octomap_pruned", bytes.octomap_pruned},
          {"bit_blocks", bytes.bit_blocks}};
}

Json json_of_frame(const Pose& frame) {
  const Eigen::Quaterniond rotation(frame.linear());
  return {{"translation", json_of(Vector3d(frame.translation()))},
          {"rotation", {rotation.x(), rotation.y(), rotation.z(), rotation.w()}}};
}

std::string error_lines(const CuboidError& error) {
  if (error.cuboids == 0) return fmt::format("lost         all {}\n", counted(error.cells, "cell"));
  return fmt::format(
      "lost         {} of {} and {} of {}; {} farther than a cell, the farthest {}\n"
      "false        {} of {} ({:.1f} %), the farthest {} from an occupied one\n",
      grouped(error.lost_cells), counted(error.cells, "cell"), grouped(error.lost_points),
      counted(error.points, "point"), grouped(error.lost_beyond_one),
      counted(static_cast<std::uint64_t>(error.farthest_lost), "cell"), grouped(error.false_cells),
      counted(error.volume, "cell"), 100 * error.false_share(),
      counted(static_cast<std::uint64_t>(error.farthest_false), "cell"));
}

std::string byte_lines(const CuboidEvaluation& evaluation) {
  const CuboidBytes& bytes = evaluation.bytes;
  const auto line = [&](const char* what, std::uint64_t size) {
    return fmt::format("  {:<22}{:>12}   {:>7.2f}   {:>7.2f}\n", what, grouped(size),
                       ratio(size, bytes.plain), ratio(size, bytes.packed));
  };
  std::string text = "bytes                              per 24 B   per 8 B\n";
  text += line("cuboids, plain", bytes.plain);
  text += line("cuboids, packed", bytes.packed);
  text += line("raw points", bytes.raw_points);
  text += line("voxel keys", bytes.voxel_keys);
  text += line("OctoMap of end points", bytes.octomap);
  text += line("the same, pruned", bytes.octomap_pruned);
  text += line("8x8x8 bit blocks", bytes.bit_blocks);
  for (const auto& [branches, size] : evaluation.rtree_bytes) {
    text += line(fmt::format("R-tree of cuboids, M {}", branches).c_str(), size);
  }
  return text;
}

std::vector<std::string> remarks(const CuboidEvaluation& evaluation) {
  const CuboidError& error = evaluation.error;
  const CuboidBytes& bytes = evaluation.bytes;
  std::vector<std::string> remarks;
  constexpr std::uint64_t kFew = 1000;  // cells of which nothing need be said
  if (error.cells < kFew) return remarks;
  constexpr std::uint64_t kClearly = 2;
  if (error.cuboids > 0 && error.false_cells == 0 && error.lost_cells == 0 &&
      bytes.bit_blocks < kClearly * bytes.packed) {
    remarks.emplace_back(
        "exact cuboids of noisy surfaces hardly take less than bits in blocks: allow empty cells "
        "next to occupied ones (--outer 1), or lose some (--sigma)");
  }
  if (error.farthest_false > 0) {
    remarks.push_back(
        fmt::format("surfaces are thicker by up to {} on either side",
                    counted(static_cast<std::uint64_t>(error.farthest_false), "cell")));
  }
  if (error.lost_cells > 0 &&
      ratio(error.lost_cells, error.cells) > 1.5 * ratio(error.lost_points, error.points)) {
    remarks.emplace_back(
        "what is lost is where points are sparse: far surfaces go first when sigma counts points");
  }
  if (error.cuboids > 0 && error.false_cells == 0 && ratio(error.cells, error.cuboids) < 8) {
    remarks.emplace_back("curved and noisy objects need fewer cuboids with larger cells");
  }
  return remarks;
}

std::string readable_frame(const Pose& frame) {
  if (frame.matrix().isIdentity(0)) return "identity";
  const double degrees = Eigen::AngleAxisd(frame.linear()).angle() * 180 / std::numbers::pi;
  return fmt::format("turned by {:.2f} degrees, moved by {} m", degrees,
                     in_brackets(frame.translation()));
}

}  // namespace rmap::command
