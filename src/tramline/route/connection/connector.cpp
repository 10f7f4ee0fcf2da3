#include "tramline/route/connection/connector.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "tramline/route/axle/axle_path.h"
#include "tramline/route/turning/planned_turns.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/outline/run_in.h"
#include "tramline/turns/track_ends.h"
#include "tramline/turns/turn_off.h"

namespace tramline {
namespace {

/// The machine backs out of a dead end by one of these, in radii or, where that is more, half widths.
constexpr std::array kBackSteps = {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0};
/// Where that leads nowhere it backs farther, by so much more each time and up to so much.
constexpr double kFarBackStep = 2.0, kFarthestBack = 60.0;
/// Between the distances that a way was found with and those tried before it may back others so far apart, m,
/// and so many of them at the most.
constexpr double kStepBetween_m = 0.5;
constexpr double kMostBetween = 12;
/// The machine is supposed to have come straight on by so many steps.
constexpr double kComeStraightOn = 4;
/// At a gate the machine may point anywhere; so many headings are tried.
constexpr int kGateHeadings = 16;

/// Ways without room are compared by what they lack, too little by no more than this share of it.
constexpr double kRoughly = 0.1, kAnyRoom_m = std::numeric_limits<double>::infinity();

/// A way that takes longer than this and the changes of gear is compared with backing out, s.
constexpr double kWorthBacking_s = 150;

Pose turned_back(const Pose& pose) {
  return {pose.at, Heading::clockwise_from_north(pose.heading.angle() + Angle::degrees(180))};
}

SteeredPath straight(const Pose& from, double length_m) {
  if (!(length_m > 0)) return {};
  return {arc_from(from, length_m, 0, Gear::kForward)};
}

/// Where the implement is while the axle is in this pose in line with the work.
Pose implement_pose(const Pose& axle, const Turning& turning) {
  return moved_on(axle, -reach_back_m(turning));
}

bool reverses(const SteeredStretch& stretch) { return stretch.gear == Gear::kReverse; }

bool backs(const WayEnd& end) { return !end.path.empty() && reverses(end.path.front()); }

double step_back_m(const Machine& machine) { return std::max(machine.radius_m, 0.5 * machine.width_m); }

SteeredPath joined(const SteeredPath& a, const SteeredPath& b, const SteeredPath& c) {
  SteeredPath out = a;
  out.insert(out.end(), b.begin(), b.end());
  out.insert(out.end(), c.begin(), c.end());
  return out;
}

}  // namespace

Way Connector::finished(LegKind kind, SteeredPath path) const {
  Way out;
  out.kind = kind;
  const Outline& outline = ground_.outline();
  const bool forward =
      std::all_of(path.begin(), path.end(), [](const SteeredStretch& s) { return s.gear == Gear::kForward; });
  if (outline.tows() && forward && !path.empty())
    out.lateral_error_m = std::abs(lateral_error_m(path, outline, 0));
  out.time_s = idle_seconds(path, ground_.machine().turning);
  out.cost_s = out.time_s;
  out.path = std::move(path);
  return out;
}

std::optional<Way> Connector::turn(const SteeredPath& left, const SteeredPath& entered) const {
  const Machine& machine = ground_.machine();
  const Hop hop{implement_pose(end_of(left), machine.turning),
                implement_pose(entered.front().start, machine.turning)};
  if (far_apart(hop, machine)) return std::nullopt;
  if (!has_way_off(ground_.turning(), hop.end.at, hop.end.heading, machine)) return std::nullopt;
  auto manoeuvre = turn_before_ends(hop, ground_.turning(), machine, {});
  if (!manoeuvre) return std::nullopt;
  Way out = finished(LegKind::kTurn, std::move(manoeuvre->path));
  if (out.lateral_error_m <= terms_.towing_error_m || !(terms_.towing_error_m > 0)) return out;
  const double more_m = run_in_m(out.path, ground_.outline(), terms_.towing_error_m);
  if (auto longer = turn_before_ends(hop, ground_.turning(), machine, {0, more_m}))
    out = finished(out.kind, std::move(longer->path));
  return out;
}

WayEnd Connector::straight_out(const Pose& end) const {
  const Turning& turning = ground_.machine().turning;
  return {moved_on(end, turning.lift_m), straight(end, turning.lift_m),
          turning.lift_m / turning.turning_speed_mps};
}

WayEnd Connector::straight_in(const Pose& start) const {
  const Turning& turning = ground_.machine().turning;
  const Pose before = moved_on(start, -turning.lower_m);
  return {before, straight(before, turning.lower_m), turning.lower_m / turning.turning_speed_mps};
}

bool Connector::has_room(const WayEnd& straight) const {
  return straight.path.empty() || ground_.has_room(straight.path);
}

std::vector<double> Connector::backed_m(double length_m, Backing backing) const {
  const double step_m = step_back_m(ground_.machine());
  std::vector<double> out;
  const auto add = [&](double steps) {
    if (out.empty() || out.back() < length_m) out.push_back(std::min(steps * step_m, length_m));
  };
  for (const double steps : kBackSteps) add(steps);
  if (backing == Backing::kFar)
    for (double steps = kBackSteps.back() + kFarBackStep; steps <= kFarthestBack; steps += kFarBackStep)
      add(steps);
  return out;
}

double Connector::backing_s(double back_m) const {
  const Turning& turning = ground_.machine().turning;
  return terms_.stop_s + 2 * turning.gear_change_s + back_m / turning.reverse_speed_mps;
}

WayEnd Connector::backed_out(const SteeredPath& left, double back_m) const {
  const double length_m = length(left);
  const SteeredPath back = retraced(part_of(left, length_m - back_m, length_m));
  return {end_of(back), back, backing_s(back_m)};
}

WayEnd Connector::backed_in(const SteeredPath& entered, double back_m) const {
  const SteeredPath back = retraced(part_of(entered, 0, back_m));
  return {back.front().start, back, backing_s(back_m)};
}

std::vector<WayEnd> Connector::ways_out(const SteeredPath& left, Backing backing) const {
  std::vector<WayEnd> out;
  if (WayEnd on = straight_out(end_of(left)); has_room(on)) out.push_back(std::move(on));
  if (ground_.outline().tows()) return out;
  const double length_m = length(left);
  if (!ground_.can_follow(left)) return out;
  double tried_m = 0;
  for (const double back_m : backed_m(length_m, backing)) {
    const SteeredPath farther = retraced(part_of(left, length_m - back_m, length_m - tried_m));
    if (!ground_.has_room_along(farther)) break;  // swaths may lead over a soft edge, idle machines do not
    tried_m = back_m;
    out.push_back(backed_out(left, back_m));
  }
  return out;
}

std::vector<WayEnd> Connector::ways_in(const SteeredPath& entered, Backing backing) const {
  std::vector<WayEnd> out;
  if (WayEnd in = straight_in(entered.front().start); has_room(in)) out.push_back(std::move(in));
  if (ground_.outline().tows()) return out;
  if (!ground_.can_follow(entered)) return out;
  double tried_m = 0;
  for (const double back_m : backed_m(length(entered), backing)) {
    if (!ground_.has_room_along(retraced(part_of(entered, tried_m, back_m)))) break;
    tried_m = back_m;
    out.push_back(backed_in(entered, back_m));
  }
  return out;
}

std::optional<Way> Connector::searched(const std::vector<WayEnd>& begins, const std::vector<WayEnd>& ends,
                                       const Limit& limit) const {
  auto found = quickest_way(begins, ends, roadmap_.get(), ground_, limit.no_more_than_s);
  if (!found) return std::nullopt;
  // The drawbar of a towed implement is in line at the beginning only: words had room by themselves.
  if (ground_.outline().tows() && !ground_.has_room(found->path)) return std::nullopt;
  if (limit.end != nullptr) *limit.end = found->end;
  Way out = finished(LegKind::kTransit, std::move(found->path));
  out.cost_s = found->cost_s;
  out.backs_out = backs(begins[found->begin]);
  out.backs_in = backs(ends[found->end]);
  return out;
}

Way Connector::without_room(const WayEnd& begin, const WayEnd& end) const {
  const std::vector<Manoeuvre> words = ground_.words(begin.pose, end.pose);
  const SteeredPath between = words.empty()
                                  ? shortest_dubins(begin.pose, end.pose, ground_.machine().radius_m).path
                                  : words.front().path;
  Way out = finished(LegKind::kTransit, joined(begin.path, between, end.path));
  if (!out.path.empty())
    out.missing_m = ground_.turning().missing_m(out.path, ground_.outline(), kAnyRoom_m, kRoughly);
  return out;
}

Way Connector::measured(Way way) const {
  if (!way.has_room()) way.missing_m = ground_.turning().missing_m(way.path, ground_.outline());
  return way;
}

Way Connector::between(const SteeredPath& left, const SteeredPath& entered) const {
  assert(!left.empty() && !entered.empty());
  if (auto way = turn(left, entered)) return std::move(*way);
  return to_any(left, {entered}).way;
}

SteeredPath Connector::come_straight_on(const SteeredPath& left) const {
  assert(!left.empty());
  const double before_m = kComeStraightOn * step_back_m(ground_.machine());
  return joined(straight(moved_on(left.front().start, -before_m), before_m), left, {});
}

Way Connector::between_as_come(const SteeredPath& left, const SteeredPath& entered) const {
  Way way = between(left, entered);
  if (way.has_room() || ground_.outline().tows()) return way;
  std::optional<WayToOne> supposed = without_or_with_backing(come_straight_on(left), {entered});
  if (!supposed || !supposed->way.backs_out) return way;
  supposed->way.supposed = true;
  return std::move(supposed->way);
}

std::optional<Way> Connector::direct(const Pose& left, const Pose& entered) const {
  const WayEnd out = straight_out(left), in = straight_in(entered);
  for (const Manoeuvre& word : ground_.words(out.pose, in.pose)) {
    SteeredPath path = joined(out.path, word.path, in.path);
    if (path.empty() || ground_.has_room(path)) return finished(LegKind::kTransit, std::move(path));
  }
  return std::nullopt;
}

bool Connector::leads_off(const Pose& pose) const {
  return std::ranges::any_of(ways_off(pose, ground_.machine()),
                             [&](const SteeredPath& way) { return ground_.has_room(way); });
}

Connector::Ends Connector::ends_of(const std::vector<SteeredPath>& entered, Backing backing) const {
  Ends out;
  for (std::size_t i = 0; i < entered.size(); ++i)
    for (WayEnd& end : ways_in(entered[i], backing)) {
      out.ends.push_back(std::move(end));
      out.of.push_back(i);
    }
  return out;
}

std::optional<Connector::WayToOne> Connector::without_backing(const SteeredPath& left,
                                                              const std::vector<SteeredPath>& entered) const {
  Ends straight;
  for (std::size_t i = 0; i < entered.size(); ++i) {
    const WayEnd in = straight_in(entered[i].front().start);
    if (!has_room(in) || !leads_off(turned_back(in.pose))) continue;
    straight.ends.push_back(in);
    straight.of.push_back(i);
  }
  const WayEnd begin = straight_out(end_of(left));
  if (straight.ends.empty() || !has_room(begin) || !leads_off(begin.pose)) return std::nullopt;
  std::size_t end = 0;
  auto way = searched({begin}, straight.ends, {kAnyCost_s, &end});
  if (!way) return std::nullopt;
  return WayToOne{straight.of[end], std::move(*way)};
}

std::optional<Way> Connector::without_backing(const SteeredPath& left, const SteeredPath& entered) const {
  assert(!left.empty() && !entered.empty());
  if (auto way = turn(left, entered)) return way;
  // Arms of the land are entered straight on, where no quarter turn off the end of their work has room.
  const WayEnd begin = straight_out(end_of(left)), end = straight_in(entered.front().start);
  if (!has_room(begin) || !has_room(end)) return std::nullopt;
  return searched({begin}, {end}, {kAnyCost_s, nullptr});
}

std::optional<Connector::WayToOne> Connector::without_or_with_backing(
    const SteeredPath& left, const std::vector<SteeredPath>& entered) const {
  const Turning& turning = ground_.machine().turning;
  std::optional<WayToOne> out = without_backing(left, entered);
  const double limit_s = out ? out->way.cost_s : kAnyCost_s;
  if (limit_s <= 2 * turning.gear_change_s + kWorthBacking_s) return out;
  // Where nothing else leads there it may back as far as it likes; of several places to begin another spares
  // backing far into one.
  const Backing out_of = out ? Backing::kNear : Backing::kFar;
  const Ends all = ends_of(entered, entered.size() == 1 ? out_of : Backing::kNear);
  std::size_t end = 0;
  if (auto way = searched(ways_out(left, out_of), all.ends, {limit_s, &end}))
    out = {all.of[end], std::move(*way)};
  return out;
}

std::vector<double> Connector::up_to_m(double back_m, double length_m) const {
  double before_m = 0;
  for (const double tried_m : backed_m(length_m, Backing::kFar))
    if (tried_m < back_m) before_m = tried_m;
  const double steps = std::clamp(std::ceil((back_m - before_m) / kStepBetween_m), 1.0, kMostBetween);
  std::vector<double> out;
  for (double i = 1; i <= steps; ++i) out.push_back(before_m + (back_m - before_m) * i / steps);
  return out;
}

std::vector<WayEnd> Connector::less_backed_out(const Way& way, const SteeredPath& left) const {
  if (!way.backs_out) return {straight_out(end_of(left))};
  const auto end = std::ranges::find_if_not(way.path, reverses);
  std::vector<WayEnd> out;
  for (const double back_m : up_to_m(length(SteeredPath(way.path.begin(), end)), length(left)))
    out.push_back(backed_out(left, back_m));
  return out;
}

std::vector<WayEnd> Connector::less_backed_in(const Way& way, const SteeredPath& entered) const {
  if (!way.backs_in) return {straight_in(entered.front().start)};
  const auto begin = std::ranges::find_if_not(way.path.rbegin(), way.path.rend(), reverses).base();
  std::vector<WayEnd> out;
  for (const double back_m : up_to_m(length(SteeredPath(begin, way.path.end())), length(entered)))
    out.push_back(backed_in(entered, back_m));
  return out;
}

Way Connector::or_quicker(Way way, const std::vector<WayEnd>& begins, const std::vector<WayEnd>& ends) const {
  if (!way.backs_out && !way.backs_in) return way;
  if (std::ranges::all_of(way.path, reverses)) return way;  // it backs as far as it is long
  auto found = searched(begins, ends, {way.cost_s, nullptr});
  return found ? std::move(*found) : way;
}

Way Connector::with_less_backing(const Way& way, const SteeredPath& left, const SteeredPath& entered) const {
  assert(way.has_room() && !left.empty() && !entered.empty());
  return or_quicker(way, less_backed_out(way, left), less_backed_in(way, entered));
}

Connector::WayToOne Connector::to_any(const SteeredPath& left,
                                      const std::vector<SteeredPath>& entered) const {
  assert(!entered.empty());
  if (auto way = without_or_with_backing(left, entered)) return std::move(*way);
  return {0, without_room(straight_out(end_of(left)), straight_in(entered.front().front().start))};
}

namespace {

std::vector<WayEnd> any_heading(Point at) {
  std::vector<WayEnd> out;
  for (int i = 0; i < kGateHeadings; ++i)
    out.push_back({{at, Heading::clockwise_from_north(Angle::degrees(360.0 * i / kGateHeadings))}, {}, 0});
  return out;
}

}  // namespace

Way Connector::from_gate(Point gate, const SteeredPath& entered) const {
  const std::vector<WayEnd> begins = any_heading(gate), ends = ways_in(entered, Backing::kNear);
  if (const auto way = searched(begins, ends, {kAnyCost_s, nullptr}))
    return or_quicker(*way, begins, less_backed_in(*way, entered));
  const Pose start = entered.front().start;
  const Heading towards = gate == start.at ? start.heading : Heading::from_to(gate, start.at);
  return without_room({{gate, towards}}, {start});
}

Way Connector::to_gate(const SteeredPath& left, Point gate) const {
  const std::vector<WayEnd> begins = ways_out(left, Backing::kNear), ends = any_heading(gate);
  if (const auto way = searched(begins, ends, {kAnyCost_s, nullptr}))
    return or_quicker(*way, less_backed_out(*way, left), ends);
  const Pose end = end_of(left);
  const Heading towards = gate == end.at ? end.heading : Heading::from_to(end.at, gate);
  return without_room({end}, {{gate, towards}});
}

}  // namespace tramline
