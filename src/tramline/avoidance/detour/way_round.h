#pragma once
// One way past what stands in a track: a detour on one side, or the reason why there is none.

#include "tramline/avoidance/obstacles/surroundings.h"
#include "tramline/avoidance/refusal.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// A track, and a gap in it that hard land makes. Refers to its arguments.
struct Obstruction {
  const StripGrid& grid;  ///< of the track's family
  const Track& track;
  std::size_t gap = 1;       ///< between stretches gap − 1 and gap
  double radius_m = 0;       ///< the machine's turning radius
  std::size_t last_gap = 0;  ///< where one detour is to bridge several gaps, the last; 0: just `gap`
};

struct WayRound {
  TrackDetour detour;                ///< obstacles are not filled in
  std::vector<std::size_t> hazards;  ///< driven round, ascending
  std::size_t first_gap = 1;         ///< the detour bridges first_gap … last_gap
  std::size_t last_gap = 1;
  Refusal why_not = Refusal::kNone;
  bool possible() const { return why_not == Refusal::kNone; }
};

/// The stretch that contains a position along, or as many as there are stretches.
std::size_t stretch_at(const Intervals& stretches, double along);

/// The hazards that reach into the track's swath between two positions along. `around` in the plane of the
/// grid.
std::vector<std::size_t> hazards_in(const StripGrid& grid, const Track& track, Interval range,
                                    const Surroundings& around);

/// The drivable detour on one side (left or right of the direction along): round what reaches into the
/// swath in the gaps and everything the detour would meet on its way. `around` in the plane of the grid.
/// Radius max(r, w/2) at least.
WayRound way_round(const Obstruction& obstruction, Passing side, const Surroundings& around);

}  // namespace tramline
