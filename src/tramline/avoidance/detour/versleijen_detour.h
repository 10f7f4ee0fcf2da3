#pragma once
// Versleijen's own way round obstacles: category a of his table 3.

#include <limits>

#include "tramline/avoidance/detour/way_round.h"

namespace tramline {

/// How the detour runs between the arcs that leave the track and return to it.
enum class DetourMiddle {
  kAsPrinted,  ///< along the obstacle's buffer of w/2, however tight (Versleijen §2.2.4, fig. 18, fig. 19)
  kDrivable,   ///< round a circle with radius max(R + w/2, r); round any other shape only where its buffer
               ///< is no tighter than the machine turns
};

/// What the rule allows.
struct VersleijenRule {
  double threshold_m = 0;  ///< obstacles whose extent across the track is less are driven round
  /// The path leaves the track by this at most. The program of the thesis allowed w/2: fig. 50 (a).
  double room_m = std::numeric_limits<double>::infinity();
  DetourMiddle middle = DetourMiddle::kAsPrinted;
};

/// The detour of Versleijen §2.2.4 for one gap, on the side with the smaller displacement (left among
/// equals). Round a circle of radius R whose centre lies c from the track, against the side of passing where
/// negative, ρ = R + w/2: three arcs of the radii r, ρ and r, with the peak ρ + c and the half-length
/// √((ρ + r)² − (r − c)²) (eq. 3 and fig. 18). Round any other shape: arcs of radius r that touch the track
/// and the obstacle's buffer of w/2, and between them the buffer's edge (fig. 19), for which a bay in the
/// obstacle is filled up: a bar of width w would only fold in there. Corners of the buffer have the radius
/// w/2, so the machine may be unable to follow (§4.2.2).
///
/// Where the construction leaves the field, meets something else, or starts before the track does, `why_not`
/// gives the reason and the track has to be cut (fig. 20). Radius at least max(r, w/2) at both ends. O(n log
/// n) for n corners of the obstacle and O(m) for m others along it.
WayRound versleijen_detour(const Obstruction& obstruction, const VersleijenRule& rule,
                           const Surroundings& around);

}  // namespace tramline
