#pragma once

#include "mappers/contest.hpp"

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace rmap::bench {

/// Where and of what the figures are.
struct Setting {
  std::string machine;
  std::string compiler;
  std::string rmap;
  std::string octomap;
  std::string openvdb;  ///< empty when the program was built without
  std::string date;
  std::string command;
};
Setting setting_of(int argc, const char* const* argv);

struct Results {
  Setting setting;
  std::vector<Case> cases = {};
  std::vector<Growth> growth = {};
};

nlohmann::json to_json(const Results& results);
std::string to_markdown(const Results& results);

}  // namespace rmap::bench
