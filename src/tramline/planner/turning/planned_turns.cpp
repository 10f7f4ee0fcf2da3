#include "tramline/planner/turning/planned_turns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/turns/manoeuvres/manoeuvre_choice.h"
#include "tramline/turns/outline/run_in.h"
#include "tramline/turns/track_ends.h"

namespace tramline {
namespace {

/// Of manoeuvres without room so many are asked how much they lack.
constexpr std::size_t kMostMeasured = 4;
/// A hop farther than so many times the width of a turn is more than a turn.
constexpr double kFar_turns = 3;

/// The manoeuvre with the straight ways on which the implement is lifted before it and, after it, driven in
/// line and lowered.
Manoeuvre whole(Manoeuvre manoeuvre, const Hop& hop, const Turning& turning, double run_in_m) {
  SteeredPath path;
  const double back_m = reach_back_m(turning);
  const auto add_straight = [&path](const Pose& from, double length_m) {
    if (length_m > 0) path.push_back({from, length_m});
  };
  add_straight({hop.end.at + back_m * hop.end.heading.unit(), hop.end.heading}, turning.lift_m);
  path.insert(path.end(), manoeuvre.path.begin(), manoeuvre.path.end());
  const double before_m = turning.lower_m + run_in_m;
  add_straight({hop.start.at + (back_m - before_m) * hop.start.heading.unit(), hop.start.heading}, before_m);
  manoeuvre.path = std::move(path);
  return manoeuvre;
}

bool far_apart(const Hop& hop, const Machine& machine) {
  return distance(hop.end.at, hop.start.at) > kFar_turns * (2 * machine.radius_m + 2 * machine.width_m);
}

/// The quickest way with room, or else the one that lacks least.
PlannedTurn best_of(const std::vector<Manoeuvre>& ways, const AllowedLand& land, const Outline& outline) {
  PlannedTurn out;
  for (const Manoeuvre& way : ways) {
    if (!land.fits(way.path, outline)) continue;
    out.manoeuvre = way;
    return out;
  }
  out.state = TurnState::kNoRoom;
  for (std::size_t i = 0; i < std::min(ways.size(), kMostMeasured); ++i) {
    const double missing_m = land.missing_m(ways[i].path, outline);
    if (i > 0 && missing_m >= out.missing_m) continue;
    out.missing_m = missing_m;
    out.manoeuvre = ways[i];
  }
  return out;
}

/// How far beside its track the implement is where the work begins: the lowering is done by then.
double error_of(const PlannedTurn& turn, const Outline& outline) {
  if (!outline.tows() || turn.manoeuvre.path.empty()) return 0;
  return std::abs(lateral_error_m(turn.manoeuvre.path, outline, 0));
}

PlannedTurn turn_over(const Hop& hop, const AllowedLand& land, const Machine& machine,
                      double towing_error_m) {
  const Outline outline = outline_of(machine);
  PlannedTurn out = best_of(manoeuvres_over(hop, machine, 0), land, outline);
  out.lateral_error_m = error_of(out, outline);
  if (out.lateral_error_m > towing_error_m && towing_error_m > 0) {
    const double more_m = run_in_m(out.manoeuvre.path, outline, towing_error_m);
    PlannedTurn longer = best_of(manoeuvres_over(hop, machine, more_m), land, outline);
    if (longer.state == TurnState::kFits || out.state != TurnState::kFits) {
      out = std::move(longer);
      out.lateral_error_m = error_of(out, outline);
    }
  }
  if (out.state == TurnState::kNoRoom && far_apart(hop, machine)) out.state = TurnState::kApart;
  out.time_s = seconds(out.manoeuvre, machine);
  return out;
}

}  // namespace

Hop hop_between(const TrackPiece& from, const TrackPiece& to) {
  const Point ahead = from.curve.empty() ? from.end - from.start : direction_at_end(from.curve.back());
  const Point on = to.curve.empty() ? to.end - to.start : direction_at_start(to.curve.front());
  return {{from.end, Heading::from_to({0, 0}, ahead)}, {to.start, Heading::from_to({0, 0}, on)}};
}

std::vector<Manoeuvre> manoeuvres_over(const Hop& hop, const Machine& machine, double run_in_m) {
  const Pose from = pose_after_work(hop.end.at, hop.end.heading, machine.turning);
  Pose to = pose_before_work(hop.start.at, hop.start.heading, machine.turning);
  to.at = to.at - run_in_m * to.heading.unit();
  std::vector<Manoeuvre> out;
  for (Manoeuvre& manoeuvre : manoeuvres_between(from, to, machine))
    out.push_back(whole(std::move(manoeuvre), hop, machine.turning, run_in_m));
  return out;
}

std::vector<PlannedTurn> planned_turns(const AllowedLand& land, const Machine& machine,
                                       const std::vector<TrackPiece>& pieces, double towing_error_m) {
  std::vector<PlannedTurn> out;
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    if (pieces[i + 1].after_crossing) continue;
    out.push_back(turn_over(hop_between(pieces[i], pieces[i + 1]), land, machine, towing_error_m));
    out.back().after = i;
  }
  return out;
}

}  // namespace tramline
