#pragma once
// How far beside the track a towed implement is after a turn, and how soon it follows.

#include "tramline/geometry/angle.h"
#include "tramline/turns/outline/outline.h"

namespace tramline {

/// How far the implement's axle is from the line that the hitch drives along straight on, m: L sin(a), where
/// a is the angle from the drawbar to that line at the start, and tan(a/2) falls by e^(−s/L) over the way s
/// (the tractrix; see towed_motion.h). At most 2 L tan(a/2). On the side to which the angle turns: positive
/// where the line is anticlockwise of the drawbar, the implement then being on its right. Precondition:
/// drawbar_m > 0.
double lateral_error_m(Angle drawbar_to_line, double drawbar_m, double after_m);

/// The way straight on after which the implement's axle stays within the tolerance of the line, m: with
/// L sin(b) = tolerance, b ≤ 90°, L ln(tan(a/2)/tan(b/2)). 0 where it is there already, or where the
/// tolerance is the drawbar's length or more; infinite where the drawbar points straight ahead. Precondition:
/// drawbar_m > 0, tolerance_m > 0.
double run_in_m(Angle drawbar_to_line, double drawbar_m, double tolerance_m);

/// How far the implement's axle is from the line through the path's last pose at its first worked metre:
/// after `straight_m` driven straight on behind the path, m. The drawbar points along the machine at the
/// path's start. Preconditions as for TowedMotion.
double lateral_error_m(const SteeredPath& path, const Outline& outline, double straight_m);

/// The way straight on after the path that run_in_m() asks for.
double run_in_m(const SteeredPath& path, const Outline& outline, double tolerance_m);

}  // namespace tramline
