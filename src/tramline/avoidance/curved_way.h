#pragma once
// One way past what stands in a curved track: a detour on one side, or the reason why there is none.

#include "tramline/avoidance/way_round.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// A curved track, and a gap in it that hard land makes.
struct CurvedObstruction {
  const Track& track;
  std::size_t gap = 1;  ///< between stretches gap − 1 and gap
  double width_m = 0;
  double radius_m = 0;       ///< the machine's turning radius
  std::size_t last_gap = 0;  ///< where one detour is to bridge several gaps, the last; 0: just `gap`
};

/// The hazards that reach into the swath of the track between two positions along it.
std::vector<std::size_t> hazards_in(const Track& track, double width_m, Interval range,
                                    const Surroundings& around);

/// As way_round() for straight tracks: round what reaches into the swath in the gaps and everything the
/// detour would meet on its way. `around` in the field's frame; so is the detour's path, whose ends are
/// positions along the track. Radius max(r, w/2) at least.
WayRound curved_way_round(const CurvedObstruction& obstruction, Passing side, const Surroundings& around);

}  // namespace tramline
