#include "command/command.hpp"

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace rmap::test {

namespace {

using testing::HasSubstr;

const std::vector<std::vector<std::string>> kVerbs = {
    {"simulate"},     {"build"},         {"info"},           {"query"},    {"query", "point"},
    {"query", "box"}, {"query", "cast"}, {"query", "cells"}, {"compare"},  {"merge"},
    {"convert"},      {"validate"},      {"repair"},         {"evaluate"},
};

class Examples : public CommandTest {
 protected:
  std::string help(std::vector<std::string> verb) const {
    verb.emplace_back("--help");
    return rmap_done(verb).out;
  }

  // The commands of a help text, without their `rmap`.
  static std::vector<std::vector<std::string>> examples_in(const std::string& help) {
    std::vector<std::vector<std::string>> examples;
    std::istringstream lines(help);
    bool within = false;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("Example")) {
        within = true;
      } else if (within && line.starts_with("  rmap ")) {
        std::istringstream words(line.substr(std::string("  rmap ").size()));
        examples.emplace_back(std::istream_iterator<std::string>(words),
                              std::istream_iterator<std::string>());
      }
    }
    return examples;
  }

  void run_examples(const std::vector<std::string>& verb) const {
    const auto examples = examples_in(help(verb));
    EXPECT_FALSE(examples.empty()) << testing::PrintToString(verb);
    for (const auto& example : examples) {
      SCOPED_TRACE(testing::PrintToString(example));
      rmap_done(example);
    }
  }
};

// They are written to be tried one after another.
TEST_F(Examples, OfTheCommandRun) { run_examples({}); }

TEST_F(Examples, OfEveryVerbRun) {
  for (const auto& verb : kVerbs) {
    if (verb.front() == "info") {
      std::filesystem::copy_file(folder() / "street.rmap", folder() / "yard.rmap");
    }
    run_examples(verb);
  }
}

TEST_F(Examples, HelpExplainsEachOption) {
  const std::string overview = help({});
  for (const auto& verb : kVerbs) {
    SCOPED_TRACE(testing::PrintToString(verb));
    const std::string text = help(verb);
    EXPECT_THAT(text, HasSubstr("Usage: rmap " + verb.front()));
    EXPECT_THAT(text, HasSubstr("Example"));
    EXPECT_THAT(overview, HasSubstr("\n  " + verb.front() + " "));
    // No line is too long for a terminal, but for an example that is to be copied.
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_TRUE(line.size() <= 100 || line.starts_with("  rmap ")) << line;
    }
  }
  const std::string build = help({"build"});
  for (const char* option : {"--resolution",
                             "--layout",
                             "--max-branches",
                             "--split",
                             "--prob-hit",
                             "--prob-miss",
                             "--clamp-min",
                             "--clamp-max",
                             "--prior",
                             "--occupied-threshold",
                             "--free-probability",
                             "--saturation",
                             "--beams",
                             "--min-range",
                             "--max-range",
                             "--threads",
                             "--bad-points",
                             "--history",
                             "--dry-run",
                             "--onto",
                             "--every",
                             "--crop",
                             "--ignore",
                             "--json"}) {
    EXPECT_THAT(build, HasSubstr(std::string("  ") + option)) << option;
  }
}

}  // namespace

}  // namespace rmap::test
