#pragma once
// The rules a plan is judged by, one file each: rule_<name>.cpp. Every function appends what it finds.

#include <vector>

#include "tramline/check/boxed.h"
#include "tramline/check/verdict.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// A plan with what several rules need of it. Refers to the plan, which has to outlive it.
struct Case {
  explicit Case(const Plan& of);

  const Plan& plan;
  BoxedRegion obstacles;  ///< those the machine may not enter
  BoxedRegion passables;
  BoxedRegion given_up;
  double area_tolerance_m2;  ///< 1e-6 of the field's area, not below what the precision grid can do
};
using Violations = std::vector<Violation>;

/// Every polygon is one: at least three vertices, on the map, not crossing itself.
void check_shapes(const Plan& plan, Violations& out);
/// Pieces have distinct ends on the map, belong to a subfield and run along its direction.
void check_pieces(const Plan& plan, Violations& out);
/// The body is the field less obstacles, passable ones too; land given up lies within it.
void check_body(const Case& c, Violations& out);
/// Subfields part the body less land given up, plus passables, without overlapping.
void check_subfields(const Case& c, Violations& out);
/// No swath enters an obstacle, a passable, land given up, nor crosses a hard boundary.
void check_swaths(const Case& c, Violations& out);
/// Each piece obeys the end rule over its whole length.
void check_ends(const Case& c, Violations& out);
/// No piece is too short to drive, but for those between crossings.
void check_length(const Case& c, Violations& out);
/// A piece is flagged as ending in a stop where the first millimetre beyond it meets an obstacle or
/// land given up, and nowhere else. Returns the number of stops found.
int check_stops(const Case& c, Violations& out);
/// A piece after a crossing goes on in line beyond a passable, with nothing else in the gap.
void check_crossings(const Case& c, Violations& out);
/// The stored tally, cost and layers agree with the tracks. `stops` is what check_stops found.
/// Returns the recomputed tally.
Tally check_tally(const Case& c, int stops, Violations& out);

/// "piece 12": pieces are numbered for people from 1, in driving order.
std::string piece_name(std::size_t index);

/// A vertex of the polygon of largest area; the origin for an empty region.
Point place_on_largest(const Region& region);

}  // namespace tramline::check
