#include "arguments.hpp"
#include "help.hpp"
#include "json.hpp"
#include "number_lines.hpp"
#include "output.hpp"
#include "query.hpp"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <rmap/box_query.hpp>
#include <rmap/cast_ray.hpp>
#include <rmap/error.hpp>

namespace rmap::command {

namespace {

// Requests of N numbers each: those of the command line, then those of a list.
template <std::size_t N>
struct Requests {
  using Numbers = std::array<double, N>;

  std::vector<std::string> texts;  ///< of the command line
  std::filesystem::path from;
  const char* form;  ///< what a text must be

  // What is wrong on the command line is wrong usage, found before the map is loaded.
  std::vector<Numbers> parsed() const {
    if (texts.empty() && from.empty()) {
      throw UsageError(fmt::format("nothing is asked: give {}, or a list with --from", form));
    }
    std::vector<Numbers> all;
    for (const std::string& text : texts) {
      if (!parse_numbers(text, all.emplace_back())) {
        throw UsageError(fmt::format("\"{}\" is no request: it must be {}", text, form));
      }
    }
    return all;
  }

  template <class Answer>
  void answer_all(const std::vector<Numbers>& given, Answer&& answer) const {
    for (const Numbers& numbers : given) answer(numbers);
    if (from.empty()) return;
    NumberLines lines(from);
    for (Numbers numbers; lines.next(numbers);) {
      try {
        answer(numbers);
      } catch (const Error& error) {
        if (error.kind() == ErrorKind::io) throw;
        throw Error(error.kind(), lines.place() + ": " + error.what());
      }
    }
  }
};

Vector3d vector_at(std::span<const double> numbers) { return {numbers[0], numbers[1], numbers[2]}; }

void add_from(CLI::App& verb, std::filesystem::path& from) {
  add_path(verb, "--from", from, "File with one request a line; - is standard input.");
}

// --- point -------------------------------------------------------------------

struct PointArguments {
  std::shared_ptr<QueryArguments> shared;
  Requests<3> requests{.texts = {}, .from = {}, .form = "three numbers x,y,z in metres"};
};

void run_points(const PointArguments& arguments) {
  const auto given = arguments.requests.parsed();
  const Grid grid = load_map(*arguments.shared);
  const bool json = arguments.shared->json;
  Table table(fmt::format("{:>12} {:>12} {:>12}  probability  state\n", "x", "y", "z"));
  arguments.requests.answer_all(given, [&](const std::array<double, 3>& numbers) {
    const Vector3d point = vector_at(numbers);
    const State state = grid.state(point);
    const double probability = grid.point_probability(point);
    if (json) {
      print_json_line({{"point", json_of(point)},
                       {"state", word_of(state)},
                       {"probability", probability},
                       {"cell", json_of(grid.lattice().cell_of(point))}});
    } else {
      table.row(fmt::format("{:>12.6g} {:>12.6g} {:>12.6g}  {:>11.6f}  {}\n", point.x(), point.y(),
                            point.z(), probability, word_of(state)));
    }
  });
}

// --- box ---------------------------------------------------------------------

struct BoxArguments {
  std::shared_ptr<QueryArguments> shared;
  Requests<6> requests{.texts = {}, .from = {}, .form = "six numbers x0,y0,z0,x1,y1,z1 in metres"};
  Criterion criterion = Criterion::mean;
};

void run_boxes(const BoxArguments& arguments) {
  const auto given = arguments.requests.parsed();
  const Grid grid = load_map(*arguments.shared);
  const bool json = arguments.shared->json;
  Table table(fmt::format("{:>10} {:>10}  {:<8} {:>12} {:>10} {:>10}  {}\n", "mean", "max",
                          "occupied", "cells", "existing", "occupied", "box of cells"));
  arguments.requests.answer_all(given, [&](const std::array<double, 6>& n) {
    const Box box{.min = {n[0], n[1], n[2]}, .max = {n[3], n[4], n[5]}};
    const BoxOccupancy answer = box_occupancy(grid, box);
    const bool occupied = box_occupied(grid, box, arguments.criterion);
    const Box used = grid.lattice().metric(answer.box);
    if (json) {
      print_json_line({{"box", json_of(used)},
                       {"cell_box", json_of(answer.box)},
                       {"mean", answer.mean},
                       {"max", answer.max},
                       {"criterion", word_of(arguments.criterion)},
                       {"occupied", occupied},
                       {"cells", json_of_count(answer.cells)},
                       {"existing_cells", answer.existing},
                       {"occupied_cells", answer.occupied}});
    } else {
      table.row(fmt::format("{:>10.6f} {:>10.6f}  {:<8} {:>12.12g} {:>10} {:>10}  {}\n",
                            answer.mean, answer.max, occupied ? "yes" : "no", answer.cells,
                            answer.existing, answer.occupied, readable_box(used)));
    }
  });
}

// --- cast --------------------------------------------------------------------

struct CastArguments {
  std::shared_ptr<QueryArguments> shared;
  std::vector<std::string> texts;  ///< origin and direction, in turn
  std::filesystem::path from;
  double max_range = std::numeric_limits<double>::infinity();
};

void print_hit(const std::optional<RayHit>& hit, bool json, Table& table) {
  if (json) {
    Json answer{{"hit", hit.has_value()}};
    if (hit) {
      answer["distance"] = hit->distance;
      answer["point"] = json_of(hit->point);
      answer["cell"] = json_of(hit->cell);
      answer["face"] = word_of(hit->face);
    }
    print_json_line(answer);
  } else if (hit) {
    table.row(fmt::format("{:>12.6g}  {:<6} {}\n", hit->distance, word_of(hit->face),
                          in_brackets(hit->point)));
  } else {
    table.row(fmt::format("{:>12}  {:<6} {}\n", "none", "", ""));
  }
}

void run_casts(const CastArguments& arguments) {
  // Two arguments make one ray; a list has it on one line.
  Requests<6> requests{.texts = {},
                       .from = arguments.from,
                       .form = "ORIGIN and DIRECTION, three numbers x,y,z each"};
  if (arguments.texts.size() % 2 != 0) {
    throw UsageError(fmt::format("\"{}\" has no direction: each ray is {}", arguments.texts.back(),
                                 requests.form));
  }
  for (std::size_t i = 0; i < arguments.texts.size(); i += 2) {
    const Vector3d origin = vector_argument("ORIGIN", arguments.texts[i]);
    const Vector3d direction = vector_argument("DIRECTION", arguments.texts[i + 1]);
    requests.texts.push_back(fmt::format("{},{},{},{},{},{}", origin.x(), origin.y(), origin.z(),
                                         direction.x(), direction.y(), direction.z()));
  }
  const auto given = requests.parsed();
  const Grid grid = load_map(*arguments.shared);
  const bool json = arguments.shared->json;
  Table table(fmt::format("{:>12}  {:<6} {}\n", "distance", "face", "point"));
  requests.answer_all(given, [&](const std::array<double, 6>& n) {
    print_hit(cast_ray(grid, {n[0], n[1], n[2]}, {n[3], n[4], n[5]}, arguments.max_range), json,
              table);
  });
}

}  // namespace

void add_point_query(CLI::App& query, const std::shared_ptr<QueryArguments>& shared) {
  CLI::App& verb = *query.add_subcommand("point", "State and probability of points.");
  const auto arguments = std::make_shared<PointArguments>();
  arguments->shared = shared;
  set_help(verb, {.usage = "POINT... [options]",
                  .text = {"A point is asked for the cell that holds it. Where no cell exists, the "
                           "state is assumed_free and the probability the map's free_probability."},
                  .examples = {"rmap query street.rmap point 4.2,0,1.1 -3,0,0.5"}});
  add_texts(verb, "POINT", arguments->requests.texts, "Points x,y,z, metres.");
  add_from(verb, arguments->requests.from);
  add_json_flag(verb, shared->json);
  verb.callback([arguments] { run_points(*arguments); });
}

void add_box_query(CLI::App& query, const std::shared_ptr<QueryArguments>& shared) {
  CLI::App& verb = *query.add_subcommand("box", "Occupancy of whole boxes.");
  const auto arguments = std::make_shared<BoxArguments>();
  arguments->shared = shared;
  set_help(verb,
           {.usage = "BOX... [options]",
            .text = {"The occupancy of a box is the mean probability of its cells, those that do "
                     "not exist counting as free (the paper's equation 1), or the largest one. It "
                     "holds for the whole cells that the box overlaps, which the answer names; "
                     "borders within a millionth of a cell border snap to it."},
            .examples = {"rmap query street.rmap box 4,-1,0,6,1,2 --criterion max"}});
  add_texts(verb, "BOX", arguments->requests.texts, "Boxes x0,y0,z0,x1,y1,z1, metres.");
  add_word(verb, "--criterion", arguments->criterion,
           "Which number decides whether the box is occupied: " + word_list<Criterion>() +
               " (default mean).");
  add_from(verb, arguments->requests.from);
  add_json_flag(verb, shared->json);
  verb.callback([arguments] { run_boxes(*arguments); });
}

void add_cast_query(CLI::App& query, const std::shared_ptr<QueryArguments>& shared) {
  CLI::App& verb = *query.add_subcommand("cast", "The first occupied cell along rays.");
  const auto arguments = std::make_shared<CastArguments>();
  arguments->shared = shared;
  set_help(verb, {.usage = "ORIGIN DIRECTION... [options]",
                  .text = {"The answer is where the ray enters the cell, through which face, and "
                           "how far that is. A ray that starts in an occupied cell hits it at "
                           "distance 0. With --from a line is a ray: six numbers."},
                  .examples = {"rmap query street.rmap cast 0,0,1.8 1,0.3,0 --max-range 50"}});
  add_texts(verb, "RAY", arguments->texts,
            "Two arguments x,y,z each: where the ray starts, metres, and its direction, of any "
            "length but zero.");
  add_number(verb, "--max-range", arguments->max_range,
             "How far a ray reaches, metres (default inf).");
  add_from(verb, arguments->from);
  add_json_flag(verb, shared->json);
  verb.callback([arguments] { run_casts(*arguments); });
}

}  // namespace rmap::command
