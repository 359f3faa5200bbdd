#include "arguments.hpp"
#include "help.hpp"
#include "json.hpp"
#include "output.hpp"
#include "query.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <rmap/cells.hpp>
#include <rmap/multiresolution.hpp>

namespace rmap::command {

namespace {

constexpr double kGrowth = 0.05;

struct CellsArguments {
  std::shared_ptr<QueryArguments> shared;
  std::optional<Box> box;
  std::optional<Sphere> sphere;
  bool occupied_only = false;
  std::optional<Vector3d> center;
  std::optional<double> growth;
  std::optional<double> fine;
  Criterion criterion = Criterion::mean;
};

class CellPrinter {
 public:
  explicit CellPrinter(bool json) : json_(json) {}

  void print(const Vector3d& center, double size, double probability, State state) {
    if (json_) {
      print_json_line({{"center", json_of(center)},
                       {"size", size},
                       {"probability", probability},
                       {"state", word_of(state)}});
    } else {
      table_.row(fmt::format("{:>12.6g} {:>12.6g} {:>12.6g} {:>10.6g}  {:>11.6f}  {}\n", center.x(),
                             center.y(), center.z(), size, probability, word_of(state)));
    }
  }

 private:
  bool json_;
  Table table_{
      fmt::format("{:>12} {:>12} {:>12} {:>10}  probability  state\n", "x", "y", "z", "size")};
};

void print_single_cells(const Grid& grid, const CellsArguments& arguments) {
  CellPrinter printer(arguments.shared->json);
  const CellSelection selection{
      .box = arguments.box, .sphere = arguments.sphere, .occupied_only = arguments.occupied_only};
  for (const auto& [cell, value] : cells(grid, selection)) {
    printer.print(grid.lattice().center(cell), grid.lattice().resolution(), probability_of(value),
                  grid.rule().occupied(value) ? State::occupied : State::free);
  }
}

// Small cubes near the centre and large ones far away, as a robot looks at its world.
void print_multiresolution(const Grid& grid, const CellsArguments& arguments) {
  const double growth = arguments.growth.value_or(kGrowth);
  const double fine = arguments.fine.value_or(0);
  const Vector3d& center = *arguments.center;
  const auto edge_in = [&](const Box& place) {
    const double distance = (place.nearest(center) - center).norm();
    // Also for an endless growth the cell at the centre stays single.
    return distance > fine ? growth * (distance - fine) : 0;
  };
  CellPrinter printer(arguments.shared->json);
  const double threshold = grid.options().occupied_threshold;
  for (const QueryCuboid& cuboid : cells_at(grid, edge_in)) {
    const double probability = arguments.criterion == Criterion::mean ? cuboid.mean : cuboid.max;
    const State state = probability > threshold ? State::occupied : State::free;
    if (arguments.occupied_only && state != State::occupied) continue;
    const Box box = grid.lattice().metric(cuboid.box);
    printer.print((box.min + box.max) / 2, box.max.x() - box.min.x(), probability, state);
  }
}

void run(const CellsArguments& arguments) {
  if (arguments.center && (arguments.box || arguments.sphere)) {
    throw UsageError("--center cannot go with --box or --sphere: it asks for the whole map");
  }
  if (!arguments.center && (arguments.growth || arguments.fine)) {
    throw UsageError("--growth and --fine need --center: cells grow with the distance from it");
  }
  for (const auto& [name, number] :
       {std::pair("--growth", arguments.growth), std::pair("--fine", arguments.fine)}) {
    if (number && !(*number >= 0)) {
      throw UsageError(fmt::format("{} is {}: it must be at least 0", name, *number));
    }
  }
  if (arguments.box) require_volume("--box", *arguments.box);
  const Grid grid = load_map(*arguments.shared);
  if (arguments.center) {
    print_multiresolution(grid, arguments);
  } else {
    print_single_cells(grid, arguments);
  }
}

}  // namespace

void add_cells_query(CLI::App& query, const std::shared_ptr<QueryArguments>& shared) {
  CLI::App& verb =
      *query.add_subcommand("cells", "List cells: of a region, or near fine and far coarse.");
  const auto arguments = std::make_shared<CellsArguments>();
  arguments->shared = shared;
  set_help(
      verb,
      {.usage = "[options]",
       .text = {"Existing cells with centre, edge (size), probability and state, along the Morton "
                "curve. With --box and --sphere both must hold.",
                "With --center the cells of the whole map are gathered into cubes of 1, 2, 4, ... "
                "cells: the edge of a cube is at most --growth times the distance of its nearest "
                "point from the centre, so that the cells at the centre stay single. 0.05 shows "
                "the world as fine as a twentieth of the distance. Cubes without a cell are left "
                "out; they are free by assumption."},
       .examples = {"rmap query street.rmap cells --sphere 0,0,1,5 --occupied",
                    "rmap query street.rmap cells --center 0,0,1 --fine 5 --growth 0.1 --json"}});
  add_box(verb, "--box", arguments->box, "Cells that this box x0,y0,z0,x1,y1,z1 (m) overlaps.");
  add_sphere(verb, "--sphere", arguments->sphere,
             "Cells that come nearer to X,Y,Z than the radius R, metres.");
  verb.add_flag("--occupied", arguments->occupied_only, "Occupied cells only.");
  add_vector(verb, "--center", arguments->center, "Where the finest cells are wanted, metres.");
  add_number(verb, "--growth", arguments->growth,
             fmt::format("Largest edge of a cube at a distance, as share of the distance (default "
                         "{}).",
                         kGrowth));
  add_number(verb, "--fine", arguments->fine,
             "Within this distance from the centre cells stay single, and the growth counts from "
             "there, metres (default 0).");
  add_word(verb, "--criterion", arguments->criterion,
           "Probability of a cube with --center: " + word_list<Criterion>() +
               " of its cells (default mean).");
  add_json_flag(verb, shared->json);
  verb.callback([arguments] { run(*arguments); });
}

}  // namespace rmap::command
