#include "io/octomap_samples.hpp"

#include "io/files.hpp"

#include <gtest/gtest.h>

#include <rmap/error.hpp>

namespace rmap::test {

namespace {

template <class Call>
ErrorKind refusal(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("map.ot"), std::string::npos) << error.what();
    return error.kind();
  }
  ADD_FAILURE() << "it was taken";
  return ErrorKind::usage;
}

}  // namespace

std::string octomap_header(std::uint64_t nodes, bool states_only, const std::string& resolution,
                           const std::string& id) {
  return std::string("# Octomap OcTree ") + (states_only ? "binary " : "") +
         "file\n# (a comment)\n#\nid " + id + "\nsize " + std::to_string(nodes) + "\nres " +
         resolution + "\ndata\n";
}

std::string value_node(float log_odds, unsigned children) {
  return raw(log_odds) + static_cast<char>(children);
}

std::string values_to_zero(std::size_t levels) {
  std::string nodes;
  // Of the root the last child, of all others the first.
  for (std::size_t i = 0; i < levels; ++i) nodes += value_node(9, i == 0 ? 1U << 7 : 1U);
  return nodes;
}

std::string value_file(const std::vector<float>& log_odds) {
  std::string nodes = values_to_zero(15) + value_node(9, (1U << log_odds.size()) - 1);
  for (const float value : log_odds) nodes += value_node(value);
  return octomap_header(16 + log_odds.size(), false) + nodes;
}

OctomapImport imported(const std::string& content, const OctomapImportOptions& options) {
  const TemporaryFolder folder;
  write_text(folder / "map.ot", content);
  return import_octomap(folder / "map.ot", options);
}

ErrorKind octomap_refusal(const std::string& content) {
  const TemporaryFolder folder;
  const auto file = folder / "map.ot";
  write_text(file, content);
  const ErrorKind kind = refusal([&] { import_octomap(file, {.keep_free = true}); });
  EXPECT_EQ(refusal([&] { read_octomap(file); }), kind);
  // What is only too large can be described.
  if (kind == ErrorKind::limit) {
    EXPECT_GT(read_octomap_info(file).nodes, 0u);
  } else {
    EXPECT_EQ(refusal([&] { read_octomap_info(file); }), kind);
  }
  return kind;
}

}  // namespace rmap::test
