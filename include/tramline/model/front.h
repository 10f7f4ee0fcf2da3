#pragma once
// The trade-off between overlap, uncovered land, turns and stops: plans of one field of which none is
// better than another in everything.

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

/// Plans that stand out, as indices into Front::points. Among equals the plan that costs least at the
/// prices of the front, then the first.
struct FrontMarks {
  std::size_t least_overlap = 0;
  std::size_t least_uncovered = 0;
  std::size_t fewest_turns = 0;  ///< turns and stops together
  std::size_t knee = 0;          ///< see knee_of() in planner/pareto/front_marks.h
  std::size_t given_prices = 0;  ///< the cheapest at the prices of the front
};

/// Ascending in overlap, then in uncovered land, turns and stops. Empty: no front was asked for.
struct Front {
  Objective prices;
  std::vector<FrontPoint> points;
  FrontMarks marks;
};

/// Turns and stops together: how often the machine leaves its work.
constexpr int turns_and_stops(const Tally& tally) { return tally.turns + tally.stops; }

/// What stands out in a point, for people: "least overlap", "knee"; empty for most points.
std::vector<const char*> marks_of(const Front& front, std::size_t point);

/// The mark that marks_of() has this word for; nullptr for any other.
std::size_t* mark_named(FrontMarks& marks, std::string_view word);

/// The points that are marked, ascending, each once. Empty where the front is.
std::vector<std::size_t> marked_points(const Front& front);

}  // namespace tramline
