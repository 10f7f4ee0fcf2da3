#include "tramline/check/turning/shortest_ways.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace tramline::check {
namespace {

using Vector = std::complex<double>;

constexpr Vector kI{0, 1};
constexpr double kPi = std::numbers::pi;
/// A shorter turn is none, rad.
constexpr double kNoTurn_rad = 1e-8 * 2 * kPi;
/// Circles with nearer centres are the same, in radii: rounding alone gives the way between them a direction.
constexpr double kSameCircle = 1e-11;

/// Where the way leads, with the radius as the unit, for a machine that starts at the origin along the real
/// axis.
struct Goal {
  Vector at;
  Vector ahead;  ///< unit vector

  Goal mirrored() const { return {std::conj(at), std::conj(ahead)}; }
  /// The start as seen from the goal. The way back is as long as the way there.
  Goal back() const { return {-at * std::conj(ahead), std::conj(ahead)}; }
  /// From the middle of the start's left circle to that of the goal's left or right one.
  Vector to_left() const { return at + kI * ahead - kI; }
  Vector to_right() const { return at - kI * ahead - kI; }
};

Goal goal_of(const Pose& from, const Pose& to, double radius_m) {
  const Point ahead = from.heading.unit(), way = to.at - from.at, last = to.heading.unit();
  return {Vector{dot(way, ahead), cross(ahead, way)} / radius_m, {dot(last, ahead), cross(ahead, last)}};
}

/// A turn from one direction to another, either always anticlockwise or the shorter way, rad.
double anticlockwise(Vector from, Vector to) {
  const double angle = std::arg(to * std::conj(from));
  if (std::abs(angle) < kNoTurn_rad) return 0;
  return angle < 0 ? angle + 2 * kPi : angle;
}
double clockwise(Vector from, Vector to) { return anticlockwise(to, from); }
double shorter(Vector from, Vector to) { return std::abs(std::arg(to * std::conj(from))); }

double root(double square) { return std::sqrt(std::max(0.0, square)); }

// The words of Dubins that begin on the left circle; those on the right one are their mirror images.

double left_straight_left(const Goal& goal) {
  const Vector way = goal.to_left();
  const double straight = std::abs(way);
  if (straight < kSameCircle) return anticlockwise(1, goal.ahead);
  const Vector along = way / straight;
  return anticlockwise(1, along) + straight + anticlockwise(along, goal.ahead);
}

/// The line crosses the line of centres: the way between them is straight · along − 2i · along.
double left_straight_right(const Goal& goal) {
  const Vector way = goal.to_right();
  const double square = std::norm(way) - 4;
  if (square < -kSameCircle) return std::numeric_limits<double>::infinity();
  const double straight = root(square);
  const Vector along = way / Vector{straight, -2};
  const Vector unit = along / std::abs(along);
  return anticlockwise(1, unit) + straight + clockwise(unit, goal.ahead);
}

/// The middle circle touches both: it lies beside the middle of the way between the centres, on either side.
/// On the left circle a machine in direction e from its centre goes along i·e, on the right one along −i·e.
template <class First, class Middle, class Last>
double left_right_left(const Goal& goal, First first, Middle middle, Last last) {
  const Vector way = goal.to_left();
  const double apart = std::abs(way);
  double least = std::numeric_limits<double>::infinity();
  if (apart > 4 || apart < kSameCircle) return least;
  const Vector beside = kI * (way / apart) * root(4 - 0.25 * apart * apart);
  for (const double side : {1.0, -1.0}) {
    const Vector to_middle = 0.5 * (0.5 * way + side * beside);
    const Vector to_last = 0.5 * way - to_middle;
    const Vector out = kI * to_middle, in = -kI * to_last;
    least = std::min(least, first(1, out) + middle(out, in) + last(in, goal.ahead));
  }
  return least;
}

double least_beginning_left(const Goal& goal) {
  return std::min({left_straight_left(goal), left_straight_right(goal),
                   left_right_left(goal, anticlockwise, clockwise, anticlockwise)});
}

// The families of Reeds and Shepp that begin on the left circle. `out` is where the machine points as it
// leaves that circle.

double unit_turns(const Goal& goal, Vector out, Vector in) {
  return shorter(1, out) + shorter(in, goal.ahead);
}

/// One turn, a line, one turn.
double turn_line_turn(const Goal& goal) {
  double least = std::numeric_limits<double>::infinity();
  const Vector same = goal.to_left(), other = goal.to_right();
  const double straight = std::abs(same);
  if (straight < kSameCircle) least = shorter(1, goal.ahead);
  for (const double sense : {1.0, -1.0}) {
    if (straight >= kSameCircle)
      least = std::min(least, unit_turns(goal, sense * same, sense * same) + straight);
    const double square = std::norm(other) - 4;
    if (square < -kSameCircle) continue;
    const Vector along = other / Vector{sense * root(square), -2};
    least = std::min(least, unit_turns(goal, along, along) + root(square));
  }
  return least;
}

/// Four turns, the inner two equally long. With `turn` as the first of these the way between the outer
/// circles is 2·out·(−i)·(1 − turn + turn²) where both turn the machine to the same side, so that it ends
/// turned by turn², and 2·out·(−i)·(2 − turn) where they cancel.
double four_turns(const Goal& goal) {
  const Vector half = 0.5 * goal.to_right();
  const double apart = std::abs(half);
  double least = std::numeric_limits<double>::infinity();
  if (apart < kSameCircle) return least;
  const auto try_turn = [&](double cosine, bool cancel) {
    if (std::abs(cosine) > 1 + kSameCircle) return;
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    for (const double sense : {1.0, -1.0}) {
      const Vector turn = std::polar(1.0, sense * angle);
      const Vector shape = cancel ? 2.0 - turn : 1.0 - turn + turn * turn;
      if (std::abs(shape) < kSameCircle) continue;
      const Vector out = kI * half / shape;
      least = std::min(least, unit_turns(goal, out, cancel ? out : out * turn * turn) + 2 * angle);
    }
  };
  try_turn(0.5 * (1 + apart), false);
  try_turn(0.5 * (1 - apart), false);
  try_turn(0.25 * (5 - apart * apart), true);
  return least;
}

/// A turn, a quarter circle the other way round, a line, a turn; `side`: whether the quarter turns the
/// machine to the left. The line leads along side·i·out.
double quarter_before_line(const Goal& goal) {
  double least = std::numeric_limits<double>::infinity();
  const Vector right = goal.to_right(), left = goal.to_left();
  for (const double side : {1.0, -1.0})
    for (const double sense : {1.0, -1.0}) {
      const double same = sense * std::abs(right);
      if (std::abs(same) > kSameCircle) {
        const Vector out = right / (kI * same);
        least = std::min(least, unit_turns(goal, out, side * kI * out) + 0.5 * kPi + std::abs(same + 2));
      }
      const double square = std::norm(left) - 4;
      if (square < -kSameCircle) continue;
      const double other = sense * root(square);
      const Vector out = left / Vector{-2 * side, other};
      least = std::min(least, unit_turns(goal, out, side * kI * out) + 0.5 * kPi + std::abs(other + 2));
    }
  return least;
}

/// A turn, a quarter circle, a line, a quarter circle back, a turn.
double quarters_beside_line(const Goal& goal) {
  double least = std::numeric_limits<double>::infinity();
  const Vector way = goal.to_right();
  const double square = std::norm(way) - 4;
  if (square < -kSameCircle) return least;
  for (const double side : {1.0, -1.0})
    for (const double sense : {1.0, -1.0}) {
      const double other = sense * root(square);
      const Vector out = way / Vector{-2 * side, other};
      least = std::min(least, unit_turns(goal, out, out) + kPi + std::abs(other + 4));
    }
  return least;
}

double least_reversing_beginning_left(const Goal& goal) {
  return std::min({turn_line_turn(goal), left_right_left(goal, shorter, shorter, shorter), four_turns(goal),
                   quarter_before_line(goal), quarters_beside_line(goal)});
}

}  // namespace

double least_forward_m(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  const Goal goal = goal_of(from, to, radius_m);
  return radius_m * std::min(least_beginning_left(goal), least_beginning_left(goal.mirrored()));
}

double least_with_reversing_m(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  const Goal goal = goal_of(from, to, radius_m), back = goal.back();
  return radius_m *
         std::min({least_reversing_beginning_left(goal), least_reversing_beginning_left(goal.mirrored()),
                   quarter_before_line(back), quarter_before_line(back.mirrored())});
}

}  // namespace tramline::check
