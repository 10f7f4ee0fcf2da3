#include "tramline/route/connection/connector.h"

#include <algorithm>
#include <array>
#include <cassert>

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
/// At a gate the machine may point anywhere; so many headings are tried.
constexpr int kGateHeadings = 16;

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

double step_back_m(const Machine& machine) { return std::max(machine.radius_m, 0.5 * machine.width_m); }

SteeredPath joined(const SteeredPath& a, const SteeredPath& b, const SteeredPath& c) {
  SteeredPath out = a;
  out.insert(out.end(), b.begin(), b.end());
  out.insert(out.end(), c.begin(), c.end());
  return out;
}

/// The reverse run over a path, with the change of gear before it and the one behind it.
double backing_seconds(double back_m, const Turning& turning) {
  return 2 * turning.gear_change_s + back_m / turning.reverse_speed_mps;
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
  if (out.lateral_error_m <= towing_error_m_ || !(towing_error_m_ > 0)) return out;
  const double more_m = run_in_m(out.path, ground_.outline(), towing_error_m_);
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

std::vector<WayEnd> Connector::ways_out(const SteeredPath& left) const {
  const Machine& machine = ground_.machine();
  const Turning& turning = machine.turning;
  std::vector<WayEnd> out{straight_out(end_of(left))};
  if (ground_.outline().tows()) return out;
  const double length_m = length(left);
  if (!ground_.can_follow(left)) return out;
  for (const double steps : kBackSteps) {
    const double back_m = std::min(steps * step_back_m(machine), length_m);
    const SteeredPath back = retraced(part_of(left, length_m - back_m, length_m));
    if (!ground_.has_room_along(back)) break;  // swaths may lead over a soft edge, idle machines do not
    out.push_back({end_of(back), back, backing_seconds(back_m, turning)});
    if (back_m >= length_m) break;
  }
  return out;
}

std::vector<WayEnd> Connector::ways_in(const SteeredPath& entered) const {
  const Machine& machine = ground_.machine();
  const Turning& turning = machine.turning;
  std::vector<WayEnd> out{straight_in(entered.front().start)};
  if (ground_.outline().tows()) return out;
  const double length_m = length(entered);
  if (!ground_.can_follow(entered)) return out;
  for (const double steps : kBackSteps) {
    const double back_m = std::min(steps * step_back_m(machine), length_m);
    const SteeredPath back = retraced(part_of(entered, 0, back_m));
    if (!ground_.has_room_along(back)) break;
    out.push_back({back.front().start, back, backing_seconds(back_m, turning)});
    if (back_m >= length_m) break;
  }
  return out;
}

std::optional<Way> Connector::searched(const std::vector<WayEnd>& begins, const std::vector<WayEnd>& ends,
                                       std::size_t backing_begins, const Limit& limit) const {
  auto found = quickest_way(begins, ends, roadmap_.get(), ground_, limit.no_more_than_s);
  if (!found) return std::nullopt;
  // The drawbar of a towed implement is in line at the beginning only: words had room by themselves.
  if (ground_.outline().tows() && !ground_.has_room(found->path)) return std::nullopt;
  if (limit.end != nullptr) *limit.end = found->end;
  const SteeredPath& in = ends[found->end].path;
  Way out = finished(LegKind::kTransit, std::move(found->path));
  out.cost_s = found->cost_s;
  out.backs_out = found->begin >= backing_begins;
  out.backs_in = !in.empty() && in.front().gear == Gear::kReverse;
  return out;
}

Way Connector::without_room(const Pose& from, const Pose& to) const {
  const std::vector<Manoeuvre> words = ground_.words(from, to);
  Way out =
      finished(LegKind::kTransit, words.empty() ? shortest_dubins(from, to, ground_.machine().radius_m).path
                                                : words.front().path);
  if (!out.path.empty()) out.missing_m = ground_.turning().missing_m(out.path, ground_.outline());
  return out;
}

Way Connector::between(const SteeredPath& left, const SteeredPath& entered) const {
  assert(!left.empty() && !entered.empty());
  if (auto way = turn(left, entered)) return std::move(*way);
  return to_any(left, {entered}).way;
}

std::optional<Way> Connector::direct(const SteeredPath& left, const SteeredPath& entered) const {
  const WayEnd out = straight_out(end_of(left)), in = straight_in(entered.front().start);
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

std::optional<Connector::WayToOne> Connector::without_or_with_backing(
    const std::vector<WayEnd>& begins, const std::vector<std::vector<WayEnd>>& ends) const {
  const Turning& turning = ground_.machine().turning;
  std::vector<WayEnd> all_ends, straight_ends;
  std::vector<std::size_t> of_all, of_straight;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (const WayEnd& end : ends[i]) {
      all_ends.push_back(end);
      of_all.push_back(i);
    }
    if (!leads_off(turned_back(ends[i].front().pose))) continue;
    straight_ends.push_back(ends[i].front());
    of_straight.push_back(i);
  }
  std::optional<WayToOne> out;
  std::size_t end = 0;
  if (!straight_ends.empty() && leads_off(begins.front().pose))
    if (auto way = searched({begins.front()}, straight_ends, 1, {kAnyCost_s, &end}))
      out = {of_straight[end], std::move(*way)};
  const double limit_s = out ? out->way.cost_s : kAnyCost_s;
  if (limit_s <= 2 * turning.gear_change_s + kWorthBacking_s) return out;
  if (auto way = searched(begins, all_ends, 1, {limit_s, &end})) out = {of_all[end], std::move(*way)};
  return out;
}

Connector::WayToOne Connector::to_any(const SteeredPath& left,
                                      const std::vector<SteeredPath>& entered) const {
  assert(!entered.empty());
  const std::vector<WayEnd> begins = ways_out(left);
  std::vector<std::vector<WayEnd>> ends;
  for (const SteeredPath& one : entered) ends.push_back(ways_in(one));
  if (auto way = without_or_with_backing(begins, ends)) return std::move(*way);
  const WayEnd in = straight_in(entered.front().front().start);
  Way out = without_room(begins.front().pose, in.pose);
  out.path = joined(begins.front().path, out.path, in.path);
  out.time_s = out.cost_s = idle_seconds(out.path, ground_.machine().turning);
  return {0, std::move(out)};
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
  const std::vector<WayEnd> begins = any_heading(gate), ends = ways_in(entered);
  if (auto way = searched(begins, ends, begins.size(), {kAnyCost_s, nullptr})) return std::move(*way);
  const Pose start = entered.front().start;
  const Heading towards = gate == start.at ? start.heading : Heading::from_to(gate, start.at);
  return without_room({gate, towards}, start);
}

Way Connector::to_gate(const SteeredPath& left, Point gate) const {
  const std::vector<WayEnd> begins = ways_out(left), ends = any_heading(gate);
  if (auto way = searched(begins, ends, 1, {kAnyCost_s, nullptr})) return std::move(*way);
  const Pose end = end_of(left);
  const Heading towards = gate == end.at ? end.heading : Heading::from_to(end.at, gate);
  return without_room(end, {gate, towards});
}

}  // namespace tramline
