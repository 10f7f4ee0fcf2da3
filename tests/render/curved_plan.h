#pragma once
// A plan with a headland and curved tracks, made by hand.

#include "detour_plan.h"
#include "tramline/geometry/tolerances.h"

namespace tramline::render {

/// Round a box with arcs at the corners, counter-clockwise; `radius` is not 0.
inline Path round_box(double min_x, double min_y, double max_x, double max_y, double radius) {
  const double r = radius, k = 1 / radius;
  return {{{min_x + r, min_y}, {max_x - r, min_y}, 0}, {{max_x - r, min_y}, {max_x, min_y + r}, k},
          {{max_x, min_y + r}, {max_x, max_y - r}, 0}, {{max_x, max_y - r}, {max_x - r, max_y}, k},
          {{max_x - r, max_y}, {min_x + r, max_y}, 0}, {{min_x + r, max_y}, {min_x, max_y - r}, k},
          {{min_x, max_y - r}, {min_x, min_y + r}, 0}, {{min_x, min_y + r}, {min_x + r, min_y}, k}};
}

/// So far north of the reference, from the west edge of the body to its east or north edge: east, an arc
/// about (160, 180) to the left by 30°, and on; at the reference its radius is 120 m. Where the arc lies
/// south of the body, the straight line behind it from the south edge on. Empty where there is nothing in the
/// body.
inline Path parallel_bend(double north_m, double west, double east, double south, double north) {
  const double r = 120 - north_m, s = 0.5, c = std::sqrt(0.75);
  const Point hub{160, 180}, a = hub + Point{0, -r}, b = hub + r * Point{s, -c};
  const double run = std::min((east - b.x) / c, (north - b.y) / s);
  const Point end = b + run * Point{c, s};
  if (run <= 0 || end.y <= south || (a.y < south && b.y > south)) return {};
  if (b.y <= south) return straight_path(b + ((south - b.y) / s) * Point{c, s}, end);
  return {{{west, a.y}, a, 0}, {a, b, 1 / r}, {b, end, 0}};
}

/// The piece along a path, driven the other way where the track's number is odd.
inline TrackPiece curved_piece(const Path& path, int track) {
  const Path driven = track % 2 == 0 ? path : reversed(path);
  TrackPiece piece{driven.front().from, driven.back().to, 0, track};
  piece.curve = driven;
  return piece;
}

/// 320 m × 200 m, w = 6 m. Two passes round the field and one round its pond, [80, 92] × [84, 94]; the body
/// is [12, 308] × [12, 188] without [74, 98] × [78, 100]. Tracks run parallel to the bend whose north_m is 0,
/// the border of the swaths 0 and −1; the pond cuts those numbered 3 to 6.
inline Plan curved_plan() {
  Plan plan;
  plan.field.id = "bend";
  plan.field.outer = box(0, 0, 320, 200);
  const Ring pond = box(80, 84, 92, 94), round_pond = box(74, 78, 98, 100);
  plan.field.obstacles.push_back({{pond, {}}, ObstacleKind::kObstacle, "hole 1"});
  plan.machine.width_m = 6;
  plan.settings.headlands = 2;
  plan.settings.obstacle_headlands = 1;
  plan.settings.shape = TrackShape::kCurved;
  const Ring inner = box(12, 12, 308, 188);
  plan.body = {{inner, {reversed(round_pond)}}};
  Headland& headland = plan.headland;
  headland.passes = {{round_box(3, 3, 317, 197, 6), 1, true, {}},
                     {reversed(round_box(77, 81, 95, 97, 6)), 1, false, {0}},
                     {round_box(9, 9, 311, 191, 6), 2, true, {}}};
  headland.obstacle_passes = {1};
  headland.ground = {{plan.field.outer, {reversed(inner)}}, {round_pond, {reversed(pond)}}};
  Region worked;
  for (const HeadlandPass& pass : headland.passes) {
    worked = unite(worked, {closed_band(pass.path, 6, kLayerSagitta)});
    headland.worked_m2 += 6 * length(pass.path);
  }
  headland.unworked = difference(headland.ground, worked);
  headland.uncovered_m2 = area(headland.unworked);
  headland.overlap_m2 = headland.worked_m2 - area(headland.ground) + headland.uncovered_m2;
  plan.subfields.push_back({plan.body[0], Direction::clockwise_from_north(Angle::degrees(75))});
  plan.subfields[0].reference = parallel_bend(0, -200, 600, 12, 1000);
  for (int track = -20; track < 18; ++track) {
    const Path path = parallel_bend(6 * track + 3, 12, 308, 12, 188);
    if (path.empty()) continue;
    if (track < 3 || track > 6) {
      plan.pieces.push_back(curved_piece(path, track));
      continue;
    }
    const double y = path.front().from.y;
    Path behind = path;
    behind.front().from = {98, y};
    plan.pieces.push_back(curved_piece(straight_path({12, y}, {74, y}), track));
    plan.pieces.push_back(curved_piece(behind, track));
    if (track % 2 != 0) std::swap(plan.pieces.back(), plan.pieces[plan.pieces.size() - 2]);
  }
  // Tracks side by side do not meet; chords as pictures show them keep the booleans quick.
  worked.clear();
  Tally& tally = plan.tally;
  for (const TrackPiece& piece : plan.pieces) {
    worked.push_back({band(piece.curve, 6, kLayerSagitta), {}});
    tally.track_length_m += length(piece);
  }
  worked = unite(worked);
  plan.overlap = difference(worked, plan.body);
  plan.uncovered = unite(difference(plan.body, worked), headland.unworked);
  tally.worked_m2 = 6 * tally.track_length_m;
  tally.pieces = static_cast<int>(plan.pieces.size());
  tally.turns = tally.pieces - 1;
  tally.overlap_m2 = area(plan.overlap);
  tally.uncovered_m2 = area(plan.uncovered);
  plan.cost = 12.34;
  return plan;
}

}  // namespace tramline::render
