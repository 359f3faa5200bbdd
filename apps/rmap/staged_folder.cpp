#include "staged_folder.hpp"

#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap::command {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* doing, const fs::path& path, const std::error_code& code) {
  throw Error(ErrorKind::io, fmt::format("cannot {} {}: {}", doing, path.string(), code.message()));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}

void move_to(const fs::path& folder, const fs::path& file) {
  std::error_code code;
  fs::rename(file, folder / file.filename(), code);
  if (code) fail("write", folder / file.filename(), code);
}

}  // namespace

StagedFolder::StagedFolder(fs::path target) : target_(std::move(target)) {
  std::error_code code;
  created_target_ = fs::create_directories(target_, code);
  if (code) fail("create the folder", target_, code);
  staging_ = target_ / fmt::format(".rmap-{}.tmp", ::getpid());
  fs::create_directory(staging_, code);
  if (code) fail("create the folder", staging_, code);
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  // Removes it only while it is empty.
  if (created_target_) fs::remove(target_, ignored);
}

void StagedFolder::fill(FunctionRef<void(const fs::path& staging)> write) {
  try {
    write(staging_);
  } catch (const Error& error) {
    throw Error(error.kind(), replaced(error.what(), staging_.string(), target_.string()));
  }
}

void StagedFolder::publish(const fs::path& last) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(staging_)) {
    const fs::path name = entry.path().filename();
    if (fs::exists(fs::symlink_status(target_ / name))) {
      throw Error(ErrorKind::input, fmt::format("{} exists already: it must be another folder",
                                                (target_ / name).string()));
    }
    if (name != last) files.push_back(entry.path());
  }
  for (const fs::path& file : files) move_to(target_, file);
  move_to(target_, staging_ / last);
}

void check_no_scans(const fs::path& folder) {
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing)) {
    const std::string ending = ending_of(entry.path());
    if (ending == ".bin" || ending == ".pcd" || entry.path().filename() == "poses.txt") {
      throw Error(ErrorKind::input,
                  fmt::format("{} holds {} already: it must be a folder without scans and poses",
                              folder.string(), entry.path().filename().string()));
    }
  }
}

}  // namespace rmap::command
