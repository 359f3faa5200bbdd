#pragma once

#include "mappers/contest.hpp"

namespace rmap::bench {

/// Asks maps of one sequence the same questions, interleaved, several times. The first is
/// the reference. Returns the figures in the order of the maps.
std::vector<AnswerFigures> ask(const std::vector<const MapAnswers*>& maps,
                               const std::vector<Cell>& occupied, const Sequence& sequence,
                               double resolution);

}  // namespace rmap::bench
