#pragma once
// The land of a subfield in which detours round its obstacles may run.

#include <cstdint>
#include <vector>

#include "tramline/cost/grid/grid_tally.h"

namespace tramline {

/// The grids whose detours may work the land: this one, or those of other parts of the field too.
enum class DetoursOf : std::uint8_t { kThisGrid, kAnyGrid };

/// More than the cotangent of the steepest line of a detour, 75 degrees.
inline constexpr double kDetourFoot = 0.27;
/// What counts as a circle reaches so far beyond its corners, as a share of its diameter.
inline constexpr double kDetourRound_share = 0.02;

/// The terms of detours and of the grids that have them.
struct DetourTerms {
  double width_m = 1;
  double arc_m = 0;       ///< radius of the arcs that leave the track and return to it
  double half_angle = 0;  ///< by which grids may be turned
  double slack_m = 0;     ///< by which a strip may lie elsewhere
  DetoursOf of = DetoursOf::kThisGrid;
};

/// A group of obstacles that detours may go round together, and the land that holds the swaths of all such
/// detours and the stretches of track that they replace. In the turned plane.
struct DetourZone {
  int count = 1;  ///< of obstacles
  Box obstacles;
  Box land;
};

/// A detour displaces its track no farther than half a width beyond the farthest point that it goes round; it
/// leaves the track and returns to it along an arc, or along a line inclined by 75 degrees between two arcs
/// (detour_path()). What it would run into it goes round as well, and so it does with all that lies in a gap
/// of its track: obstacles that this may concern form one group. O(o² + o·n) for o obstacles and n corners.
std::vector<DetourZone> detour_zones(const TurnedSubfield& subfield, const DetourTerms& terms);

}  // namespace tramline
