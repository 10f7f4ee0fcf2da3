#include "tramline/turns/manoeuvres/unequal_arcs.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/turns/manoeuvres/driven_word.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/omega_turn.h"
#include "tramline/turns/manoeuvres/relative_pose.h"
#include "tramline/turns/manoeuvres/u_turn.h"
#include "tramline/turns/tolerances.h"

namespace tramline {
namespace {

Pose led_on(const Pose& pose, double by_m) { return {pose.at + by_m * pose.heading.unit(), pose.heading}; }

/// Puts a line before or after a manoeuvre; joins it with one that is there.
Manoeuvre with_lead(Manoeuvre turn, const Pose& from, double lead_m) {
  turn.kind = ManoeuvreKind::kUnequalArcs;
  const auto is_line = [](const SteeredStretch& stretch) {
    return !stretch.clothoid() && stretch.curvature_at_start == 0 && stretch.gear == Gear::kForward;
  };
  if (lead_m > 0) {
    if (is_line(turn.path.front())) {
      turn.path.front() = arc_from(from, lead_m + turn.path.front().length_m, 0, Gear::kForward);
      return turn;
    }
    turn.path.insert(turn.path.begin(), arc_from(from, lead_m, 0, Gear::kForward));
    turn.word.insert(turn.word.begin(), 'S');
  } else {
    if (is_line(turn.path.back())) {
      turn.path.back().length_m -= lead_m;
      return turn;
    }
    turn.path.push_back(arc_from(end_of(turn.path.back()), -lead_m, 0, Gear::kForward));
    turn.word += 'S';
  }
  return turn;
}

}  // namespace

std::optional<Manoeuvre> unequal_arcs(const Pose& from, const Pose& to, const TurnCurve& curve) {
  std::vector<Manoeuvre> words = dubins_words(from, to, curve);
  const auto unequal = std::find_if(words.begin(), words.end(), [](const Manoeuvre& word) {
    return word.kind == ManoeuvreKind::kUnequalArcs;
  });
  if (unequal == words.end()) return {};
  return std::move(*unequal);
}

std::optional<Manoeuvre> unequal_arcs(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  return unequal_arcs(from, to, arc_turn(radius_m));
}

std::optional<Manoeuvre> lead_and_turn(const Pose& from, const Pose& to, const TurnCurve& curve) {
  const RelativePose target = relative(from, to);
  if (target.cosine >= 0) return {};
  // level: the way between the poses points along the middle of their headings
  const double half = 0.5 * target.turn;
  const double lead_m = target.ahead - target.left / std::tan(half);
  if (std::abs(lead_m) <= kEqualArcs_rad * curve.radius_m) return {};
  const Pose level_from = lead_m > 0 ? led_on(from, lead_m) : from;
  const Pose level_to = lead_m > 0 ? to : led_on(to, lead_m);
  std::optional<Manoeuvre> turn = u_turn(level_from, level_to, curve);
  if (!turn) turn = omega_turn(level_from, level_to, curve);
  if (!turn) return {};
  return with_lead(std::move(*turn), from, lead_m);
}

std::optional<Manoeuvre> lead_and_turn(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  return lead_and_turn(from, to, arc_turn(radius_m));
}

}  // namespace tramline
