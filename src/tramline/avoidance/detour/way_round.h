#pragma once
// One way past an obstruction of a track: a detour on one side, or the reason why there is none.

#include "tramline/avoidance/obstacles/surroundings.h"
#include "tramline/avoidance/refusal.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// A track and a gap in it made by hard land. Refers to its arguments.
struct Obstruction {
  const StripGrid& grid;  ///< of the track's family
  const Track& track;
  std::size_t gap = 1;       ///< between stretches gap − 1 and gap
  double radius_m = 0;       ///< the machine's turning radius
  std::size_t last_gap = 0;  ///< last gap where one detour is to bridge several; 0: just `gap`
};

struct WayRound {
  TrackDetour detour;                ///< obstacles are not filled in
  std::vector<std::size_t> hazards;  ///< driven round, ascending
  std::size_t first_gap = 1;         ///< the detour bridges first_gap … last_gap
  std::size_t last_gap = 1;
  Refusal why_not = Refusal::kNone;
  bool possible() const { return why_not == Refusal::kNone; }
};

/// Index of the stretch that contains a position along; the number of stretches where none does.
std::size_t stretch_at(const Intervals& stretches, double along);

/// Indices of the hazards that reach into the track's swath between two positions along. `around` in the
/// plane of the grid.
std::vector<std::size_t> hazards_in(const StripGrid& grid, const Track& track, Interval range,
                                    const Surroundings& around);

/// The drivable detour on one side (left or right of the direction along), round everything that reaches into
/// the swath in the gaps or that the detour would run into. `around` in the plane of the grid. Radius at
/// least max(r, w/2).
WayRound way_round(const Obstruction& obstruction, Passing side, const Surroundings& around);

}  // namespace tramline
