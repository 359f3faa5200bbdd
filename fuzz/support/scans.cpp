#include "support/scans.hpp"

#include "support/input.hpp"

namespace rmap::fuzz {

namespace {

struct Pass {
  std::size_t scans = 0;
  std::size_t points = 0;
  std::size_t errors = 0;

  friend bool operator==(const Pass&, const Pass&) = default;
};

Pass read_to_the_end(const std::filesystem::path& file, ScanSource& source, std::size_t most) {
  Pass pass;
  Scan scan;
  for (bool more = true; more;) {
    const bool sound = is_sound(file, [&] { more = source.next(scan); });
    if (!sound) {
      ++pass.errors;
    } else if (more) {
      ++pass.scans;
      pass.points += scan.points.size();
    }
    if (pass.scans + pass.errors > most) fail("a source with more scans than its file has bytes");
  }
  return pass;
}

}  // namespace

void fuzz_scans(std::string_view bytes, const std::string& name, const ScanReadOptions& options) {
  const std::filesystem::path file = write_file(bytes, name);
  // Once: it stays the same.
  static const auto kPoses = write_file("0 0 0 0 0 0 1\n", "poses.txt");
  std::unique_ptr<ScanSource> source;
  if (!is_sound(file, [&] { source = open_scans(file, options); })) return;
  const std::size_t most = bytes.size() + 1;
  const Pass first = read_to_the_end(file, *source, most);
  source->rewind();
  if (read_to_the_end(file, *source, most) != first)
    fail("a second pass that gives another result");
}

}  // namespace rmap::fuzz
