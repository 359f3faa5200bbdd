#include "json.hpp"

#include "output.hpp"
#include "words.hpp"

namespace rmap::command {

namespace {

constexpr char kIndentCharacter = ' ';
constexpr int kIndent = 2;
constexpr int kOneLine = -1;

std::string dumped(const Json& json, int indent) {
  return json.dump(indent, kIndentCharacter, false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

Json json_of_count(double count) {
  if (count < 0x1p63) return static_cast<std::uint64_t>(count);
  return count;
}

Json json_of(const Vector3d& vector) { return Json::array({vector.x(), vector.y(), vector.z()}); }

Json json_of(const Cell& cell) { return Json::array({cell.x(), cell.y(), cell.z()}); }

Json json_of(const Box& box) { return {{"min", json_of(box.min)}, {"max", json_of(box.max)}}; }

Json json_of(const CellBox& box) { return {{"min", json_of(box.min)}, {"max", json_of(box.max)}}; }

Json json_of(const Options& options) {
  return {{"resolution", options.resolution},
          {"prob_hit", options.prob_hit},
          {"prob_miss", options.prob_miss},
          {"clamp_min", options.clamp_min},
          {"clamp_max", options.clamp_max},
          {"prior", options.prior},
          {"occupied_threshold", options.occupied_threshold},
          {"free_probability", options.free_probability},
          {"saturation", word_of(options.saturation)},
          {"min_range", options.min_range},
          {"max_range", options.max_range},
          {"beams", word_of(options.beams)}};
}

Json json_of(const BytesInUse& bytes) {
  return {{"nodes", bytes.nodes},
          {"blocks", bytes.blocks},
          {"values", bytes.values},
          {"records", bytes.records},
          {"total", bytes.total()}};
}

Json json_of(const RTreeStatistics& statistics) {
  Json levels = Json::array();
  for (const RTreeLevelStatistics& level : statistics.levels) {
    levels.push_back({{"level", level.level},
                      {"nodes", level.nodes},
                      {"branches", level.branches},
                      {"fill", level.fill},
                      {"volume", level.volume},
                      {"overlap_volume", level.overlap_volume},
                      {"dead_space", level.dead_space}});
  }
  return {{"height", statistics.height},
          {"nodes", statistics.nodes},
          {"items", statistics.items},
          {"levels", levels}};
}

std::string text_of(const Json& json) { return dumped(json, kIndent); }

void print_json(const Json& answer) { print(text_of(answer)); }

void print_json_line(const Json& answer) { print(dumped(answer, kOneLine)); }

}  // namespace rmap::command
