#include "info.hpp"
#include "map_files.hpp"
#include "words.hpp"

#include <fmt/format.h>

#include <rmap/grid.hpp>

namespace rmap::command {

namespace {

std::string words_of(const Options& options) {
  return fmt::format(
      "hit {}, miss {}, clamped to {} ... {} ({}), prior {}, occupied above {}, absent cells count "
      "{}\n"
      "  scans used  ranges {} ... {} m, beams {}",
      options.prob_hit, options.prob_miss, options.clamp_min, options.clamp_max,
      word_of(options.saturation), options.prior, options.occupied_threshold,
      options.free_probability, options.min_range, options.max_range, word_of(options.beams));
}

std::string words_of(const RTreeStatistics& tree) {
  std::string text = fmt::format("height {}, {}, {} leaf branches\n", tree.height,
                                 counted(tree.nodes, "node"), grouped(tree.items));
  text += fmt::format("    {:>5} {:>10} {:>10} {:>7} {:>14} {:>14} {:>14}\n", "level", "nodes",
                      "branches", "fill", "volume", "overlap", "dead space");
  for (const RTreeLevelStatistics& level : tree.levels) {
    text += fmt::format("    {:>5} {:>10} {:>10} {:>6.1f}% {:>14.6g} {:>14.6g} {:>14.6g}\n",
                        level.level, level.nodes, level.branches, 100 * level.fill, level.volume,
                        level.overlap_volume, level.dead_space);
  }
  return text;
}

}  // namespace

Description describe_map(const std::filesystem::path& file, const LoadOptions& options) {
  const MapFileInfo info = read_map_info(file);
  const Grid grid = load(file, options);
  const Lattice& lattice = grid.lattice();
  const std::size_t occupied = occupied_count(grid);
  const BytesInUse bytes = grid.bytes_in_use();
  const RTreeStatistics tree = grid.rtree_statistics();
  const CellBox cells = grid.bounds();
  const Box bounds = lattice.metric(cells);

  Json chunks = Json::array();
  for (const MapChunk& chunk : info.chunks) {
    chunks.push_back({{"type", chunk.type},
                      {"required", chunk.required},
                      {"compressed", chunk.compressed},
                      {"offset", chunk.offset},
                      {"stored_size", chunk.stored_size},
                      {"raw_size", chunk.raw_size}});
  }
  return {
      .json = {{"file", file.string()},
               {"kind", "map"},
               {"format_version", info.format_version},
               {"file_bytes", info.file_size},
               {"resolution", lattice.resolution()},
               {"cells", grid.cell_count()},
               {"occupied", occupied},
               {"blocks", info.blocks},
               {"scans", info.scans},
               {"history", word_of(grid.history())},
               {"bounds", grid.empty() ? Json(nullptr) : json_of(bounds)},
               {"cell_bounds", grid.empty() ? Json(nullptr) : json_of(cells)},
               {"options", json_of(grid.options())},
               {"layout", word_of(grid.options().layout)},
               {"max_branches", grid.options().max_branches},
               {"split", word_of(grid.options().split)},
               {"bytes_in_use", json_of(bytes)},
               {"rtree", json_of(tree)},
               {"chunks", chunks}},
      .words = fmt::format(
          "{}: map of {} m cells, format {}, {}\n"
          "  cells       {}, {} of them occupied, in {}\n"
          "  bounds      {} m\n"
          "  history     {}, of {}\n"
          "  options     {}\n"
          "  in memory   {} as {}: nodes {}, blocks {}, values {}, records {}\n"
          "  R-tree      {}",
          file.string(), lattice.resolution(), info.format_version, readable_bytes(info.file_size),
          grouped(grid.cell_count()), grouped(occupied), counted(info.blocks, "block"),
          grid.empty() ? "none, 0" : readable_box(bounds), word_of(grid.history()),
          counted(info.scans, "scan"), words_of(grid.options()), readable_bytes(bytes.total()),
          word_of(grid.options().layout), readable_bytes(bytes.nodes), readable_bytes(bytes.blocks),
          readable_bytes(bytes.values), readable_bytes(bytes.records), words_of(tree))};
}

}  // namespace rmap::command
