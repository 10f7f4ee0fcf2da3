#include "tramline/turns/manoeuvres/u_turn.h"

#include <cassert>
#include <cmath>

#include "tramline/turns/manoeuvres/driven_word.h"
#include "tramline/turns/manoeuvres/dubins_solutions.h"
#include "tramline/turns/manoeuvres/turn_kind.h"

namespace tramline {
namespace {

/// Distance between the two poses of a turn by twice the angle.
double chord_of_turn(const TurnCurve& curve, double half_rad) {
  return 2 * (curve.ahead_m * std::cos(half_rad) + curve.aside_m * std::sin(half_rad));
}

/// The curve of at least the given radius whose turn by twice the angle spans the chord.
std::optional<TurnCurve> widened(const TurnCurve& curve, double half_rad, double chord_m) {
  if (chord_of_turn(curve, half_rad) > chord_m) return {};
  // half the chord is not more than the radius on an arc without clothoids of at least half the angle
  double tight = 1 / curve.radius_m, wide = std::sin(half_rad) / chord_m;
  if (!(wide < tight)) return {};
  for (double middle = 0.5 * (tight + wide); wide < middle && middle < tight; middle = 0.5 * (tight + wide))
    (chord_of_turn(turn_curve(1 / middle, curve.sharpness), half_rad) > chord_m ? wide : tight) = middle;
  return turn_curve(1 / tight, curve.sharpness);
}

/// One turn to the left, with a wider arc, where the target lies where such turns end.
std::optional<Manoeuvre> wide_turn(const Pose& from, const RelativePose& to, TurnSide side,
                                   const TurnCurve& curve) {
  const double half = 0.5 * to.turn;
  const Point chord = turned({1, 0}, half), way = {to.ahead, to.left};
  if (to.cosine >= 0 || dot(chord, way) <= 0 || std::abs(cross(chord, way)) > kNoLine * curve.radius_m)
    return {};
  const std::optional<TurnCurve> wider = widened(curve, half, dot(chord, way));
  if (!wider) return {};
  return driven(from, {{side == TurnSide::kLeft ? 'L' : 'R', to.turn}}, {*wider, *wider}, ManoeuvreKind::kU);
}

std::optional<Manoeuvre> u_to_side(const Pose& from, const RelativePose& to, TurnSide side,
                                   const TurnCurve& curve) {
  const char letter = side == TurnSide::kLeft ? 'L' : 'R';
  const std::optional<TurnLineTurn> word = left_line_left(to, curve);
  if (word && kind_of_one_sided(*word, to) == ManoeuvreKind::kU)
    return driven(from, {{letter, word->first}, {'S', word->line_m}, {letter, word->last}}, {curve, curve},
                  ManoeuvreKind::kU);
  return curve.at_once() ? std::nullopt : wide_turn(from, to, side, curve);
}

}  // namespace

std::optional<Manoeuvre> u_turn(const Pose& from, const Pose& to, const TurnCurve& curve) {
  const RelativePose target = relative(from, to);
  auto left = u_to_side(from, target, TurnSide::kLeft, curve);
  return left ? left : u_to_side(from, target.mirrored(), TurnSide::kRight, curve);
}

std::optional<Manoeuvre> u_turn(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  return u_turn(from, to, arc_turn(radius_m));
}

}  // namespace tramline
