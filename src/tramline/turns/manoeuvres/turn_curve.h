#pragma once
// How a turn begins and ends: at once on an arc, or on clothoids while the wheels are being steered.

#include <optional>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/machine.h"

namespace tramline {

/// What all turns of one radius and one rate of steering have in common: clothoid in, arc of radius r,
/// clothoid out, from a pose with wheels straight ahead to another (Fraichard and Scheuer 2004, §III; Scheuer
/// and Laugier 1998). Both poses lie on a circle about the centre of the arc, at the same angle to its
/// tangent whatever the deflection. Where the curvature may change at once the circle is the arc's own.
struct TurnCurve {
  double radius_m = 0;
  double sharpness = 0;   ///< greatest change of curvature, 1/m²; infinite: at once
  double clothoid_m = 0;  ///< length from straight ahead to the radius; 0: at once
  /// Centre of the circle in the frame of the pose in which the turn begins: ahead (in the direction of
  /// driving) and to the side. R sin μ and R cos μ with R the outer radius and μ the angle of Fraichard and
  /// Scheuer; 0 and r where the curvature changes at once.
  double ahead_m = 0;
  double aside_m = 0;
  /// Least deflection with two whole clothoids, rad. Turns by less are two clothoids of lesser sharpness that
  /// meet (the elementary path of Scheuer and Laugier 1998).
  double full_deflection_rad = 0;

  bool at_once() const { return clothoid_m == 0; }
};

/// Both in metres. Precondition: radius_m > 0, sharpness > 0.
TurnCurve turn_curve(double radius_m, double sharpness);
/// Arcs without clothoids.
TurnCurve arc_turn(double radius_m);

/// The turns of a machine in both gears. The wheels need steering_time_s from straight ahead to the smallest
/// circle, and the machine drives meanwhile, so the clothoids of the slower gear are shorter.
struct TurnCurves {
  TurnCurve forward;
  TurnCurve reverse;
};
TurnCurves turn_curves(const Machine& machine);
TurnCurves arc_turns(double radius_m);

enum class TurnSide { kLeft, kRight };

/// The turn by `deflection_rad` ≥ 0 from a pose, to the left or right of where the machine points, which in
/// reverse is the side that the centre is on. Three stretches, two where the deflection has no arc, one where
/// the curvature changes at once. Ends in the pose that an arc about the same circle says, to rounding.
/// Nothing where the deflection is too small for the circle to be reached with the given sharpness: that
/// happens where full_deflection_rad is near to or more than a whole circle. Precondition: deflection_rad >
/// 0.
std::optional<SteeredPath> turn_from(const Pose& from, double deflection_rad, TurnSide side, Gear gear,
                                     const TurnCurve& curve);

}  // namespace tramline
