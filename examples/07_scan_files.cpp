// A folder of scans, read twice: the complete history of every cell.
#include <filesystem>
#include <iostream>

#include <rmap/rmap.hpp>

int main() {
  // What a robot would have recorded: numbered scan files and poses.txt.
  const std::filesystem::path folder = "yard";
  std::filesystem::remove_all(folder);
  rmap::ScanFolderWriter writer(folder, ".pcd");
  for (const rmap::Scan& scan : rmap::make_simulation("moving", {.scans = 12})) writer.add(scan);
  writer.finish();

  // One pass, as a live robot maps: a cell starts with the first beam that ends in it, and what
  // beams saw there before is lost.
  rmap::ScanRange scans = rmap::read_scans(folder);
  rmap::Grid first_hit({.resolution = 0.1});
  for (const rmap::Scan& scan : scans) first_hit.insert(scan);

  // Two passes: first every cell is made, then every scan sees all of them.
  rmap::Grid complete({.resolution = 0.1});
  scans.rewind();
  for (const rmap::Scan& scan : scans) complete.prepare(scan);
  scans.rewind();
  rmap::InsertReport total;
  for (const rmap::Scan& scan : scans) total += complete.insert(scan);
  std::cout << total.points << " points, " << total.hits << " hits, " << total.misses
            << " misses\n";

  const rmap::MapDifference difference = rmap::compare(first_hit, complete);
  std::cout << difference.both << " cells in both; " << difference.occupied_only_a
            << " of them are occupied in the single pass only, " << difference.occupied_only_b
            << " in the complete history only\n"
            << "history of the second map: "
            << (complete.history() == rmap::History::complete ? "complete\n" : "first hit\n");
}
