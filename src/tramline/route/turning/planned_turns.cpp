#include "tramline/route/turning/planned_turns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/route/turning/stops.h"
#include "tramline/turns/manoeuvres/manoeuvre_choice.h"
#include "tramline/turns/manoeuvres/reach.h"
#include "tramline/turns/outline/run_in.h"
#include "tramline/turns/track_ends.h"

namespace tramline {
namespace {

/// Of manoeuvres without room so many are asked how much they lack.
constexpr std::size_t kMostMeasured = 4;
/// A hop farther than so many times the width of a turn is more than a turn.
constexpr double kFar_turns = 3;

/// The ways on which the implement is lifted, and driven in line and lowered: before a manoeuvre and after
/// it.
struct StraightPaths {
  SteeredPath before, after;
};

SteeredPath straight(const Pose& from, double length_m) {
  if (!(length_m > 0)) return {};
  return {{from, length_m}};
}

StraightPaths straight_paths(const Hop& hop, const Turning& turning, const StraightWays& more) {
  const double back_m = reach_back_m(turning), in_line_m = turning.lower_m + more.after_m;
  return {straight({hop.end.at + back_m * hop.end.heading.unit(), hop.end.heading},
                   turning.lift_m + more.before_m),
          straight({hop.start.at + (back_m - in_line_m) * hop.start.heading.unit(), hop.start.heading},
                   in_line_m)};
}

/// Whether there is room for them at least. An implement in tow is not in line yet where it is lowered, and
/// paths with clothoids are given more room than straight ones: there nothing is ruled out.
bool straight_ways_fit(const Hop& hop, const StraightWays& more, const AllowedLand& land,
                       const Machine& machine) {
  if (machine.turning.steering_time_s > 0) return true;
  const Outline outline = outline_of(machine);
  const StraightPaths ways = straight_paths(hop, machine.turning, more);
  return land.fits(ways.before, outline) && (outline.tows() || land.fits(ways.after, outline));
}

/// The manoeuvre with the straight ways before and after it.
Manoeuvre whole(Manoeuvre manoeuvre, const Hop& hop, const Turning& turning, const StraightWays& more) {
  const StraightPaths ways = straight_paths(hop, turning, more);
  SteeredPath path = ways.before;
  path.insert(path.end(), manoeuvre.path.begin(), manoeuvre.path.end());
  path.insert(path.end(), ways.after.begin(), ways.after.end());
  manoeuvre.path = std::move(path);
  return manoeuvre;
}

/// The axle may be so far behind the ends of the tracks on the way, m: it is the implement that works them.
constexpr double kBehindEnds_m = 0.5;

/// The line through both ends, or square to the track where they lie one behind the other.
bool leads_over_tracks(const SteeredPath& path, const Pose& from, const Pose& to) {
  constexpr double kLeastSlope = 0.3;
  const Point ahead = from.heading.unit(), across = to.at - from.at;
  Point outward = ahead;
  if (const double apart_m = length(across); apart_m > 0) {
    const Point normal = (1 / apart_m) * left_of(across);
    const double slope = dot(normal, ahead);
    if (std::abs(slope) >= kLeastSlope) outward = slope > 0 ? normal : -1.0 * normal;
  }
  return reach(path, -1.0 * outward) > kBehindEnds_m;
}

/// The poses between which a hop's manoeuvre turns.
struct HopPoses {
  Pose from, to;
};

HopPoses poses_of(const Hop& hop, const Machine& machine, const StraightWays& more) {
  HopPoses out{pose_after_work(hop.end.at, hop.end.heading, machine.turning),
               pose_before_work(hop.start.at, hop.start.heading, machine.turning)};
  out.from.at = out.from.at + more.before_m * out.from.heading.unit();
  out.to.at = out.to.at - more.after_m * out.to.heading.unit();
  return out;
}

Machine on_circles(Machine machine) {
  machine.radius_m = std::max(machine.radius_m, kLeastRadius_m);
  return machine;
}

/// The quickest of manoeuvres_over() that stays before the ends of the tracks and has room.
std::optional<Manoeuvre> first_before_ends(const Hop& hop, const AllowedLand& land, const Machine& machine,
                                           const Outline& outline, const StraightWays& ways) {
  const auto [from, to] = poses_of(hop, machine, ways);
  for (Manoeuvre& manoeuvre : manoeuvres_between(from, to, on_circles(machine))) {
    if (leads_over_tracks(manoeuvre.path, from, to)) continue;
    Manoeuvre out = whole(std::move(manoeuvre), hop, machine.turning, ways);
    if (land.fits(out.path, outline)) return out;
  }
  return std::nullopt;
}

/// The quickest with room of those that lead over tracks; nullptr where there is none.
const Manoeuvre* first_over_tracks(const std::vector<HopWay>& ways, const AllowedLand& land,
                                   const Outline& outline) {
  for (const HopWay& way : ways)
    if (way.over_tracks && land.fits(way.manoeuvre.path, outline)) return &way.manoeuvre;
  return nullptr;
}

PlannedTurn fitting(const Manoeuvre& manoeuvre) {
  PlannedTurn out;
  out.manoeuvre = manoeuvre;
  return out;
}

/// Of ways without room the one that lacks least.
PlannedTurn without_room(const std::vector<HopWay>& ways, const AllowedLand& land, const Outline& outline) {
  PlannedTurn out;
  out.state = TurnState::kNoRoom;
  for (std::size_t i = 0; i < std::min(ways.size(), kMostMeasured); ++i) {
    const double enough_m = i > 0 ? out.missing_m : std::numeric_limits<double>::infinity();
    const double missing_m = land.missing_m(ways[i].manoeuvre.path, outline, enough_m);
    if (i > 0 && missing_m >= enough_m) continue;
    out.missing_m = missing_m;
    out.manoeuvre = ways[i].manoeuvre;
  }
  return out;
}

/// How far beside its track the implement is where the work begins: the lowering is done by then.
double error_of(const PlannedTurn& turn, const Outline& outline) {
  if (!outline.tows() || turn.manoeuvre.path.empty()) return 0;
  return std::abs(lateral_error_m(turn.manoeuvre.path, outline, 0));
}

/// turn_before_ends(), or the quickest of those that lead back over the tracks.
PlannedTurn with_straight_ways(const Hop& hop, const AllowedLand& land, const Machine& machine,
                               const StraightWays& least) {
  if (const std::optional<Manoeuvre> before = turn_before_ends(hop, land, machine, least))
    return fitting(*before);
  const Outline outline = outline_of(machine);
  const std::vector<HopWay> direct = manoeuvres_over(hop, machine, least);
  if (const Manoeuvre* fits = first_over_tracks(direct, land, outline)) return fitting(*fits);
  return without_room(direct, land, outline);
}

PlannedTurn turn_over(const Hop& hop, const AllowedLand& land, const Machine& machine,
                      double towing_error_m) {
  const Outline outline = outline_of(machine);
  PlannedTurn out = with_straight_ways(hop, land, machine, {});
  out.lateral_error_m = error_of(out, outline);
  if (out.lateral_error_m > towing_error_m && towing_error_m > 0) {
    const double more_m = run_in_m(out.manoeuvre.path, outline, towing_error_m);
    PlannedTurn longer = with_straight_ways(hop, land, machine, {0, more_m});
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

bool far_apart(const Hop& hop, const Machine& machine) {
  return distance(hop.end.at, hop.start.at) > kFar_turns * (2 * machine.radius_m + 2 * machine.width_m);
}

std::optional<Manoeuvre> turn_before_ends(const Hop& hop, const AllowedLand& land, const Machine& machine,
                                          const StraightWays& least) {
  constexpr int kMostSteps = 6;
  const Outline outline = outline_of(machine);
  const double step_m = 0.5 * std::max(machine.radius_m, machine.width_m);
  const auto with_ways = [&](const StraightWays& ways) {
    return first_before_ends(hop, land, machine, outline, ways);
  };
  if (auto direct = with_ways(least)) return direct;
  if (far_apart(hop, machine)) return std::nullopt;
  const auto has_room = [&](const StraightWays& ways) { return straight_ways_fit(hop, ways, land, machine); };
  int most_before = 0, most_after = 0;
  while (most_before < kMostSteps && has_room({least.before_m + (most_before + 1) * step_m, 0}))
    ++most_before;
  while (most_after < kMostSteps && has_room({0, least.after_m + (most_after + 1) * step_m})) ++most_after;
  for (int sum = 1; sum <= std::min(kMostSteps, most_before + most_after); ++sum)
    for (int before = std::max(0, sum - most_after); before <= std::min(sum, most_before); ++before)
      if (auto fits = with_ways({least.before_m + before * step_m, least.after_m + (sum - before) * step_m}))
        return fits;
  return std::nullopt;
}

Hop hop_between(const TrackPiece& from, const TrackPiece& to) {
  const Point ahead = from.curve.empty() ? from.end - from.start : direction_at_end(from.curve.back());
  const Point on = to.curve.empty() ? to.end - to.start : direction_at_start(to.curve.front());
  return {{from.end, Heading::from_to({0, 0}, ahead)}, {to.start, Heading::from_to({0, 0}, on)}};
}

std::vector<HopWay> manoeuvres_over(const Hop& hop, const Machine& machine, const StraightWays& more) {
  const auto [from, to] = poses_of(hop, machine, more);
  std::vector<HopWay> out;
  for (Manoeuvre& manoeuvre : manoeuvres_between(from, to, on_circles(machine))) {
    const bool over_tracks = leads_over_tracks(manoeuvre.path, from, to);
    out.push_back({whole(std::move(manoeuvre), hop, machine.turning, more), over_tracks});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const HopWay& a, const HopWay& b) { return !a.over_tracks && b.over_tracks; });
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

int plan_turns(const AllowedLand& land, Plan& plan) {
  plan.turns = planned_turns(land, plan.machine, plan.pieces, plan.settings.towing_error_m);
  plan.stop_rule = StopRule::kNoWayOff;
  return mark_stops(land, plan.machine, plan.pieces);
}

}  // namespace tramline
