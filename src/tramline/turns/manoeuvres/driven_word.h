#pragma once
// From a word of turns and lines to the manoeuvre that drives it.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tramline/model/manoeuvre.h"
#include "tramline/turns/manoeuvres/turn_curve.h"

namespace tramline {

/// A turn by an angle, or a line of a length.
struct WordPart {
  char letter = 'S';  ///< L, R or S
  double amount = 0;  ///< ≥ 0; rad of a turn, m of a line
  Gear gear = Gear::kForward;
};
using Word = std::vector<WordPart>;

/// The word driven from a pose. Parts without amount are left out, and neighbours of one letter and gear are
/// one (turns only where the curvature changes at once). Nothing where a turn cannot be driven (turn_from()).
std::optional<Manoeuvre> driven(const Pose& from, const Word& word, const TurnCurves& curves,
                                ManoeuvreKind kind);

/// Puts the shortest first. Lengths that are equal but for rounding keep their order.
void sort_by_length(std::vector<Manoeuvre>& manoeuvres);
/// Leaves out what repeats one before it: the same word, stretch by stretch.
void drop_repeated(std::vector<Manoeuvre>& manoeuvres);

}  // namespace tramline
