#include "check/plans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "tramline/check/measure/bands.h"
#include "tramline/check/verify.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/strip/track_frame.h"
#include "tramline/geometry/tolerances.h"

namespace tramline::testing_plans {
namespace {

const Direction kEast = Direction::clockwise_from_north(Angle::degrees(90));

/// Adds a piece along a horizontal centre line, driven east on even tracks and west on odd ones.
void add_piece(Plan& plan, int track, double y, double from_x, double to_x, std::size_t subfield = 0) {
  TrackPiece piece{{from_x, y}, {to_x, y}, subfield, track};
  if (track % 2 == 1) std::swap(piece.start, piece.end);
  plan.pieces.push_back(piece);
}

Plan bare_rectangle() {
  Plan plan;
  plan.field.id = "rectangle";
  plan.field.outer = box(0, 0, 100, 30);
  plan.machine.width_m = 3;
  plan.body = {{plan.field.outer, {}}};
  plan.subfields = {{plan.body[0], kEast}};
  return plan;
}

/// Faulty swaths may fold over themselves.
Region sound(const Polygon& ground) { return find_invalidity(ground) ? made_valid(ground) : Region{ground}; }

void settle_headland(Plan& plan) {
  Headland& headland = plan.headland;
  Region bands, passables;
  for (const Obstacle& obstacle : plan.field.obstacles)
    if (obstacle.kind == ObstacleKind::kPassable) passables.push_back(obstacle.shape);
  headland.worked_m2 = plan.machine.width_m * length(headland);
  for (const HeadlandPass& pass : headland.passes)
    for (const PathSegment& segment : pass.path)
      for (Polygon& part : sound({band({segment}, plan.machine.width_m), {}})) {
        headland.worked_m2 -= area(intersection({part}, passables));
        bands.push_back(std::move(part));
      }
  headland.unworked = difference(headland.ground, unite(bands));
  headland.uncovered_m2 = area(headland.unworked);
  headland.overlap_m2 = headland.worked_m2 - area(headland.ground) + headland.uncovered_m2;
}

Point on_circle(double radius_m, double degrees) {
  const double radians = degrees * std::numbers::pi / 180;
  return {radius_m * std::cos(radians), radius_m * std::sin(radians)};
}

Path arc_about_origin(double radius_m, double from_deg, double to_deg) {
  return {{on_circle(radius_m, from_deg), on_circle(radius_m, to_deg), 1 / radius_m}};
}

}  // namespace

Plan settled(Plan plan) {
  Region worked, parts;
  for (const TrackPiece& piece : plan.pieces) {
    Region ground = check::bands_along(piece.curve, plan.machine.width_m, kLayerSagitta);
    if (piece.curve.empty()) {
      for (const Ring& ring : swath_parts(piece, plan.machine.width_m, kLayerSagitta))
        for (Polygon& part : sound({ring, {}})) parts.push_back(std::move(part));
      ground = sound({swath(piece, plan.machine.width_m), {}});
    } else {
      parts.insert(parts.end(), ground.begin(), ground.end());
    }
    worked.insert(worked.end(), ground.begin(), ground.end());
  }
  for (const HeadlandPass& pass : plan.headland.passes)
    for (const PathSegment& segment : pass.path)
      for (Polygon& part : sound({band({segment}, plan.machine.width_m, kLayerSagitta), {}})) {
        worked.push_back(part);
        parts.push_back(std::move(part));
      }
  const Region all_worked = unite(worked), land = unite(plan.body, plan.headland.ground);
  plan.overlap = difference(all_worked, land);
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (intersects(bounds(parts[i]), bounds(parts[j])))
        for (Polygon& both : intersection({parts[i]}, {parts[j]}))
          if (area(both) > kLayerSagitta * perimeter(both.outer)) plan.overlap.push_back(std::move(both));
  plan.overlap = unite(plan.overlap);
  plan.uncovered = difference(land, all_worked);
  settle_headland(plan);
  const check::Verdict verdict = check::verify(plan);
  plan.tally = verdict.recomputed;
  plan.track_tally = verdict.track_tally;
  plan.cost = cost(plan.objective, plan.tally);
  return plan;
}

Plan rectangle_plan() {
  Plan plan = bare_rectangle();
  for (int i = 0; i < 10; ++i) add_piece(plan, i, 3 * i + 1.5, 0, 100);
  return settled(plan);
}

Plan triangle_plan(EndRule rule, double f) {
  Plan plan;
  plan.field.id = "triangle";
  plan.field.outer = {{0, 0}, {100, 0}, {0, 40}};
  plan.machine.width_m = 4;
  plan.machine.min_length_m = 1;
  plan.settings.end_rule = rule;
  plan.body = {{plan.field.outer, {}}};
  plan.subfields = {{plan.body[0], kEast}};
  for (int i = 0; i < 10; ++i) {
    const double end_x = 2.5 * (40 - 4 * (i + f));
    if (end_x >= 1) add_piece(plan, i, 4 * i + 2, 0, end_x);
  }
  return settled(plan);
}

Plan obstacle_plan() {
  Plan plan = bare_rectangle();
  plan.field.obstacles = {{{box(40, 11, 60, 13), {}}, ObstacleKind::kObstacle, "pylon"}};
  plan.body[0].holes = {reversed(box(40, 11, 60, 13))};
  plan.subfields[0].shape = plan.body[0];
  for (int i = 0; i < 10; ++i) {
    const double y = 3 * i + 1.5;
    if (i != 3 && i != 4) {
      add_piece(plan, i, y, 0, 100);
      continue;
    }
    add_piece(plan, i, y, i == 3 ? 60 : 0, i == 3 ? 100 : 40);
    add_piece(plan, i, y, i == 3 ? 0 : 60, i == 3 ? 40 : 100);
    plan.encounters.push_back(encounter_on(plan.pieces.back(), {50, y}, {0}, Passing::kCut));
  }
  for (TrackPiece& piece : plan.pieces) {
    const auto blocked = [](Point p) { return p.x == 40 || p.x == 60; };
    piece.stop_at_start = blocked(piece.start);
    piece.stop_at_end = blocked(piece.end);
  }
  return settled(plan);
}

Plan given_up_plan() {
  Plan plan = obstacle_plan();
  plan.given_up = {plan.field.obstacles[0].shape};
  plan.field.obstacles.clear();
  plan.body = {{plan.field.outer, {}}};
  for (Encounter& encounter : plan.encounters) encounter.obstacles.clear();
  return settled(plan);
}

Plan two_subfields_plan() {
  Plan plan = bare_rectangle();
  plan.settings.end_rule = EndRule::kCover;
  plan.subfields = {{{{{0, 0}, {40, 0}, {60, 30}, {0, 30}}, {}}, kEast},
                    {{{{40, 0}, {100, 0}, {100, 30}, {60, 30}}, {}}, kEast}};
  for (int i = 0; i < 10; ++i) add_piece(plan, i, 3 * i + 1.5, 0, 40 + 2.0 * (i + 1), 0);
  for (int i = 0; i < 10; ++i) add_piece(plan, i, 3 * i + 1.5, 40 + 2.0 * i, 100, 1);
  return settled(plan);
}

Plan crossing_plan() {
  Plan plan = bare_rectangle();
  plan.field.obstacles = {{{box(40, 0, 43, 30), {}}, ObstacleKind::kPassable, "ditch"}};
  plan.body = {{box(0, 0, 40, 30), {}}, {box(43, 0, 100, 30), {}}};
  for (int i = 0; i < 10; ++i) {
    const double y = 3 * i + 1.5;
    add_piece(plan, i, y, i % 2 == 0 ? 0 : 43, i % 2 == 0 ? 40 : 100);
    add_piece(plan, i, y, i % 2 == 0 ? 43 : 0, i % 2 == 0 ? 100 : 40);
    plan.pieces.back().after_crossing = true;
  }
  return settled(plan);
}

Encounter encounter_on(const TrackPiece& piece, Point at, std::vector<std::size_t> obstacles,
                       Passing chosen) {
  const auto way = [chosen](Passing side) {
    if (chosen == Passing::kCut) return WayPast{false, 0, "there is no room between the obstacles"};
    return WayPast{true, side == chosen ? -1.0 : 1.0, ""};
  };
  return {piece.subfield,      piece.track,         at, std::move(obstacles), chosen,
          way(Passing::kLeft), way(Passing::kRight)};
}

Detour bulge(const TrackPiece& piece, double along_m, double away_m, double radius_m, Passing side,
             std::vector<std::size_t> obstacles) {
  const double half = std::sqrt(4 * radius_m * away_m - away_m * away_m);
  const double left = side == Passing::kLeft ? 1 : -1, curvature = left / radius_m;
  const Point along = (1 / distance(piece.start, piece.end)) * (piece.end - piece.start);
  const Point out{-left * along.y, left * along.x};
  const auto at = [&](double s, double x) { return piece.start + (along_m + s) * along + x * out; };
  const Point a = at(-half, 0), b = at(-0.5 * half, 0.5 * away_m), c = at(0.5 * half, 0.5 * away_m);
  return {{{a, b, curvature}, {b, c, -curvature}, {c, at(half, 0), curvature}}, side, std::move(obstacles)};
}

double away_from_pole(double radius_m, double half_m, double clearance_m) {
  const double to_corner = radius_m - half_m - clearance_m;
  return radius_m + kPoleHalf_m - std::sqrt(to_corner * to_corner - kPoleHalf_m * kPoleHalf_m);
}

Plan poles_plan(double clearance_m) {
  Plan plan = bare_rectangle();
  plan.settings.clearance_m = clearance_m;
  for (const Point pole : {Point{50, 13.5}, Point{30, 22.5}}) {
    const Ring ring =
        box(pole.x - kPoleHalf_m, pole.y - kPoleHalf_m, pole.x + kPoleHalf_m, pole.y + kPoleHalf_m);
    plan.field.obstacles.push_back({{ring, {}}, ObstacleKind::kObstacle, "pole"});
    plan.body[0].holes.push_back(reversed(ring));
  }
  plan.subfields[0].shape = plan.body[0];
  for (int i = 0; i < 10; ++i) add_piece(plan, i, 3 * i + 1.5, 0, 100);
  const double away = away_from_pole(6, 1.5, clearance_m);
  plan.pieces[4].detours = {bulge(plan.pieces[4], 50, away, 6, Passing::kLeft, {0})};
  plan.pieces[7].detours = {bulge(plan.pieces[7], 70, away, 6, Passing::kRight, {1})};
  plan.encounters = {encounter_on(plan.pieces[4], {50, 13.5}, {0}, Passing::kLeft),
                     encounter_on(plan.pieces[7], {30, 22.5}, {1}, Passing::kRight)};
  return settled(plan);
}

Plan bay_plan() {
  Plan plan = bare_rectangle();
  const Ring bay{{45, 11.5}, {61, 11.5}, {61, 24},   {45, 24},   {45, 23.5},
                 {60, 23.5}, {60, 12},   {45.5, 12}, {45.5, 13}, {45, 13}};
  plan.field.obstacles = {{{bay, {}}, ObstacleKind::kObstacle, "bay"}};
  plan.body[0].holes = {reversed(bay)};
  plan.subfields[0].shape = plan.body[0];
  for (int i = 0; i < 10; ++i) {
    const double y = 3 * i + 1.5, blocked_from = i == 3 || i == 7 ? 45 : 60;
    if (i < 3 || i > 7) {
      add_piece(plan, i, y, 0, 100);
      continue;
    }
    add_piece(plan, i, y, i % 2 == 0 ? 0 : 61, i % 2 == 0 ? blocked_from : 100);
    add_piece(plan, i, y, i % 2 == 0 ? 61 : 0, i % 2 == 0 ? 100 : blocked_from);
    const Point middle{0.5 * (blocked_from + 61), y};
    plan.encounters.push_back(encounter_on(plan.pieces.back(), middle, {0}, Passing::kCut));
  }
  for (TrackPiece& piece : plan.pieces) {
    const auto blocked = [](Point p) { return p.x == 45 || p.x == 60 || p.x == 61; };
    piece.stop_at_start = blocked(piece.start);
    piece.stop_at_end = blocked(piece.end);
  }
  // Over the hook's corners an arc of 6 m has to leave the line by 5.5 − √(4.5² − 0.25²) = 1.007 m.
  TrackPiece& past_hook = plan.pieces[5];
  past_hook.detours = {bulge(past_hook, 45.25, 1.1, 6, Passing::kLeft, {0})};
  plan.encounters.push_back(encounter_on(past_hook, {45.25, 13.5}, {0}, Passing::kLeft));
  return settled(plan);
}

Path rounded_rectangle(double min_x, double min_y, double max_x, double max_y, double radius_m) {
  const double r = radius_m, bend = r > 0 ? 1 / r : 0;
  const Path all{{{min_x + r, min_y}, {max_x - r, min_y}, 0}, {{max_x - r, min_y}, {max_x, min_y + r}, bend},
                 {{max_x, min_y + r}, {max_x, max_y - r}, 0}, {{max_x, max_y - r}, {max_x - r, max_y}, bend},
                 {{max_x - r, max_y}, {min_x + r, max_y}, 0}, {{min_x + r, max_y}, {min_x, max_y - r}, bend},
                 {{min_x, max_y - r}, {min_x, min_y + r}, 0}, {{min_x, min_y + r}, {min_x + r, min_y}, bend}};
  Path out;
  for (const PathSegment& segment : all)
    if (distance(segment.from, segment.to) > 0) out.push_back(segment);
  return out;
}

Plan headland_plan(int passes) {
  Plan plan;
  plan.field.id = "headland";
  plan.field.outer = box(0, 0, 100, 60);
  plan.machine.width_m = 3;
  plan.machine.radius_m = kCorner_m;
  plan.settings.headlands = passes;
  const double deep = 3.0 * passes;
  const Ring inner = box(deep, deep, 100 - deep, 60 - deep);
  plan.body = {{inner, {}}};
  plan.headland.ground = {{plan.field.outer, {reversed(inner)}}};
  plan.subfields = {{plan.body[0], kEast}};
  for (int i = 0; i < passes; ++i) {
    const double off = 3.0 * i + 1.5;
    plan.headland.passes.push_back(
        {rounded_rectangle(off, off, 100 - off, 60 - off, kCorner_m), i + 1, true, {}});
  }
  for (int i = 0; i < 20 - 2 * passes; ++i) add_piece(plan, i, deep + 3 * i + 1.5, deep, 100 - deep);
  return settled(plan);
}

Plan headland_and_ditch_plan() {
  Plan plan = headland_plan(2);
  plan.field.obstacles = {{{box(40, 0, 43, 60), {}}, ObstacleKind::kPassable, "ditch"}};
  plan.body = {{box(6, 6, 40, 54), {}}, {box(43, 6, 94, 54), {}}};
  plan.headland.ground = difference(plan.headland.ground, {plan.field.obstacles[0].shape});
  plan.pieces.clear();
  for (int i = 0; i < 16; ++i) {
    const double y = 6 + 3 * i + 1.5;
    add_piece(plan, i, y, i % 2 == 0 ? 6 : 43, i % 2 == 0 ? 40 : 94);
    add_piece(plan, i, y, i % 2 == 0 ? 43 : 6, i % 2 == 0 ? 94 : 40);
    plan.pieces.back().after_crossing = true;
  }
  return settled(plan);
}

double wide_corner_m() { return kCorner_m - (kCorner_m - 1.5) / std::numbers::sqrt2; }

Plan island_plan() {
  Plan plan;
  plan.field.id = "island";
  plan.field.outer = box(0, 0, 100, 60);
  plan.field.obstacles = {{{box(40, 27, 60, 33), {}}, ObstacleKind::kObstacle, "copse"}};
  plan.machine.width_m = 3;
  plan.machine.radius_m = kCorner_m;
  plan.settings.obstacle_headlands = 1;
  plan.settings.end_rule = EndRule::kCover;
  Ring edge = chords(rounded_rectangle(37, 24, 63, 36, 3), 1e-4);
  edge.pop_back();
  plan.headland.ground = {{edge, {reversed(plan.field.obstacles[0].shape.outer)}}};
  plan.headland.obstacle_passes = {1};
  const double off = wide_corner_m();
  const Path round = rounded_rectangle(40 - off, 27 - off, 60 + off, 33 + off, kCorner_m);
  plan.headland.passes = {{reversed(round), 1, false, {0}}};
  plan.body = {{plan.field.outer, {reversed(edge)}}};
  plan.subfields = {{plan.body[0], kEast}};
  for (int i = 0; i < 20; ++i) {
    const double y = 3 * i + 1.5, cut = i == 8 || i == 11 ? 40 : 37;
    if (i < 8 || i > 11) {
      add_piece(plan, i, y, 0, 100);
      continue;
    }
    add_piece(plan, i, y, i % 2 == 0 ? 0 : 100 - cut, i % 2 == 0 ? cut : 100);
    add_piece(plan, i, y, i % 2 == 0 ? 100 - cut : 0, i % 2 == 0 ? 100 : cut);
  }
  return settled(plan);
}

TrackPiece arc_piece(int track, double from_deg, double to_deg) {
  TrackPiece piece;
  piece.track = track;
  piece.curve = arc_about_origin(31.5 + 3 * track, from_deg, to_deg);
  if (track % 2 == 1) piece.curve = reversed(piece.curve);
  piece.start = piece.curve.front().from;
  piece.end = piece.curve.back().to;
  return piece;
}

Ring ring_sector(double inner_m, double outer_m, double from_deg, double to_deg) {
  const Path middle = arc_about_origin(0.5 * (inner_m + outer_m), from_deg, to_deg);
  return check::bands_along(middle, outer_m - inner_m, kLayerSagitta)[0].outer;
}

Plan arcs_plan() {
  Plan plan;
  plan.field.id = "arcs";
  plan.field.outer = ring_sector(30, 45, 0, 90);
  plan.machine.width_m = 3;
  plan.body = {{plan.field.outer, {}}};
  plan.subfields = {{plan.body[0], kEast}};
  // As far as the land and beyond, as planners make it.
  plan.subfields[0].reference = {
      {{30, -60}, {30, 0}, 0}, arc_about_origin(30, 0, 90)[0], {{0, 30}, {-60, 30}, 0}};
  for (int i = 0; i < 5; ++i) plan.pieces.push_back(arc_piece(i, 0, 90));
  return settled(plan);
}

Plan blocked_arc_plan() {
  Plan plan = arcs_plan();
  const Ring block = ring_sector(36, 39, 40, 50);
  plan.field.obstacles = {{{block, {}}, ObstacleKind::kObstacle, "block"}};
  plan.body[0].holes = {reversed(block)};
  plan.subfields[0].shape = plan.body[0];
  const TrackPiece before = arc_piece(2, 0, 40), behind = arc_piece(2, 50, 90);
  plan.pieces[2] = before;
  plan.pieces.insert(plan.pieces.begin() + 3, behind);
  plan.pieces[2].stop_at_end = true;
  plan.pieces[3].stop_at_start = true;
  plan.encounters = {encounter_on(before, on_circle(37.5, 45), {0}, Passing::kCut)};
  return settled(plan);
}

Plan turned(Plan plan, Angle by, Point move) {
  const TrackFrame frame(Direction::clockwise_from_north(by));
  const auto point = [&](Point p) { return frame.to_field(p) + move; };
  const auto ring = [&](Ring& r) {
    for (Point& p : r) p = point(p);
  };
  const auto polygon = [&](Polygon& shape) {
    ring(shape.outer);
    for (Ring& hole : shape.holes) ring(hole);
  };
  ring(plan.field.outer);
  for (Obstacle& obstacle : plan.field.obstacles) polygon(obstacle.shape);
  for (Region* region : {&plan.body, &plan.given_up, &plan.overlap, &plan.uncovered, &plan.headland.ground,
                         &plan.headland.unworked})
    for (Polygon& shape : *region) polygon(shape);
  for (Subfield& subfield : plan.subfields) {
    polygon(subfield.shape);
    subfield.direction =
        Direction::clockwise_from_north(Angle::radians(subfield.direction.angle().radians() + by.radians()));
    subfield.reference = moved(subfield.reference, point);
  }
  for (TrackPiece& piece : plan.pieces) {
    piece.start = point(piece.start);
    piece.end = point(piece.end);
    for (Detour& detour : piece.detours) detour.path = moved(detour.path, point);
    piece.curve = moved(piece.curve, point);
  }
  for (HeadlandPass& pass : plan.headland.passes) pass.path = moved(pass.path, point);
  for (Encounter& encounter : plan.encounters) encounter.at = point(encounter.at);
  return plan;
}

std::set<std::string> rules(const check::Verdict& verdict) {
  std::set<std::string> out;
  for (const check::Violation& violation : verdict.violations) out.emplace(name(violation.rule));
  return out;
}

Names found(const Plan& plan) { return rules(check::verify(plan)); }

void expect_holds(const Plan& plan) {
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(verdict.holds());
  for (const check::Violation& v : verdict.violations) ADD_FAILURE() << name(v.rule) << ": " << v.what;
}

}  // namespace tramline::testing_plans
