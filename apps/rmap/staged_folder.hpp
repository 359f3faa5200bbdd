#pragma once

#include <filesystem>

#include <rmap/function_ref.hpp>

namespace rmap::command {

/// A folder that is filled completely or not at all: files are first put into a hidden
/// folder inside it, which holds them until publish() and is removed otherwise.
class StagedFolder {
 public:
  /// Creates `target` where it is missing. Throws Error(io) when that cannot be done.
  explicit StagedFolder(std::filesystem::path target);
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;
  ~StagedFolder();

  /// write(staging) puts files into the hidden folder. An Error of it is thrown on with the
  /// target's name in place of the hidden one, which means nothing to anybody.
  void fill(FunctionRef<void(const std::filesystem::path& staging)> write);

  /// Moves everything to the target, `last` at the end. Throws Error(input), with nothing
  /// moved, when the target holds one of the names already.
  void publish(const std::filesystem::path& last);

 private:
  std::filesystem::path target_;
  std::filesystem::path staging_;
  bool created_target_ = false;
};

/// Throws Error(input) when `folder` holds scans (`.bin`, `.pcd`) or poses already: new
/// ones beside them would pass for one sequence.
void check_no_scans(const std::filesystem::path& folder);

}  // namespace rmap::command
