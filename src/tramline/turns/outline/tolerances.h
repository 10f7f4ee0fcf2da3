#pragma once
// Tolerances of swept outlines and of the room for them. Tolerances of a single algorithm stand with it.

namespace tramline {

/// An arc that turns by less may be nearly a line, rad: its centre may be too far away to compute with.
inline constexpr double kNearlyStraight_rad = 0.5;
/// The outline may leave the land by this on lines and arcs, m: work ends at hard edges, so that outlines
/// begin by touching them. The spacing of the precision grid.
inline constexpr double kTouchesEdge_m = 1e-6;
/// The outline may leave the land by this where its motion is bounded, not computed exactly: on clothoids,
/// and that of towed implements, m. Nobody steers to a millimetre.
inline constexpr double kBoundedMotion_m = 1e-3;
/// How far a swept outline gets is found to this, m, where there is no closed form.
inline constexpr double kSweptReach_m = 1e-9;
/// How much room is missing is found to this, m: it is printed in decimetres.
inline constexpr double kMissingRoom_m = 0.02;
/// A vertex of the land moves by no more than this multiple of the tolerance by which its edges move: at the
/// tip of a spike the lines along them meet far away.
inline constexpr double kFarthestMitre = 10;
/// Turning of a drawbar in one step of integration, rad. The error of the fourth order is then about 1e-8
/// rad in all.
inline constexpr double kDrawbarStep_rad = 0.03;

// The finer tolerance is nothing beside the coarser.
static_assert(kTouchesEdge_m <= 0.01 * kBoundedMotion_m);

}  // namespace tramline
