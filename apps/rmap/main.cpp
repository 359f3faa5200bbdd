#include "arguments.hpp"
#include "help.hpp"
#include "output.hpp"
#include "signals.hpp"
#include "verbs.hpp"

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include <CLI/CLI.hpp>

#include <rmap/error.hpp>

namespace rmap::command {

namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kUsage = 2;

void add_verbs(CLI::App& app) {
  app.name("rmap");
  app.description("rmap maps for robots: range scans with poses become 3D occupancy maps.");
  set_help(app,
           {.usage = "VERB ...",
            .text = {"All space is free until a beam ends in it: a map holds only the cells in "
                     "which beams ended, in an R-tree. `rmap VERB --help` explains a verb. "
                     "Lengths are metres, probabilities lie in 0 to 1.",
                     "Exit codes: 0 done; 1 the input or the request is wrong, which one "
                     "sentence on standard error explains; 2 the command line makes no sense; "
                     "129, 130 and 143 interrupted by SIGHUP, SIGINT and SIGTERM. A file is "
                     "written as a whole or not at all."},
            .examples = {"rmap simulate street --scans 3 -o street",
                         "rmap build street -o street.rmap --resolution 0.1",
                         "rmap info street.rmap", "rmap query street.rmap point 4.2,0,1.1"}});
  app.set_version_flag("--version", "rmap " RMAP_VERSION, "Show the version.");
  app.require_subcommand(1);
  add_simulate(app);
  add_build(app);
  add_info(app);
  add_query(app);
  add_compare(app);
  add_merge(app);
  add_convert(app);
  add_approximate(app);
  add_evaluate_cuboids(app);
  add_validate(app);
  add_repair(app);
  add_evaluate(app);
}

int complain(int exit_code, const char* sentence) {
  std::fprintf(stderr, "rmap: %s\n", sentence);
  return exit_code;
}

// The parser's reason, in the words of this command, and where to read on.
std::string usage_sentence(const CLI::App& app, const CLI::ParseError& error) {
  std::string verb = "rmap";
  bool verb_missing = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  for (const CLI::App* part = &app; !part->get_subcommands().empty();) {
    part = part->get_subcommands().back();
    verb += " " + part->get_name();
    verb_missing = verb_missing && part->get_require_subcommand_min() > 0;
  }
  std::string reason = error.what();
  if (verb_missing) {
    // What is no verb is left over as an argument.
    const auto left = app.remaining(true);
    reason = left.empty() ? "a verb is missing" : "\"" + left.front() + "\" is no verb";
  }
  return reason + " (see " + verb + " --help)";
}

int run(int argc, const char* const* argv) {
  install_signal_handlers();
  CLI::App app;
  try {
    add_verbs(app);
    try {
      app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
      print(app.help());
    } catch (const CLI::CallForVersion& version) {
      print(std::string(version.what()) + "\n");
    }
    flush_output();
    return kDone;
  } catch (const CLI::ParseError& error) {
    return complain(kUsage, usage_sentence(app, error).c_str());
  } catch (const UsageError& error) {
    return complain(kUsage, error.what());
  } catch (const Interrupted& interrupted) {
    return interrupted.exit_code;
  }
}

}  // namespace

}  // namespace rmap::command

int main(int argc, char** argv) {
  using namespace rmap::command;
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    return complain(kFailed, "there is not enough memory");
  } catch (const std::exception& error) {
    return complain(kFailed, error.what());
  }
}
