#pragma once
// How near a drive kept to the tracks that were planned, and whether it followed them at all.

#include <limits>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/model/coverage.h"
#include "tramline/model/plan.h"

namespace tramline::coverage {

/// What is driven at work within half a working width of a planned track or headland pass follows it where
/// its direction differs from the track's there by no more than this.
inline constexpr Angle kAlongTrack = Angle::degrees(15);
/// A drive followed the plan where at least this share of its way at work did.
inline constexpr double kFollowedShare = 0.5;

/// Looked at step by step and weighted by the way driven, m. NaN: there was nothing to measure.
struct Deviation {
  double along_m = 0;   ///< way at work that followed a track or headland pass
  double beside_m = 0;  ///< way at work that followed none

  // Of the way that followed one: its distance from the nearest that it followed.
  double mean_m = 0;
  double p95_m = 0;  ///< for 95 % of that way it is no more than this
  double most_m = 0;

  // Of all the way at work, against the nearest track or pass whether it was followed or not.
  double median_distance_m = std::numeric_limits<double>::quiet_NaN();
  double median_angle_deg = std::numeric_limits<double>::quiet_NaN();  ///< between the directions, 0 to 90

  double followed_share() const;  ///< along / (along + beside); 0 where nothing was worked
  bool followed() const { return followed_share() >= kFollowedShare; }
};

/// Frame: the plan's field's. Looked at from fix to fix, at the middle of each step. O(steps · tracks near
/// them).
Deviation deviation(const Plan& plan, const std::vector<DrivenLine>& lines);

}  // namespace tramline::coverage
