#include "evaluation/machine.hpp"

#include "evaluation/map_under_test.hpp"

#include <chrono>
#include <fstream>
#include <string>
#include <thread>

#include <fmt/chrono.h>

namespace rmap::evaluation {

namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

Json describe_machine() {
  const std::string octomap = octomap_version();
  const std::string build = RMAP_EVALUATION_BUILD;
  return {{"date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::chrono::system_clock::now()))},
          {"processor", processor()},
          {"cores", std::thread::hardware_concurrency()},
          {"compiler", RMAP_EVALUATION_COMPILER},
          {"build", build.empty() ? "development" : build},
          {"rmap", RMAP_VERSION},
          {"octomap", octomap.empty() ? Json(nullptr) : Json(octomap)}};
}

}  // namespace rmap::evaluation
