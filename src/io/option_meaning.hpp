#pragma once

#include <filesystem>
#include <string_view>

#include <rmap/scan_read_options.hpp>

namespace rmap {

/// Error(usage) when an option was given that has no meaning for what lies at `path`, so that
/// nobody takes it for obeyed. `what` names it with its flag, as in "columns (--columns)".
void refuse_option(bool given, std::string_view what, const std::filesystem::path& path,
                   std::string_view why);

/// The same for all that only bags have; `path` is none.
void refuse_bag_options(const std::filesystem::path& path, const BagReadOptions& options);

/// The same for names of columns, unless `file`, of what lies at `path`, is a `.bin` file.
void refuse_columns(const std::filesystem::path& path, const std::filesystem::path& file,
                    const ScanReadOptions& options);

/// The same for a pose or an origin or end points, which lone files of points need.
void refuse_place_of_lone_file(const std::filesystem::path& path, const ScanReadOptions& options,
                               std::string_view why);

/// The same for poses in a file of their own, and their times.
void refuse_trajectory(const std::filesystem::path& path, const ScanReadOptions& options,
                       std::string_view why);

/// The same for times without the trajectory that they belong to.
void refuse_lone_times(const std::filesystem::path& path, const ScanReadOptions& options);

}  // namespace rmap
