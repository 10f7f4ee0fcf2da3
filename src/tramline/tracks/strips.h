#pragma once
// The strips of one subfield, and where each may be driven straight on.

#include <vector>

#include "tramline/geometry/cross_section.h"
#include "tramline/tracks/end_rule.h"

namespace tramline {

/// The ground of a field in the turned plane of one grid.
struct TurnedGround {
  Region hard;  ///< obstacles and given-up land
  Region passable;
  Region field;     ///< the field's outer ring where it is hard, else empty
  Region beyond{};  ///< entered by no swath, and no stop either: it is not of the field
};

/// One strip of a grid. Positions are coordinates along the grid's direction.
struct Strip {
  int index = 0;
  StripProfile subfield;
  StripProfile hard;
  Intervals by_hard;      ///< where anything hard reaches into the strip
  Intervals by_passable;  ///< where a passable obstacle does
  Intervals stretches;    ///< what the end rule allows, less what is hard or beyond a hard boundary
};

struct Strips {
  StripGrid grid;
  std::vector<Strip> strips;  ///< by index
};

/// `turned` is the subfield in the grid's plane. O(n + K log K) for n edges and K incidences of edges
/// and strips.
Strips strips_of(const StripGrid& grid, const Polygon& turned, const TurnedGround& ground,
                 const EndCriterion& criterion);

/// Only those of the range that are wanted.
Strips strips_of(const StripGrid& grid, StripRange range, const StripMask& wanted, const Polygon& turned,
                 const TurnedGround& ground, const EndCriterion& criterion);

/// The same from the subfield's profiles, by k − range.first; those not wanted are not looked at.
Strips strips_of(const StripGrid& grid, StripRange range, const StripMask& wanted,
                 std::vector<StripProfile> subfield, const TurnedGround& ground,
                 const EndCriterion& criterion);

/// Whether a piece that ends at `end` and runs towards it in the sense (+1: along, −1: against) ends in
/// a stop: the first millimetre beyond meets something hard, on average over more than half the width
/// tolerance.
bool stops_at(const Strip& strip, double end, int sense);

}  // namespace tramline
