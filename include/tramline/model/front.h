#pragma once
// The Pareto front of one field: plans that trade overlap, uncovered land, turns and stops against one
// another, none of them better than another in everything.

#include <cstddef>
#include <string_view>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/model/objective.h"
#include "tramline/model/tally.h"

namespace tramline {

/// One plan of a front.
struct FrontPoint {
  Tally tally;
  std::vector<Direction> directions;  ///< by subfield
  Objective laid_for;                 ///< ends of swaths and ways past obstacles were chosen at these prices
  double cost = 0;                    ///< at the prices of the front
};

/// The notable plans of a front, as indices into Front::points. Among equals the plan that costs least at the
/// prices of the front counts, then the first.
struct FrontMarks {
  std::size_t least_overlap = 0;
  std::size_t least_uncovered = 0;
  std::size_t fewest_turns = 0;  ///< turns and stops together
  std::size_t knee = 0;          ///< see knee_of() in planner/pareto/front_marks.h
  std::size_t given_prices = 0;  ///< the cheapest at the prices of the front
};

/// The points ascend in overlap, then in uncovered land, turns and stops. Empty: no front was asked for.
struct Front {
  Objective prices;
  std::vector<FrontPoint> points;
  FrontMarks marks;
};

/// Turns and stops together: how often the machine interrupts its work.
constexpr int turns_and_stops(const Tally& tally) { return tally.turns + tally.stops; }

/// The marks of a point as words for people: "least overlap", "knee"; empty for most points.
std::vector<const char*> marks_of(const Front& front, std::size_t point);

/// The mark that marks_of() has this word for; nullptr for any other.
std::size_t* mark_named(FrontMarks& marks, std::string_view word);

/// The indices of the marked points, ascending, each once. Empty for an empty front.
std::vector<std::size_t> marked_points(const Front& front);

}  // namespace tramline
