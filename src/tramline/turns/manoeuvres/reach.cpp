#include "tramline/turns/manoeuvres/reach.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace tramline {
namespace {

// A point (A ahead, L left) of the machine moves along its way s with g((1 − κL) u + κA l): u is where the
// machine points, l its left, κ the curvature, g = ±1 the gear. With ψ the angle from the direction d to u it
// moves across d where (1 − κL) cos ψ = κA sin ψ, that is ψ = χ (mod π) with χ the angle of (κA, 1 − κL).

struct ReachStretch {
  const SteeredStretch& stretch;
  Point direction;
  Point fixed;  ///< ahead and left

  double sense() const { return stretch.gear == Gear::kForward ? 1 : -1; }
  double curvature_change() const {  ///< for each metre
    return (stretch.curvature_at_end - stretch.curvature_at_start) / stretch.length_m;
  }
  double curvature(double after_m) const { return stretch.curvature_at_start + curvature_change() * after_m; }
  double angle_at_start() const {
    const Point unit = stretch.start.heading.unit();
    return std::atan2(cross(direction, unit), dot(direction, unit));
  }
  /// ψ after a length, not reduced.
  double angle(double after_m) const {
    return angle_at_start() +
           sense() * after_m * (stretch.curvature_at_start + 0.5 * curvature_change() * after_m);
  }
  Point across(double after_m) const {
    const double k = curvature(after_m);
    return {k * fixed.x, 1 - k * fixed.y};
  }
  double reached(double after_m) const {
    const Pose pose = pose_after(stretch, std::clamp(after_m, 0.0, stretch.length_m));
    const Point unit = pose.heading.unit();
    return dot(pose.at + fixed.x * unit + fixed.y * left_of(unit), direction);
  }
};

void keep_inside(std::vector<double>& places, double after_m, const ReachStretch& on) {
  if (after_m > 0 && after_m < on.stretch.length_m) places.push_back(after_m);
}

/// Numbers k with kπ between two angles.
template <class Visit>
void for_each_half_turn(double a, double b, Visit visit) {
  const double last = std::floor(std::max(a, b) / std::numbers::pi);
  for (double k = std::ceil(std::min(a, b) / std::numbers::pi); k <= last; ++k) visit(k * std::numbers::pi);
}

std::vector<double> extremes_on_arc(const ReachStretch& on) {
  std::vector<double> places;
  const Point across = on.across(0);
  const double start = on.angle_at_start() - std::atan2(across.y, across.x);
  const double by_metre = on.sense() * on.stretch.curvature_at_start;
  for_each_half_turn(start, start + by_metre * on.stretch.length_m,
                     [&](double half_turns) { keep_inside(places, (half_turns - start) / by_metre, on); });
  return places;
}

/// Places of a clothoid at which ψ has the value: a quadratic equation.
void add_angle_places(std::vector<double>& places, double angle, const ReachStretch& on) {
  const double a = 0.5 * on.sense() * on.curvature_change();
  const double b = on.sense() * on.stretch.curvature_at_start;
  const double c = on.angle_at_start() - angle;
  const double square = b * b - 4 * a * c;
  if (square < 0) return;
  const double q = -0.5 * (b + std::copysign(std::sqrt(square), b));
  if (a != 0) keep_inside(places, q / a, on);
  if (q != 0) keep_inside(places, c / q, on);
}

/// Places of a point on the axle's line, where ψ = π/2 (mod π) or the point is the centre of the turn itself.
std::vector<double> extremes_on_the_axle(const ReachStretch& on) {
  std::vector<double> places;
  const double end = on.stretch.length_m;
  double least = std::min(on.angle(0), on.angle(end)), most = std::max(on.angle(0), on.angle(end));
  const double straight = -on.stretch.curvature_at_start / on.curvature_change();
  if (straight > 0 && straight < end) {
    least = std::min(least, on.angle(straight));
    most = std::max(most, on.angle(straight));
  }
  const double quarter = 0.5 * std::numbers::pi;
  for_each_half_turn(least - quarter, most - quarter,
                     [&](double half_turns) { add_angle_places(places, half_turns + quarter, on); });
  if (on.fixed.y != 0)
    keep_inside(places, (1 / on.fixed.y - on.stretch.curvature_at_start) / on.curvature_change(), on);
  return places;
}

template <class Function>
double bisected(double low, double high, Function function) {
  const bool rising = function(low) < 0;
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high))
    ((function(middle) < 0) == rising ? low : high) = middle;
  return low;
}

