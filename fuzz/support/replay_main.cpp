// Runs a target over the files and folders that are named: what a build without libFuzzer has in
// the place of its main. A finding ends the process, as it does there.
#include "support/input.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace {

std::vector<std::filesystem::path> inputs_at(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  // A folder that lost its files must not pass for one whose files are all in order.
  if (files.empty()) throw std::runtime_error(path.string() + " is empty");
  return files;
}

void replay(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot open " + file.string());
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  // Flushed, so that the last line names the input of a finding.
  std::printf("%s, %zu bytes\n", file.c_str(), bytes.size());
  std::fflush(stdout);
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::size_t inputs = 0;
    for (int i = 1; i < argc; ++i) {
      for (const auto& file : inputs_at(argv[i])) {
        replay(file);
        ++inputs;
      }
    }
    if (inputs == 0) throw std::runtime_error("no input is named: give files or folders of them");
    std::printf("%zu inputs, no finding\n", inputs);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "replay: %s\n", error.what());
    return 1;
  }
}
