#pragma once
// The deviation of a drive from the planned tracks, and whether the drive followed them at all.

#include <limits>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/model/coverage.h"
#include "tramline/model/plan.h"

namespace tramline::coverage {

/// A step at work within half a working width of a planned track or headland pass follows it if its direction
/// differs from the track's there by no more than this.
inline constexpr Angle kAlongTrack = Angle::degrees(15);
/// A drive followed the plan if at least this share of its distance at work did.
inline constexpr double kFollowedShare = 0.5;

/// Computed step by step and weighted by the distance driven, m. NaN: there was nothing to measure.
struct Deviation {
  double along_m = 0;   ///< distance at work that followed a track or headland pass
  double beside_m = 0;  ///< distance at work that followed none

  // For the steps that followed a track or pass: the distance from the nearest one that they followed.
  double mean_m = 0;
  double p95_m = 0;  ///< for 95 % of these steps by length the distance is no more than this
  double most_m = 0;

  // For all steps at work: relative to the nearest track or pass, whether followed or not.
  double median_distance_m = std::numeric_limits<double>::quiet_NaN();
  double median_angle_deg = std::numeric_limits<double>::quiet_NaN();  ///< between the directions, 0 to 90

  double followed_share() const;  ///< along / (along + beside); 0 where nothing was worked
  bool followed() const { return followed_share() >= kFollowedShare; }
};

/// Frame: that of the plan's field. Evaluated from fix to fix, at the middle of each step. O(steps · tracks
/// near them).
Deviation deviation(const Plan& plan, const std::vector<DrivenLine>& lines);

}  // namespace tramline::coverage
