#include "io/bag/bag_source.hpp"
#include "io/graph_file.hpp"
#include "io/no_returns.hpp"
#include "io/point_formats.hpp"
#include "io/scan_file.hpp"
#include "io/scan_folder.hpp"
#include "io/system_error.hpp"

#include <array>
#include <cassert>
#include <utility>

#include <fmt/format.h>

#include <rmap/bag_info.hpp>
#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {

namespace {

// A form in which scans with poses come. A new one is a line in kForms; the first that
// recognises the path opens it, so special forms stand before general ones.
struct ScanForm {
  bool (*recognises)(const std::filesystem::path& path);
  std::unique_ptr<ScanSource> (*open)(const std::filesystem::path& path,
                                      const ScanReadOptions& options);
};

bool is_folder(const std::filesystem::path& path) { return std::filesystem::is_directory(path); }

bool is_graph(const std::filesystem::path& path) { return ending_of(path) == ".graph"; }

constexpr std::array kForms = {
    ScanForm{.recognises = is_bag, .open = open_bag_scans},
    ScanForm{.recognises = is_folder, .open = open_scan_folder},
    ScanForm{.recognises = is_graph, .open = open_scan_graph},
    ScanForm{.recognises = is_point_file, .open = open_scan_file},
};

// One source after another.
class ScanSequence : public ScanSource {
 public:
  explicit ScanSequence(std::vector<std::unique_ptr<ScanSource>> sources)
      : sources_(std::move(sources)) {}

  bool next(Scan& scan) override {
    while (current_ < sources_.size()) {
      if (sources_[current_]->next(scan)) return true;
      ++current_;
    }
    return false;
  }

  void rewind() override {
    for (const auto& source : sources_) source->rewind();
    current_ = 0;
  }

  std::optional<std::size_t> size() const override {
    std::size_t total = 0;
    for (const auto& source : sources_) {
      const auto size = source->size();
      if (!size) return std::nullopt;
      total += *size;
    }
    return total;
  }

  ScanNotes notes() const override {
    ScanNotes all;
    for (const auto& source : sources_) all += source->notes();
    return all;
  }

 private:
  std::vector<std::unique_ptr<ScanSource>> sources_;
  std::size_t current_ = 0;
};

}  // namespace

ScanNotes& ScanNotes::operator+=(const ScanNotes& other) {
  without_pose += other.without_pose;
  warnings.insert(warnings.end(), other.warnings.begin(), other.warnings.end());
  remarks.insert(remarks.end(), other.remarks.begin(), other.remarks.end());
  return *this;
}

std::unique_ptr<ScanSource> open_scans(const std::filesystem::path& path,
                                       const ScanReadOptions& options) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status)) throw system_error("open", path, code.value());
  for (const ScanForm& form : kForms) {
    if (!form.recognises(path)) continue;
    auto source = form.open(path, options);
    return options.no_return ? with_no_returns(std::move(source), *options.no_return)
                             : std::move(source);
  }
  throw Error(ErrorKind::input,
              fmt::format("{} holds no scans as far as its name says: folders, bags (.mcap, .db3) "
                          "and files ending in .graph, {} are allowed",
                          path.string(), point_endings()));
}

std::unique_ptr<ScanSource> open_scan_sequence(const std::vector<std::filesystem::path>& paths,
                                               const ScanReadOptions& options) {
  if (paths.empty()) {
    throw Error(ErrorKind::usage, "no path of scans is given: at least one is needed");
  }
  std::vector<std::unique_ptr<ScanSource>> sources;
  sources.reserve(paths.size());
  for (const auto& path : paths) sources.push_back(open_scans(path, options));
  if (sources.size() == 1) return std::move(sources.front());
  return std::make_unique<ScanSequence>(std::move(sources));
}

ScanRange::Iterator ScanRange::begin() {
  if (begun_) {
    throw Error(ErrorKind::usage,
                "a pass over the scans has begun already: rewind() allows another one");
  }
  begun_ = true;
  advance();
  return Iterator(this);
}

void ScanRange::rewind() {
  source_->rewind();
  begun_ = false;
  at_end_ = false;
}

void ScanRange::advance() {
  assert(!at_end_);
  at_end_ = !source_->next(scan_);
}

ScanRange read_scans(const std::filesystem::path& path, const ScanReadOptions& options) {
  return ScanRange(open_scans(path, options));
}

ScanRange read_scan_sequence(const std::vector<std::filesystem::path>& paths,
                             const ScanReadOptions& options) {
  return ScanRange(open_scan_sequence(paths, options));
}

}  // namespace rmap
