#include "tramline/turns/manoeuvres/three_turns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "tramline/turns/manoeuvres/driven_word.h"
#include "tramline/turns/manoeuvres/relative_pose.h"
#include "tramline/turns/tolerances.h"

namespace tramline {
namespace {

/// One turn of the word: to a side (+1 left), in a gear (+1 forward), along a curve.
struct GearedTurn {
  double side = 1, gear = 1;
  const TurnCurve* curve = nullptr;

  /// From the pose where it begins to its centre, in the frame of the pose; from where it ends, x is negated.
  Point to_centre() const { return {gear * curve->ahead_m, side * curve->aside_m}; }
};

/// From the centre of a turn to that of the next, in the frame of the pose where they meet.
Point centre_to_centre(const GearedTurn& a, const GearedTurn& b) {
  const Point back = a.to_centre(), on = b.to_centre();
  return {on.x + back.x, on.y - back.y};
}

double anticlockwise_angle(Point vector) { return std::atan2(vector.y, vector.x); }

/// Angles of the turns; `bend` = ±1: which side of the way between the outer centres the middle one is on.
std::optional<std::array<double, 3>> angles_of(const std::array<GearedTurn, 3>& turns, const RelativePose& to,
                                               double bend) {
  const Point unit{to.cosine, to.sine}, last = turns[2].to_centre();
  const Point way = Point{to.ahead, to.left} - last.x * unit + last.y * left_of(unit) - turns[0].to_centre();
  const Point first_leg = centre_to_centre(turns[0], turns[1]),
              second_leg = centre_to_centre(turns[1], turns[2]);
  const double a = length(first_leg), b = length(second_leg), c = length(way);
  if (c > (a + b) * (1 + kTouches) || c < std::abs(a - b) || c <= kNoLine * a) return {};
  const auto corner = [](double beside, double other, double opposite) {
    const double cosine = (beside * beside + other * other - opposite * opposite) / (2 * beside * other);
    return std::acos(std::clamp(cosine, -1.0, 1.0));
  };
  const double towards = anticlockwise_angle(way);
  const double first = towards + bend * corner(a, c, b) - anticlockwise_angle(first_leg);
  const double second = towards - bend * corner(b, c, a) - anticlockwise_angle(second_leg);
  const std::array<double, 3> changes = {first, second - first, to.turn - second};
  std::array<double, 3> angles{};
  for (std::size_t i = 0; i < 3; ++i) {
    angles[i] = in_whole_circle(turns[i].side * turns[i].gear * changes[i]);
    if (angles[i] > std::numbers::pi + kNoTurnMost_rad || angles[i] <= kNoTurnAtRadius_rad) return {};
  }
  return angles;
}

}  // namespace

std::vector<Manoeuvre> three_turns(const Pose& from, const Pose& to, const TurnCurves& curves) {
  const RelativePose target = relative(from, to);
  std::vector<Manoeuvre> out;
  for (const double side : {1.0, -1.0})
    for (unsigned gears = 1; gears < 7; ++gears) {  // a bit for each turn in reverse; neither none nor all
      std::array<GearedTurn, 3> turns;
      Word word(3);
      for (std::size_t i = 0; i < 3; ++i) {
        const bool reverse = (gears >> i & 1U) != 0;
        const double turn_side = i == 1 ? -side : side;
        turns[i] = {turn_side, reverse ? -1.0 : 1.0, reverse ? &curves.reverse : &curves.forward};
        word[i] = {turn_side > 0 ? 'L' : 'R', 0, reverse ? Gear::kReverse : Gear::kForward};
      }
      for (const double bend : {1.0, -1.0}) {
        const auto angles = angles_of(turns, target, bend);
        if (!angles) continue;
        for (std::size_t i = 0; i < 3; ++i) word[i].amount = (*angles)[i];
        if (auto manoeuvre = driven(from, word, curves, ManoeuvreKind::kReedsShepp))
          out.push_back(std::move(*manoeuvre));
      }
    }
  sort_by_length(out);
  drop_repeated(out);
  return out;
}

}  // namespace tramline
