#pragma once
// Open passes that are driven on at their ends, until something is in the way.

#include <vector>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/headland/tolerances.h"

namespace tramline {

/// A turn by more is one round a corner, rad.
inline constexpr double kCorner_rad = 0.5;

/// A boundary and the distance that the edge of a swath has to keep from it, m; 0 where it may touch it. What
/// reaches into its sides by no more than `beside_m` is not in its way.
struct SwathLimit {
  Ring ring;
  double distance_m = 0;
  double beside_m = kBeside_m;
};

/// Where the boundary lies that a pass goes on along, if it follows one.
enum class Along { kNone, kOnTheRight, kOnTheLeft };

/// How a swath with flat ends is driven on.
struct DrivenOn {
  double width_m = 0;
  double radius_m = 0;  ///< of the tightest turn along a boundary that bends
  double most_m = 0;    ///< how far at most
  Along boundary = Along::kNone;
};

/// An open path extended at its end as far as its swath keeps its distance from the boundaries: straight on,
/// or where the boundary that it goes along bends towards it, by less than kCorner_rad in all, along that.
/// O(b·n) for n edges and b bends.
Path driven_on(Path path, const std::vector<SwathLimit>& limits, const DrivenOn& how);

/// An open path extended at both ends in the same way. The side of the boundary is that at its end.
Path driven_to_the_end(Path path, const std::vector<SwathLimit>& limits, DrivenOn how);

}  // namespace tramline
