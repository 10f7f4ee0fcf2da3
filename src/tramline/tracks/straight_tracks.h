#pragma once
// The tracks in the strips of one subfield.

#include <vector>

#include "tramline/geometry/strip/cross_section.h"
#include "tramline/tracks/end_rule.h"
#include "tramline/tracks/track.h"

namespace tramline {

/// The land of a field in the turned plane of one grid.
struct TurnedGround {
  Region hard;  ///< obstacles and given-up land
  Region passable;
  Region field;     ///< the field's outer ring where it is hard, else empty
  Region beyond{};  ///< not part of the field: no swath enters it, and an end at it is not a stop
};

/// A track for each strip that the subfield reaches into. `turned` is the subfield in the grid's plane.
/// O(n + K log K) for n edges and K incidences of edges and strips.
TrackFamily straight_tracks(const StripGrid& grid, const Polygon& turned, const TurnedGround& ground,
                            const EndCriterion& criterion);

/// The same for the wanted strips of the range only.
TrackFamily straight_tracks(const StripGrid& grid, StripRange range, const StripMask& wanted,
                            const Polygon& turned, const TurnedGround& ground, const EndCriterion& criterion);

/// The same from given profiles of the subfield: that of strip k has the index k − range.first. Profiles of
/// strips that are not wanted are ignored.
TrackFamily straight_tracks(const StripGrid& grid, StripRange range, const StripMask& wanted,
                            std::vector<StripProfile> subfield, const TurnedGround& ground,
                            const EndCriterion& criterion);

}  // namespace tramline
