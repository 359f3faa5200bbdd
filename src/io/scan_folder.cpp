#include "io/scan_folder.hpp"

#include "io/natural_order.hpp"
#include "io/point_formats.hpp"
#include "io/system_error.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

struct PosedFile {
  std::filesystem::path path;
  Pose map_from_sensor;
};

class ScanFileSource : public ScanSource {
 public:
  explicit ScanFileSource(std::vector<PosedFile> files) : files_(std::move(files)) {}

  bool next(Scan& scan) override {
    if (next_ == files_.size()) return false;
    const PosedFile& file = files_[next_++];
    scan.map_from_sensor = file.map_from_sensor;
    scan.frame = Frame::sensor;
    scan.origins.clear();
    scan.no_returns.clear();
    scan.sensor_range = std::numeric_limits<double>::infinity();
    scan.name = file.path.string();
    read_points_into(file.path, scan.points);
    return true;
  }

  void rewind() override { next_ = 0; }
  std::optional<std::size_t> size() const override { return files_.size(); }

 private:
  std::vector<PosedFile> files_;
  std::size_t next_ = 0;
};

bool is_scan_name(const std::filesystem::path& path) {
  return !path.filename().native().starts_with('.') &&
         find_point_format(ending_of(path)) != nullptr;
}

void check_regular(const std::filesystem::path& path) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (std::filesystem::is_regular_file(status)) return;
  if (code) throw system_error("open", path, code.value());
  throw Error(
      ErrorKind::input,
      fmt::format("{} is {}, and must be a regular file as its name says", path.string(),
                  std::filesystem::is_directory(status) ? "a folder" : "a pipe or a device"));
}

void check_one_format(const std::filesystem::path& folder,
                      const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) {
    if (ending_of(file) == ending_of(files.front())) continue;
    throw Error(
        ErrorKind::input,
        fmt::format("{} holds scans in two formats, {} and {} for example: one is allowed "
                    "in a folder",
                    folder.string(), files.front().filename().string(), file.filename().string()));
  }
}

std::vector<Pose> read_folder_poses(const std::filesystem::path& folder, std::size_t scans) {
  const std::filesystem::path file = folder / kPosesName;
  std::error_code code;
  if (!std::filesystem::exists(file, code) && !code) {
    throw Error(ErrorKind::input,
                fmt::format("{} is missing: it must hold one pose for each of the {} scans of {}",
                            file.string(), scans, folder.string()));
  }
  std::vector<Pose> poses = read_poses(file);
  if (poses.size() != scans) {
    throw Error(ErrorKind::input,
                fmt::format("{} holds {} poses and {} holds {} scans: there must be one pose for "
                            "each scan",
                            file.string(), poses.size(), folder.string(), scans));
  }
  return poses;
}

std::vector<PosedFile> list_posed_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths = list_scan_files(folder);
  if (paths.empty()) {
    throw Error(ErrorKind::input, fmt::format("{} holds no scans: files ending in {} are allowed",
                                              folder.string(), point_endings()));
  }
  const std::vector<Pose> poses = read_folder_poses(folder, paths.size());
  std::vector<PosedFile> files;
  files.reserve(paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    files.push_back({.path = std::move(paths[i]), .map_from_sensor = poses[i]});
  }
  return files;
}

}  // namespace

std::vector<std::filesystem::path> list_scan_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code code;
  std::filesystem::directory_iterator entry(folder, code);
  for (; !code && entry != std::filesystem::directory_iterator(); entry.increment(code)) {
    if (is_scan_name(entry->path())) files.push_back(entry->path());
  }
  if (code) throw system_error("list", folder, code.value());
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
    return natural_less(a.filename().native(), b.filename().native());
  });
  check_one_format(folder, files);
  for (const auto& file : files) check_regular(file);
  return files;
}

std::unique_ptr<ScanSource> open_scan_folder(const std::filesystem::path& folder,
                                             const ScanReadOptions& /*options*/) {
  return std::make_unique<ScanFileSource>(list_posed_files(folder));
}

std::unique_ptr<ScanSource> open_scan_file(const std::filesystem::path& file,
                                           const ScanReadOptions& /*options*/) {
  check_regular(file);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  for (PosedFile& posed : list_posed_files(folder)) {
    if (posed.path.filename() != file.filename()) continue;
    posed.path = file;
    return std::make_unique<ScanFileSource>(std::vector{std::move(posed)});
  }
  // Only a name that begins with a dot is not listed.
  throw Error(ErrorKind::input,
              fmt::format("{} is hidden: a scan's name must not begin with a dot", file.string()));
}

}  // namespace rmap
