#pragma once
// The angles and lengths of Dubins' words, for turns with clothoids too.

#include <algorithm>
#include <cmath>
#include <optional>

#include "tramline/turns/manoeuvres/relative_pose.h"
#include "tramline/turns/manoeuvres/turn_curve.h"
#include "tramline/turns/tolerances.h"

namespace tramline {

// With a = ahead_m and b = aside_m of a turning curve, a turn to the left from a pose with heading e and left
// normal n has its centre at +a e + b n from there, and one that ends in such a pose at −a e + b n; turns to
// the right have −b. Every word follows from the vector between the centres of its first and last turn. Only
// words that begin to the left are here: for the others the target is mirrored.

/// Turn, line, turn. The line has the length line_m ≥ 0.
struct TurnLineTurn {
  double first = 0;  ///< rad
  double line_m = 0;
  double last = 0;  ///< rad
};
struct ThreeTurns {
  double first = 0, middle = 0, last = 0;  ///< rad
};

/// 0 for a turn that is one, or none, by rounding only. `way_m`: by how much its angle displaces the end.
inline double without_noise(double turn, double way_m, double radius_m) {
  const double none = std::clamp(kNoTurnAtRadius_rad * radius_m / way_m, kNoTurnLeast_rad, kNoTurnMost_rad);
  return turn <= none || turn >= kWholeCircle - none ? 0 : turn;
}

/// Finishes a word with a line: a turn by 0 is a line of 2a, the distance between its two poses.
inline std::optional<TurnLineTurn> with_line(double first, double line_m, double last, double way_m,
                                             const TurnCurve& curve) {
  TurnLineTurn out{without_noise(first, way_m, curve.radius_m), line_m,
                   without_noise(last, way_m, curve.radius_m)};
  if (out.first == 0) out.line_m += 2 * curve.ahead_m;
  if (out.last == 0) out.line_m += 2 * curve.ahead_m;
  if (out.line_m < -kNoLine * curve.radius_m) return {};
  if (out.line_m <= kNoLine * curve.radius_m) out.line_m = 0;
  return out;
}

/// From the centre of the first turn, to the left, to that of the last.
inline Point between_centres(const RelativePose& to, const TurnCurve& curve, TurnSide last) {
  const double a = curve.ahead_m, b = last == TurnSide::kLeft ? curve.aside_m : -curve.aside_m;
  return {to.ahead - a * to.cosine - b * to.sine - a, to.left - a * to.sine + b * to.cosine - curve.aside_m};
}

/// LSL (Shkel and Lumelsky 2001, eq. 4). Between poses in line that are nearer than 2a the centres lie in the
/// order that the line from the one to the other is driven against: found only where both turns are none.
inline std::optional<TurnLineTurn> left_line_left(const RelativePose& to, const TurnCurve& curve) {
  const Point way = between_centres(to, curve, TurnSide::kLeft);
  const double distance_m = std::sqrt(dot(way, way));
  const bool one_turn = distance_m <= kNoLine * curve.radius_m;
  const double heading = one_turn ? 0 : in_whole_circle(std::atan2(way.y, way.x));
  if (!curve.at_once()) {
    const double against = in_whole_circle(heading + 0.5 * kWholeCircle);
    if (const auto line = with_line(against, -distance_m - 2 * curve.ahead_m,
                                    in_whole_circle(to.turn - against), distance_m, curve))
      return line;
  }
  return with_line(heading, distance_m - 2 * curve.ahead_m, in_whole_circle(to.turn - heading), distance_m,
                   curve);
}

/// LSR (Shkel and Lumelsky 2001, eq. 6): the line crosses that between the centres.
inline std::optional<TurnLineTurn> left_line_right(const RelativePose& to, const TurnCurve& curve) {
  const Point way = between_centres(to, curve, TurnSide::kRight);
  const double apart = 2 * curve.aside_m, square = dot(way, way);
  const double line_square = square - apart * apart;
  if (line_square < -kTouches * square) return {};
  const double line_m = std::sqrt(std::max(0.0, line_square));
  const double heading = in_whole_circle(std::atan2(way.y, way.x) + std::atan2(apart, line_m));
  return with_line(heading, line_m - 2 * curve.ahead_m, in_whole_circle(heading - to.turn), std::sqrt(square),
                   curve);
}

/// LRL with a middle turn of more than half a circle, the only one that can be shortest (Shkel and Lumelsky
/// 2001, eq. 10). With clothoids the first and the last turn of no angle are lines of 2a.
inline std::optional<ThreeTurns> left_right_left(const RelativePose& to, const TurnCurve& curve) {
  const Point way = between_centres(to, curve, TurnSide::kLeft);
  const double a = curve.ahead_m, b = curve.aside_m;
  const double square = dot(way, way), share_square = square / (16 * (a * a + b * b));
  if (share_square > 1 + kTouches) return {};
  const bool one_turn = square <= kNoLine * kNoLine * curve.radius_m * curve.radius_m;
  const double towards = one_turn ? 0 : std::atan2(way.y, way.x);
  const double aside = share_square > 1 - kTouches ? 0 : std::acos(std::sqrt(share_square));
  const double tangent = a == 0 ? 0.25 * kWholeCircle : std::atan2(b, a);  // from a pose to the next centre
  const double first = in_whole_circle(towards + aside + tangent);
  const double middle = in_whole_circle(2 * (aside + tangent));
  const double last = in_whole_circle(to.turn - (towards - aside - tangent));
  return ThreeTurns{without_noise(first, curve.radius_m, curve.radius_m), middle,
                    without_noise(last, curve.radius_m, curve.radius_m)};
}

}  // namespace tramline
