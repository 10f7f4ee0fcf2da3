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

/// The greatest value of a function known at both ends of a stretch of length h, whose second derivative is
/// at most M: that of the parabola of curvature −M through both.
double bound_between(double at_from, double at_to, double h, double most_second) {
  const double bulge = 0.5 * most_second * h * h;
  const double rise = std::abs(at_to - at_from);
  if (rise >= bulge) return std::max(at_from, at_to);
  return 0.5 * (at_from + at_to) + 0.25 * bulge + rise * rise / (4 * bulge);
}

/// Raises `best` to the greatest value of the function between two places, to kSweptReach_m.
template <class Function>
void raise_reach(double& best, const Function& f, double from, double at_from, double to, double at_to,
                 double most_second) {
  best = std::max({best, at_from, at_to});
  if (bound_between(at_from, at_to, to - from, most_second) <= best + kSweptReach_m) return;
  const double middle = 0.5 * (from + to), at_middle = f(middle);
  best = std::max(best, at_middle);
  raise_reach(best, f, from, at_from, middle, at_middle, most_second);
  raise_reach(best, f, middle, at_middle, to, at_to, most_second);
}

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

double reach_on_clothoid(const SteeredStretch& stretch, Point corner, Point unit) {
  const auto reach_at = [&](double after_m) {
    return dot(unit, to_ground(placed(pose_after(stretch, after_m)), corner));
  };
  const double curvature = std::max(std::abs(stretch.curvature_at_start), std::abs(stretch.curvature_at_end));
  const double change = std::abs(curvature_change(stretch));
  const double out = length(corner);
  const double most_second = change * out + curvature * (1 + curvature * out);
  double best = -std::numeric_limits<double>::infinity();
  raise_reach(best, reach_at, 0, reach_at(0), stretch.length_m, reach_at(stretch.length_m), most_second);
  return best;
}

double reach_towed(const TowedMotion& motion, std::size_t stretch, Point corner, Point unit) {
  const auto reach_at = [&](double after_m) {
    return dot(unit, to_ground(motion.implement(stretch, after_m), corner));
  };
  const TowedMotion::Bounds bounds = motion.bounds_on(stretch);
  const double out = length(corner);
  const double most_second = bounds.change_of_velocity + bounds.velocity * bounds.turning +
                             (bounds.change_of_turning + bounds.turning * bounds.turning) * out;
  const double end = motion.path()[stretch].length_m;
  double best = -std::numeric_limits<double>::infinity();
  raise_reach(best, reach_at, 0, reach_at(0), end, reach_at(end), most_second);
  return best;
}

}  // namespace

double swept_reach_m(const SteeredPath& path, const Outline& outline, Point on_line, Point unit) {
  assert(!path.empty());
  double out = -std::numeric_limits<double>::infinity();
  for (const SteeredStretch& stretch : path)
    for (const Box& part : outline.on_machine)
      for (const Point corner : corners_of(part))
        out = std::max(
            out, stretch.clothoid()
                     ? reach_on_clothoid(stretch, corner, unit)
                     : reach_of_corner(machine_motion(stretch, 0, stretch.length_m).even, corner, unit));
  if (outline.tows()) {
    const TowedMotion motion(path, outline);
    for (std::size_t i = 0; i < path.size(); ++i)
      for (const Box& part : outline.on_implement)
        for (const Point corner : corners_of(part)) out = std::max(out, reach_towed(motion, i, corner, unit));
  }
  return out - dot(unit, on_line);
}

}  // namespace tramline
