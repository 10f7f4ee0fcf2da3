#pragma once
// The limits of a pass and of the circle that the machine turns on.

#include <vector>

#include "tramline/geometry/offset/offset_rings.h"
#include "tramline/headland/pass_boundaries.h"

namespace tramline {

/// The land that the centre line of a pass may use, and the machine's turning circle.
struct TurningRoom {
  std::vector<OffsetBoundary> offset_boundaries;  ///< by boundary, at the pass's distance
  std::vector<OffsetDisc> discs;  ///< of the turning radius, at corners that the pass swings wide round
  double radius_m = 0;            ///< of the turning circle
};

/// The turning room of pass `number` round all of the boundaries.
TurningRoom turning_room(const std::vector<Boundary>& boundaries, double width_m, int number,
                         double radius_m);

/// The offset lines of the boundaries, where the pass would run if it could follow every corner that goes
/// into the land's edge: lines and arcs that turn to the right, none tighter than the radius.
std::vector<OffsetRing> offset_lines(const TurningRoom& land);

/// The boundary of the land where the turning circle's centre may be so that the whole circle is on the land:
/// the circle's far side draws the pass.
std::vector<OffsetRing> turning_centres(const TurningRoom& land);

}  // namespace tramline
