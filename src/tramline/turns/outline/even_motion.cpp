#include "tramline/turns/outline/even_motion.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "tramline/turns/outline/tolerances.h"

namespace tramline {
namespace {

constexpr double kSeries_rad = 1e-4;  ///< for smaller angles two terms of a series are exact

/// (sin x)/x and (1 − cos x)/x.
Point unit_displacement(double x) {
  if (std::abs(x) < kSeries_rad) return {1 - x * x / 6, 0.5 * x * (1 - x * x / 12)};
  return {std::sin(x) / x, (1 - std::cos(x)) / x};
}

/// Grows the box by the extreme points of the circle's part that leads from one point to the other. Points
/// of an arc driven anticlockwise lie on the right of its chord.
void extend_by_arc(Box& box, Point about, Point from, Point to, double turn) {
  const double radius = distance(about, from);
  const double side = turn > 0 ? 1 : -1;
  for (const Point axis : std::array{Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}}) {
    const Point extreme = about + radius * axis;
    if (std::abs(turn) >= 2 * std::numbers::pi || side * cross(to - from, extreme - from) <= 0)
      box.extend(extreme);
  }
}

}  // namespace

Point displacement(const EvenMotion& motion) { return motion.way_m * unit_displacement(motion.turn_rad); }

Placement end_of(const EvenMotion& motion) {
  return {to_ground(motion.start, displacement(motion)), turned(motion.start.ahead, motion.turn_rad)};
}

Box swept_box(const Box& part, const EvenMotion& motion) {
  const Placement end = end_of(motion);
  const double turn = std::abs(motion.turn_rad);
  Box out;
  double sagitta = 0;
  for (const Point corner : corners_of(part)) {
    const Point from = to_ground(motion.start, corner);
    const Point to = to_ground(end, corner);
    out.extend(from);
    out.extend(to);
    if (turn >= kNearlyStraight_rad)
      extend_by_arc(out, to_ground(motion.start, {0, motion.way_m / motion.turn_rad}), from, to,
                    motion.turn_rad);
    else
      sagitta = std::max(sagitta, distance(from, to) * turn / 7);  // chord · tan(turn/4)/2 at the most
  }
  return out.grown(sagitta);
}

double curvature_change(const SteeredStretch& stretch) {
  return stretch.length_m > 0 ? (stretch.curvature_at_end - stretch.curvature_at_start) / stretch.length_m
                              : 0;
}

double curvature_at(const SteeredStretch& stretch, double at_m) {
  return stretch.curvature_at_start + curvature_change(stretch) * at_m;
}

MotionPiece machine_motion(const SteeredStretch& stretch, double from_m, double to_m) {
  assert(0 <= from_m && from_m <= to_m && to_m <= stretch.length_m);
  const double sense = driving_sense(stretch.gear);
  const double h = to_m - from_m;
  const double mean_curvature =
      stretch.clothoid() ? curvature_at(stretch, 0.5 * (from_m + to_m)) : stretch.curvature_at_start;
  MotionPiece out;
  out.even = {placed(from_m > 0 ? pose_after(stretch, from_m) : stretch.start), sense * h,
              sense * h * mean_curvature};
  if (stretch.clothoid()) {
    const double change = std::abs(curvature_change(stretch)) * h;
    out.off_m = change * h * h / 12;
    out.off_rad = change * h / 8;
  }
  return out;
}

}  // namespace tramline
