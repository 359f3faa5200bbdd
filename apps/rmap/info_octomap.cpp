#include "info.hpp"
#include "words.hpp"

#include <fmt/format.h>

#include <rmap/lattice.hpp>
#include <rmap/octomap_file.hpp>

namespace rmap::command {

Description describe_octomap(const std::filesystem::path& file) {
  const OctomapInfo info = read_octomap_info(file);
  const Lattice lattice(info.resolution);
  const auto box = [&](const CellBox& cells) {
    return cells.empty() ? Json(nullptr) : json_of(lattice.metric(cells));
  };
  const auto words = [&](const CellBox& cells) {
    return cells.empty() ? std::string("none") : readable_box(lattice.metric(cells)) + " m";
  };
  const bool values = !info.states_only && !info.bounds.empty();
  const auto bytes = std::filesystem::file_size(file);
  return {
      .json = {{"file", file.string()},
               {"kind", "octomap"},
               {"file_bytes", bytes},
               {"id", info.id},
               {"states_only", info.states_only},
               {"colors", info.colors},
               {"resolution", info.resolution},
               {"nodes", info.nodes},
               {"leaves", {{"occupied", info.occupied_leaves}, {"free", info.free_leaves}}},
               {"cells", {{"occupied", info.occupied_cells}, {"free", info.free_cells}}},
               {"bounds", box(info.bounds)},
               {"occupied_bounds", box(info.occupied_bounds)},
               {"log_odds", values ? Json{{"min", info.min_log_odds}, {"max", info.max_log_odds}}
                                   : Json(nullptr)}},
      .words = fmt::format(
          "{}: map of OctoMap, {} of {} m cells, {}\n"
          "  nodes       {}\n"
          "  occupied    {} leaves, {} cells with large leaves expanded\n"
          "  free        {} leaves, {} cells\n"
          "  bounds      {}, of what is occupied {}\n"
          "  values      {}{}\n",
          file.string(), info.id, info.resolution, readable_bytes(bytes), grouped(info.nodes),
          grouped(info.occupied_leaves), grouped(info.occupied_cells), grouped(info.free_leaves),
          grouped(info.free_cells), words(info.bounds), words(info.occupied_bounds),
          info.states_only ? "none, states only"
          : values ? fmt::format("log-odds {:.4g} ... {:.4g}", info.min_log_odds, info.max_log_odds)
                   : "none",
          info.colors ? ", with colours" : "")};
}

}  // namespace rmap::command
