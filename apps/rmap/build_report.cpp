#include "build_report.hpp"

#include "words.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace rmap::command {

namespace {

using Reason = std::pair<const char*, std::uint64_t>;

std::array<Reason, 6> reasons(const SkippedPoints& skipped, const ScanFilter::Counts& left_out) {
  return {{{"not_finite", skipped.not_finite},
           {"too_near", skipped.too_near},
           {"beyond_limits", skipped.beyond_limits},
           {"no_range", skipped.no_range},
           {"cropped", left_out.cropped},
           {"ignored", left_out.ignored}}};
}

// One line for each thing, nothing when there is none.
std::string words_of(const ScanNotes& notes) {
  std::string text;
  if (notes.without_pose > 0) {
    text += fmt::format("  passed over {} without a pose\n", counted(notes.without_pose, "scan"));
  }
  for (const std::string& warning : notes.warnings)
    text += fmt::format("  warning     {}\n", warning);
  for (const std::string& remark : notes.remarks) text += fmt::format("  note        {}\n", remark);
  return text;
}

}  // namespace

Json json_of(const SkippedPoints& skipped, const ScanFilter::Counts& left_out) {
  Json json = Json::object();
  for (const auto& [reason, count] : reasons(skipped, left_out)) json[reason] = count;
  return json;
}

std::string words_of(const SkippedPoints& skipped, const ScanFilter::Counts& left_out) {
  std::string text;
  for (const auto& [reason, count] : reasons(skipped, left_out)) {
    if (count == 0) continue;
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {}", grouped(count), reason);
  }
  return text.empty() ? "none" : text;
}

Json json_of(const BuildReport& report, const BuiltMap& map) {
  const InsertReport& inserted = report.inserted;
  return {{"output", map.output.string()},
          {"scans", report.scans},
          {"scans_without_pose", report.notes.without_pose},
          {"warnings", report.notes.warnings},
          {"remarks", report.notes.remarks},
          {"points", report.points},
          {"inserted", inserted.inserted},
          {"cut", inserted.cut},
          {"skipped", json_of(inserted.skipped, report.left_out)},
          {"end_cells", inserted.end_cells},
          {"new_cells", report.prepared_cells + inserted.new_cells},
          {"hits", inserted.hits},
          {"misses", inserted.misses},
          {"cells", map.cells},
          {"occupied", map.occupied},
          {"history", word_of(map.history)},
          {"bytes_in_use", json_of(map.bytes_in_use)},
          {"seconds",
           {{"read", report.seconds_read},
            {"prepare", report.seconds_prepare},
            {"insert", report.seconds_insert},
            {"save", report.seconds_save}}}};
}

std::string words_of(const BuildReport& report, const BuiltMap& map) {
  const InsertReport& inserted = report.inserted;
  return fmt::format(
             "{}: {} with {}\n"
             "  points      {} inserted, {} cut; skipped: {}\n"
             "  cells       {}, {} of them occupied; {} new\n"
             "  updates     {} hits, {} misses in {} end cells\n"
             "  history     {}\n"
             "  in memory   {}\n"
             "  seconds     {:.2f} read, {:.2f} prepare, {:.2f} insert, {:.2f} save\n",
             map.output.string(), counted(report.scans, "scan"), counted(report.points, "point"),
             grouped(inserted.inserted), grouped(inserted.cut),
             words_of(inserted.skipped, report.left_out), grouped(map.cells), grouped(map.occupied),
             grouped(report.prepared_cells + inserted.new_cells), grouped(inserted.hits),
             grouped(inserted.misses), grouped(inserted.end_cells), word_of(map.history),
             readable_bytes(map.bytes_in_use.total()), report.seconds_read, report.seconds_prepare,
             report.seconds_insert, report.seconds_save) +
         words_of(report.notes);
}

Json json_of(const CheckReport& report) {
  return {{"scans", report.scans},
          {"scans_without_pose", report.notes.without_pose},
          {"warnings", report.notes.warnings},
          {"remarks", report.notes.remarks},
          {"points", report.points},
          {"skipped", json_of(report.skipped, report.left_out)},
          {"problems", report.problems}};
}

std::string words_of(const CheckReport& report) {
  return fmt::format("{} with {}; skipped: {}\n", counted(report.scans, "scan"),
                     counted(report.points, "point"), words_of(report.skipped, report.left_out)) +
         words_of(report.notes);
}

}  // namespace rmap::command
