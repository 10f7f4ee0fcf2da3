#include "tramline/turns/outline/swept_reach.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "tramline/turns/outline/even_motion.h"
#include "tramline/turns/outline/tolerances.h"
#include "tramline/turns/outline/towed_motion.h"

namespace tramline {
namespace {

/// On a line or an arc. With the rates p of the distance and q of p, in the angle φ turned, the distance has
/// grown by p sin φ + q (1 − cos φ).
double reach_of_corner(const EvenMotion& motion, Point corner, Point unit) {
  const Point before = to_ground(motion.start, corner), after = to_ground(end_of(motion), corner);
  double out = std::max(dot(unit, before), dot(unit, after));
  const double turn = std::abs(motion.turn_rad);
  if (turn == 0) return out;
  const Point velocity =
      motion.way_m * motion.start.ahead + motion.turn_rad * left_of(before - motion.start.at);
  const double p = dot(unit, velocity);
  const double q = (motion.turn_rad > 0 ? 1 : -1) * dot(unit, left_of(velocity));
  double at = std::atan2(p, -q);
  if (at < 0) at += 2 * std::numbers::pi;
  if (at > turn) return out;
  const double amplitude = std::hypot(p, q);
  const double grown = q < 0 ? p * p / (amplitude - q) : amplitude + q;
  return std::max(out, dot(unit, before) + grown / turn);
}

/// Raises `best` to how far the corner comes between two places on a stretch, m from its start, to
/// kSweptReach_m. `motion_between(from_m, to_m)` is the motion of its part, whose bounds shrink with the
/// square of the way.
template <class MotionBetween>
void raise_reach(double& best, const MotionBetween& motion_between, double from_m, double to_m, Point corner,
                 Point unit) {
  const MotionPiece piece = motion_between(from_m, to_m);
  const double reach_m = reach_of_corner(piece.even, corner, unit);
  const double margin_m = piece.off_m + piece.off_rad * length(corner);
  best = std::max(best, reach_m - margin_m);
  if (reach_m + margin_m <= best + kSweptReach_m) return;
  const double middle_m = 0.5 * (from_m + to_m);
  raise_reach(best, motion_between, from_m, middle_m, corner, unit);
  raise_reach(best, motion_between, middle_m, to_m, corner, unit);
}

void raise_by_machine(double& best, const SteeredStretch& stretch, Point corner, Point unit) {
  const auto motion_between = [&](double from_m, double to_m) {
    return machine_motion(stretch, from_m, to_m);
  };
  raise_reach(best, motion_between, 0, stretch.length_m, corner, unit);
}

void raise_by_implement(double& best, const TowedMotion& motion, std::size_t stretch, Point corner,
                        Point unit) {
  const auto motion_between = [&](double from_m, double to_m) {
    return motion.motion(stretch, from_m, to_m);
  };
  const double pieces = motion.pieces(stretch), length_m = motion.path()[stretch].length_m;
  for (double i = 0; i < pieces; ++i)
    raise_reach(best, motion_between, i / pieces * length_m, (i + 1) / pieces * length_m, corner, unit);
}

}  // namespace

double swept_reach_m(const SteeredPath& path, const Outline& outline, Point on_line, Point unit) {
  assert(!path.empty());
  double best = -std::numeric_limits<double>::infinity();
  for (const SteeredStretch& stretch : path)
    for (const Box& part : outline.on_machine)
      for (const Point corner : corners_of(part)) raise_by_machine(best, stretch, corner, unit);
  if (outline.tows()) {
    const TowedMotion motion(path, outline);
    for (std::size_t i = 0; i < path.size(); ++i)
      for (const Box& part : outline.on_implement)
        for (const Point corner : corners_of(part)) raise_by_implement(best, motion, i, corner, unit);
  }
  return best - dot(unit, on_line);
}

}  // namespace tramline
