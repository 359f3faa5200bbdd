#pragma once

#include <CLI/CLI.hpp>

namespace rmap::command {

// Each adds a verb with its options and help. The verb runs when the command line has
// been read as a whole; it throws UsageError for a call that makes no sense and Error
// for everything that cannot be done.

void add_build(CLI::App& app);
void add_info(CLI::App& app);
void add_query(CLI::App& app);
void add_merge(CLI::App& app);
void add_convert(CLI::App& app);
void add_compare(CLI::App& app);
void add_simulate(CLI::App& app);
void add_approximate(CLI::App& app);
void add_evaluate(CLI::App& app);
void add_evaluate_cuboids(CLI::App& app);
void add_validate(CLI::App& app);
void add_repair(CLI::App& app);

}  // namespace rmap::command
