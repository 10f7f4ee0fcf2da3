#include "tramline/turns/manoeuvres/fishtail.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "tramline/turns/manoeuvres/driven_word.h"
#include "tramline/turns/manoeuvres/dubins_solutions.h"

namespace tramline {
namespace {

/// The same as a U whose line has the length −p: from one centre to the other the machine's heading d takes
/// 2a − p, so p = 2a + |c| with d against the way c between the centres, or p = 2a − |c| with d along it.
std::optional<TurnLineTurn> left_back_left(const RelativePose& to, const TurnCurve& curve) {
  const Point way = between_centres(to, curve, TurnSide::kLeft);
  const double distance_m = std::sqrt(dot(way, way));
  const bool one_turn = distance_m <= kNoLine * curve.radius_m;
  for (const double sense : {-1.0, 1.0}) {
    const double first = one_turn ? 0.5 * to.turn : in_whole_circle(std::atan2(sense * way.y, sense * way.x));
    const double line_m = 2 * curve.ahead_m - sense * distance_m, last = to.turn - first;
    if (line_m > kNoLine * curve.radius_m && first > 0 && last > 0 && first < std::numbers::pi &&
        last < std::numbers::pi)
      return TurnLineTurn{first, line_m, last};
  }
  return {};
}

TurnSide opposite(TurnSide side) { return side == TurnSide::kLeft ? TurnSide::kRight : TurnSide::kLeft; }

}  // namespace

std::vector<Manoeuvre> fishtails(const Pose& from, const Pose& to, const TurnCurves& curves) {
  const RelativePose target = relative(from, to);
  std::vector<Manoeuvre> out;
  if (target.cosine >= 0) return out;
  const TurnSide towards = target.left > 0 ? TurnSide::kLeft : TurnSide::kRight;
  for (const TurnSide side : {towards, opposite(towards)}) {
    const bool left = side == TurnSide::kLeft;
    const auto word = left_back_left(left ? target : target.mirrored(), curves.forward);
    if (!word) break;
    const char letter = left ? 'L' : 'R';
    if (auto manoeuvre =
            driven(from, {{letter, word->first}, {'S', word->line_m, Gear::kReverse}, {letter, word->last}},
                   curves, ManoeuvreKind::kFishtail))
      out.push_back(std::move(*manoeuvre));
  }
  sort_by_length(out);
  return out;
}

std::optional<Manoeuvre> fishtail(const Pose& from, const Pose& to, const TurnCurves& curves) {
  std::vector<Manoeuvre> both = fishtails(from, to, curves);
  if (both.empty()) return {};
  return std::move(both.front());
}

std::optional<Manoeuvre> fishtail(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  return fishtail(from, to, arc_turns(radius_m));
}

}  // namespace tramline
