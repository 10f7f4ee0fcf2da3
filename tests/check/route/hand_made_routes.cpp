#include "check/route/hand_made_routes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tramline/check/verify.h"
#include "tramline/route/build/driven_over.h"
#include "tramline/turns/manoeuvres/dubins.h"

namespace tramline::testing_plans {

Heading towards(double degrees) { return Heading::clockwise_from_north(Angle::degrees(degrees)); }

RouteLeg leg(LegKind kind, Gear gear, SteeredPath path) {
  RouteLeg out;
  out.kind = kind;
  out.gear = gear;
  out.path = std::move(path);
  out.work = kind == LegKind::kWork || kind == LegKind::kHeadland;
  return out;
}

Plan timed(Plan plan) {
  const Turning& turning = plan.machine.turning;
  Gear before = Gear::kForward;
  for (RouteLeg& of : plan.route.legs) {
    const double idle = of.gear == Gear::kForward ? turning.turning_speed_mps : turning.reverse_speed_mps;
    of.time_s = length(of) / (of.work ? turning.working_speed_mps : idle);
    if (of.gear != before) of.time_s += turning.gear_change_s;
    before = of.gear;
  }
  return plan;
}

SteeredPath driven(const Path& path) {
  SteeredPath out;
  for (const PathSegment& segment : path)
    out.push_back({{segment.from, Heading::from_to({0, 0}, direction_at_start(segment))},
                   length(segment),
                   segment.curvature,
                   segment.curvature});
  return out;
}

void add(Plan& plan, RouteLeg of) { plan.route.legs.push_back(std::move(of)); }

void add_piece_leg(Plan& plan, std::size_t piece) {
  RouteLeg of = leg(LegKind::kWork, Gear::kForward, driven(centre_line(plan.pieces[piece])));
  of.piece = piece;
  add(plan, std::move(of));
}

void add_pass_leg(Plan& plan, std::size_t pass, const Path& way) {
  RouteLeg of = leg(LegKind::kHeadland, Gear::kForward, driven(way));
  of.pass = pass;
  add(plan, std::move(of));
}

namespace {

Pose end_of_route(const Plan& plan) { return end_of(plan.route.legs.back().path.back()); }

}  // namespace

void add_way(Plan& plan, LegKind kind, const std::vector<std::pair<double, double>>& parts, Gear gear) {
  RouteLeg of = leg(kind, gear, {});
  Pose at = end_of_route(plan);
  for (const auto& [length_m, curvature] : parts) {
    of.path.push_back(arc_from(at, length_m, curvature, gear));
    at = end_of(of.path.back());
  }
  add(plan, std::move(of));
}

Plan route_plan() {
  Plan plan;
  plan.field.id = "route";
  plan.field.outer = box(0, 0, 200, 48);
  plan.machine.width_m = 12;
  plan.machine.radius_m = 6;
  plan.settings.turns = TurnPlanning::kRoute;
  plan.body = {{plan.field.outer, {}}};
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(90))}};
  for (int i = 0; i < 4; ++i) {
    TrackPiece piece{{0, 12.0 * i + 6}, {200, 12.0 * i + 6}, 0, i};
    if (i % 2 == 1) std::swap(piece.start, piece.end);
    plan.pieces.push_back(piece);
  }
  plan = settled(plan);
  const double half = std::numbers::pi * 6;
  for (std::size_t i = 0; i < 4; ++i) {
    add_piece_leg(plan, i);
    if (i < 3) add_way(plan, LegKind::kTurn, {{half, i % 2 == 0 ? 1.0 / 6 : -1.0 / 6}});
  }
  add_way(plan, LegKind::kBackOut, {{12, 0}}, Gear::kReverse);
  add_way(plan, LegKind::kTransit, {{6, 0}});
  plan.settings.route.start = {{0, 6}};
  plan.settings.route.end = {{6, 42}};
  plan.route.proof.node_prices_s.assign(10, 0);
  plan.route.over_worked_m = plan.route.over_tracks_m = 18;
  return timed(plan);
}

void add_shortest(Plan& plan, const Pose& to) {
  RouteLeg of = leg(LegKind::kTransit, Gear::kForward,
                    shortest_dubins(end_of_route(plan), to, plan.machine.radius_m).path);
  of.missing_m = 100;
  if (!of.path.empty()) add(plan, std::move(of));
}

namespace {

/// The same closed path from the beginning of another of its segments.
Path entered_at(Path path, std::ptrdiff_t segment) {
  std::rotate(path.begin(), path.begin() + segment, path.end());
  return path;
}

}  // namespace

Plan passes_plan() {
  Plan plan = headland_plan(2);
  plan.settings.turns = TurnPlanning::kRoute;
  plan.headland.passes[1].path.pop_back();
  plan = settled(plan);
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    if (i > 0) add_shortest(plan, driven(centre_line(plan.pieces[i])).front().start);
    add_piece_leg(plan, i);
  }
  add_shortest(plan, driven(plan.headland.passes[1].path).front().start);
  add_pass_leg(plan, 1, plan.headland.passes[1].path);
  const Path round = entered_at(reversed(plan.headland.passes[0].path), 2);
  add_shortest(plan, driven(round).front().start);
  add_pass_leg(plan, 0, round);
  // Two for each track and for the pass that is open now, one for the closed one.
  plan.route.proof.node_prices_s.assign(2 * plan.pieces.size() + 2 + 1, 0);
  add_driven_over(plan);
  return timed(plan);
}

double time_of(const Plan& plan) { return sums_of(plan.route).time_s; }

std::string texts(const Plan& plan) {
  std::string out;
  for (const check::Violation& v : check::verify(plan).violations)
    out += std::string(name(v.rule)) + ": " + v.what + "\n";
  return out;
}

void expect_found(const Plan& plan, const std::string& rule) {
  EXPECT_TRUE(found(plan).contains(rule)) << "no violation of " << rule << " among\n" << texts(plan);
}
void expect_only(const Plan& plan, const std::string& rule) {
  EXPECT_EQ(found(plan), Names{rule}) << texts(plan);
}

}  // namespace tramline::testing_plans
