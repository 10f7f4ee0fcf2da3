#pragma once
// How a towed implement follows the machine.
//
// The hitch pulls the drawbar, and the implement's wheels do not slip: its axle moves along the drawbar only.
// With a the angle from the drawbar to the hitch's direction of motion, σ the way of the hitch, κ the
// curvature of that way and L the drawbar,
//     da/dσ = κ − sin(a)/L
// (a trailer behind its hitch: Bolzern et al. 1998; the tractrix where κ = 0). The hitch of a machine on a
// line or an arc of radius r drives one itself, of radius √(r² + l²) where it is l behind the axle, in a
// direction of motion that is turned against the machine's by atan(l/r). On these, z = tan(a/2) obeys a
// Riccati equation with constant coefficients, whose solutions are Möbius transformations of the first angle
// (Foote, Levi and Tabachnikov 2013). With z = x/y, k = κL and τ = σ/L,
//     d/dτ (x, y) = ½ ((−x + k y), (−k x + y)),
// which is linear: the exponential of a matrix whose square is (1 − k²)/4. For k = 0 it is
// tan(a/2) = tan(a₀/2) e^(−σ/L). For |k| < 1 the angle tends to that with sin a = k; for |k| > 1 there is
// none, and the implement folds up (jackknifes).

#include <cstddef>
#include <vector>

#include "tramline/turns/outline/even_motion.h"

namespace tramline {

/// The motion of a towed implement along a path of the machine. On lines and arcs in closed form; on
/// clothoids by the Runge-Kutta method of the fourth order, to about 1e-8 rad. Built in O(stretches, and
/// steps on clothoids).
/// Preconditions: the outline tows; no stretch is driven in reverse. There the equations hold too, but an
/// error of the angle grows by e^(σ/L): nobody can drive them as computed, so that turns of towed implements
/// must not have any.
class TowedMotion {
 public:
  /// The drawbar points along the machine at the start, as at the end of a straight track.
  TowedMotion(const SteeredPath& path, const Outline& outline);
  TowedMotion(const SteeredPath& path, const Outline& outline, Heading drawbar_at_start);

  /// The implement: its axle's middle and the heading of the drawbar, after a way of the machine's axle on
  /// the stretch, m. Preconditions: stretch < path.size(), 0 ≤ after_m ≤ its length.
  Placement implement(std::size_t stretch, double after_m) const;
  /// The same after a way on the path, m, as a pose; at joints that of the later stretch.
  Pose pose(double after_m) const;
  /// The angle from the drawbar to the machine's heading at the path's end, anticlockwise positive.
  Angle angle_at_end() const;

  /// The motion of the implement between two places on a stretch, m. Its bounds are those of a motion whose
  /// velocity and angular velocity change by no more than they can change on the piece. Precondition:
  /// 0 ≤ from_m ≤ to_m ≤ length, both on one of the pieces().
  MotionPiece motion(std::size_t stretch, double from_m, double to_m) const;
  /// Bounds on a stretch, by the way of the machine's axle.
  struct Bounds {
    double velocity;            ///< of the implement's axle
    double turning;             ///< of the drawbar, rad/m
    double change_of_velocity;  ///< 1/m
    double change_of_turning;   ///< rad/m²
  };
  Bounds bounds_on(std::size_t stretch) const;
  /// Number of equal pieces of the stretch on each of which the drawbar surely turns by less than half a
  /// turn; at least 1.
  double pieces(std::size_t stretch) const;

  const SteeredPath& path() const { return path_; }

 private:
  struct Start {
    Point drawbar;              ///< unit vector
    double step_m = 0;          ///< of the places on a clothoid at which the angle is kept
    std::vector<Point> bent{};  ///< from the drawbar to the machine's heading: cosine and sine
  };
  Placement implement_of(const Placement& machine, Point drawbar) const;
  Point drawbar_at(std::size_t stretch, double after_m, const Placement& machine) const;
  Point drawbar_on_circle(std::size_t stretch, double after_m, const Placement& machine) const;
  Point drawbar_step(const SteeredStretch& on, Point bent, double from_m, double step_m) const;
  void integrate(const SteeredStretch& on, Start& out) const;
  MotionPiece on_circle(std::size_t stretch, double from_m, double to_m) const;
  MotionPiece on_clothoid(std::size_t stretch, double from_m, double to_m) const;

  SteeredPath path_;
  double hitch_m_;
  double drawbar_m_;
  std::vector<Start> starts_;  ///< of the stretches
  double angle_at_end_rad_ = 0;
};

}  // namespace tramline
