#include "io/bag/metadata.hpp"

#include "io/bag/yaml_reader.hpp"
#include "io/input_file.hpp"
#include "io/memory.hpp"
#include "io/text.hpp"

#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

// Those of bags with a thousand files and topics are a tenth of it.
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 20;
constexpr const char* kRoot = "rosbag2_bagfile_information";
constexpr const char* kFiles = "relative_file_paths";

Error problem(const std::filesystem::path& file, std::string_view text) {
  return {ErrorKind::input, fmt::format("{}: {}", file.string(), text)};
}

std::string text_of(const std::filesystem::path& path) {
  InputFile file(path);
  if (file.size() > kMostBytes) {
    throw Error(ErrorKind::limit, fmt::format("{} has {} bytes, and {} are allowed", path.string(),
                                              file.size(), kMostBytes));
  }
  return std::string(as_text(file.read_rest()));
}

std::vector<std::string> listed_files(const std::filesystem::path& file) {
  const std::string text = text_of(file);
  YamlReader yaml(file, text);
  std::optional<std::vector<std::string>> files;
  if (yaml.enter_value(kRoot) && yaml.enter_value(kFiles)) files = yaml.read_texts();
  yaml.finish();
  if (!files) {
    throw problem(file, fmt::format("the files of the bag are missing: there must be a list {} of "
                                    "their names in {}",
                                    kFiles, kRoot));
  }
  return *std::move(files);
}

}  // namespace

std::vector<std::filesystem::path> read_bag_files(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kMetadataName;
  const auto listed = with_memory_for(file, [&] { return listed_files(file); });
  if (listed.empty()) throw problem(file, "the bag has no files: one at least is needed");
  std::vector<std::filesystem::path> files;
  for (const std::string& path : listed) {
    const std::filesystem::path name = std::filesystem::path(path).filename();
    if (name.empty() || name == "." || name == "..") {
      throw problem(file, fmt::format("{} is no name of a file", in_quotes(path)));
    }
    if (name.extension() == ".zstd") {
      throw problem(file, fmt::format("{} is compressed as a whole: zstd -d --rm unpacks it; then "
                                      "take the ending .zstd off its name here",
                                      in_quotes(path)));
    }
    files.push_back(folder / name);
  }
  return files;
}

}  // namespace rmap
