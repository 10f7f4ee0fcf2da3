#pragma once
// Motion along a line or an arc, and pieces of any motion that come near one.

#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/turns/outline/outline.h"

namespace tramline {

/// The frame of a part drives way_m along its own axis, negative in reverse, and turns by turn_rad,
/// anticlockwise positive, both evenly: on a line, on an arc, or on the spot.
struct EvenMotion {
  Placement start;
  double way_m = 0;
  double turn_rad = 0;
};

/// Displacement of the frame's origin in the coordinates of the start: of the whole motion.
Point displacement(const EvenMotion& motion);
Placement end_of(const EvenMotion& motion);

/// A box, on the ground, that contains all that the part sweeps; the smallest but for motions that turn by
/// less than kNearlyStraight_rad.
Box swept_box(const Box& part, const EvenMotion& motion);

/// A piece of a motion, and the even motion near it. After the same share of its time no frame is farther
/// from the even one than the two bounds.
struct MotionPiece {
  EvenMotion even;
  double off_m = 0;    ///< of the origin
  double off_rad = 0;  ///< of the heading

  /// Bound of the distance of any point of the part from where the even motion takes it, m.
  double margin_m(const Box& part) const { return off_m + off_rad * farthest_corner_m(part); }
};

/// The motion of the machine between two places on the stretch, metres from its start. Lines and arcs are
/// exact. On a piece of a clothoid of length h on which the curvature changes by Δκ, the arc of the mean
/// curvature deviates by at most Δκ h/8 in heading and Δκ h²/12 in place: the integrals of the difference of
/// the curvatures, which is linear and 0 in the middle. Precondition: 0 ≤ from_m ≤ to_m ≤ length.
MotionPiece machine_motion(const SteeredStretch& stretch, double from_m, double to_m);

/// +1 forward, −1 in reverse.
inline double driving_sense(Gear gear) { return gear == Gear::kForward ? 1 : -1; }
/// At a place of the stretch, 1/m.
double curvature_at(const SteeredStretch& stretch, double at_m);
/// Change of the curvature along the way, 1/m².
double curvature_change(const SteeredStretch& stretch);

}  // namespace tramline
