#pragma once
// The part of a region in the cross-sections of a track's swath, straight or curved.

#include <utility>
#include <variant>

#include "tramline/geometry/profile/path_profile.h"
#include "tramline/geometry/strip/cross_section.h"

namespace tramline {

/// Positions are those of the track (track.h). Default constructed: no part of the region lies in the swath.
class TrackProfile {
 public:
  TrackProfile() = default;
  explicit TrackProfile(StripProfile straight) : profile_(std::move(straight)) {}
  explicit TrackProfile(PathProfile curved) : profile_(std::move(curved)) {}

  bool empty() const;
  /// Precondition: of a straight track.
  const StripProfile& straight() const;

  /// The stretches in which at least `least_m` (> 0) of the cross-section is inside.
  Intervals where_at_least(double least_m) const;
  /// The stretches in which the track itself is inside.
  Intervals centre_inside() const;
  /// Area of the region within the swath between two positions, m².
  double area_between(double from, double to) const;

 private:
  std::variant<StripProfile, PathProfile> profile_;
};

}  // namespace tramline
