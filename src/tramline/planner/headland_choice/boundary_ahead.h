#pragma once
// The boundaries before the ends of tracks.

#include <cstddef>
#include <optional>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/field.h"

namespace tramline {

/// A place on the edge of the field or of an obstacle.
struct BoundaryPlace {
  std::optional<std::size_t> obstacle{};  ///< index into Field::obstacles; nullopt: the field's outer ring
  std::size_t edge = 0;                   ///< from this vertex of the ring to the next one
  double along_m = 0;                     ///< along the ring, from its first vertex
  double ahead_m = 0;  ///< from the end of the track along its line; negative where it runs on beyond
  Point outward;       ///< unit vector from the land
};

/// The boundary that the line of a track crosses nearest to its end, at most `behind_m` behind it and
/// `ahead_m` ahead; passable obstacles do not count. nullopt where there is none. O(n).
std::optional<BoundaryPlace> boundary_ahead(const Field& field, const Pose& end, double behind_m,
                                            double ahead_m);

}  // namespace tramline
