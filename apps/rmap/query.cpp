#include "query.hpp"

#include "arguments.hpp"
#include "help.hpp"
#include "map_files.hpp"
#include "verbs.hpp"

namespace rmap::command {

Grid load_map(const QueryArguments& arguments) {
  if (arguments.map.empty()) {
    throw UsageError("MAP is missing: `rmap query MAP VERB ...` (see rmap query --help)");
  }
  return load_map(arguments.map, LoadOptions{});
}

void add_query(CLI::App& app) {
  CLI::App& verb = *app.add_subcommand("query", "Ask a map about places.");
  const auto shared = std::make_shared<QueryArguments>();
  set_help(
      verb,
      {.usage = "MAP VERB ...",
       .text = {"States: occupied; free: the cell exists, a beam once ended in it, and it is "
                "not occupied; assumed_free: no beam ever ended there, and nobody may have "
                "looked.",
                "Answers are a table, or with --json one object a line. Lists of requests come "
                "from a file, or with --from - from standard input: one request a line, numbers "
                "separated by commas or blanks, # for comments. An argument that begins with "
                "-. or -inf needs a -- before it."},
       .examples = {"rmap query street.rmap point 4.2,0,1.1 0,0,0.5",
                    "rmap query street.rmap box 4,-1,0,6,1,2 --json"}});
  add_path(verb, "MAP", shared->map, "The map, a .rmap file.");
  add_json_flag(verb, shared->json);
  verb.require_subcommand(1);
  add_point_query(verb, shared);
  add_box_query(verb, shared);
  add_cast_query(verb, shared);
  add_cells_query(verb, shared);
}

}  // namespace rmap::command