/// Ends of the pieces of a clothoid on which ψ − χ rises or falls throughout. Its derivative has the sign of
/// the cubic gκ((κA)² + (1 − κL)²) + cA with c the change of curvature; κ is even in the length.
std::vector<double> monotone_pieces(const ReachStretch& on) {
  const double ahead = on.fixed.x, left = on.fixed.y, sense = on.sense();
  const double change = on.curvature_change(), end = on.stretch.length_m;
  const auto cubic = [&](double after_m) {
    const Point across = on.across(after_m);
    return sense * on.curvature(after_m) * dot(across, across) + change * ahead;
  };
  // the cubic itself turns where 3(A² + L²)κ² − 4Lκ + 1 = 0
  std::vector<double> turns = {0};
  const double square = 4 * left * left - 3 * (ahead * ahead + left * left);
  if (square > 0)
    for (const double root : {-std::sqrt(square), std::sqrt(square)}) {
      const double curvature = (2 * left + root) / (3 * (ahead * ahead + left * left));
      keep_inside(turns, (curvature - on.stretch.curvature_at_start) / change, on);
    }
  turns.push_back(end);
  std::sort(turns.begin(), turns.end());
  std::vector<double> pieces = {0};
  for (std::size_t i = 1; i < turns.size(); ++i)
    if ((cubic(turns[i - 1]) < 0) != (cubic(turns[i]) < 0))
      pieces.push_back(bisected(turns[i - 1], turns[i], cubic));
  pieces.push_back(end);
  return pieces;
}

std::vector<double> extremes_off_the_axle(const ReachStretch& on) {
  const Point first = on.across(0);
  const double first_angle = std::atan2(first.y, first.x);
  // (κA, 1 − κL) runs along a line, so its angle changes by less than π
  const auto difference = [&](double after_m) {
    const Point across = on.across(after_m);
    return on.angle(after_m) - first_angle - std::atan2(cross(first, across), dot(first, across));
  };
  std::vector<double> places;
  const std::vector<double> pieces = monotone_pieces(on);
  for (std::size_t i = 1; i < pieces.size(); ++i)
    for_each_half_turn(difference(pieces[i - 1]), difference(pieces[i]), [&](double half_turns) {
      keep_inside(places,
                  bisected(pieces[i - 1], pieces[i], [&](double s) { return difference(s) - half_turns; }),
                  on);
    });
  return places;
}

double reach_on(const ReachStretch& on) {
  double most = std::max(on.reached(0), on.reached(on.stretch.length_m));
  std::vector<double> places;
  if (on.stretch.clothoid())
    places = on.fixed.x == 0 ? extremes_on_the_axle(on) : extremes_off_the_axle(on);
  else if (on.stretch.curvature_at_start != 0)
    places = extremes_on_arc(on);
  for (const double after_m : places) most = std::max(most, on.reached(after_m));
  return most;
}

}  // namespace

double reach(const SteeredPath& path, Point direction, Point ahead_and_left) {
  assert(std::abs(dot(direction, direction) - 1) < 1e-9);
  if (path.empty()) return 0;
  double most = -std::numeric_limits<double>::infinity();
  for (const SteeredStretch& stretch : path)
    most = std::max(most, stretch.length_m > 0 ? reach_on({stretch, direction, ahead_and_left})
                                               : reach_on({arc_from(stretch.start, 0, 0, stretch.gear),
                                                           direction, ahead_and_left}));
  return most - dot(path.front().start.at, direction);
}

}  // namespace tramline
