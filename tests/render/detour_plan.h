#pragma once
// Plans with detours, made by hand.

#include <cmath>

#include "sample_plan.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::render {

/// A sidestep of a track that runs along the x axis, forth and back again: arcs of the given radius
/// bring it from (from_x, y) to y + aside and, after a straight stretch, back to y. Positive: to the left.
inline Path sidestep(double from_x, double y, double aside, double radius, double straight) {
  const double turn = std::acos(1 - std::abs(aside) / (2 * radius));
  const double half = radius * std::sin(turn), bend = (aside > 0 ? 1 : -1) / radius;
  const double a = from_x, b = a + half, c = b + half, d = c + straight, e = d + half, f = e + half;
  Path out{{{a, y}, {b, y + 0.5 * aside}, bend}, {{b, y + 0.5 * aside}, {c, y + aside}, -bend}};
  if (straight > 0) out.push_back({{c, y + aside}, {d, y + aside}, 0});
  out.push_back({{d, y + aside}, {e, y + 0.5 * aside}, -bend});
  out.push_back({{e, y + 0.5 * aside}, {f, y}, bend});
  return out;
}

/// The sidestep whose middle is at middle_x.
inline Path sidestep_round(double middle_x, double y, double aside, double radius, double straight) {
  const double turn = std::acos(1 - std::abs(aside) / (2 * radius));
  return sidestep(middle_x - 2 * radius * std::sin(turn) - 0.5 * straight, y, aside, radius, straight);
}

/// The faults and the tally of what a plan's pieces work.
inline void count_faults(Plan& plan) {
  const Region worked = unite(swaths(plan));
  plan.uncovered = difference(plan.body, worked);
  plan.overlap = difference(worked, plan.body);
  for (std::size_t i = 0; i < plan.pieces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (const Polygon& twice : intersection({{swath(plan.pieces[i], plan.machine.width_m), {}}},
                                               {{swath(plan.pieces[j], plan.machine.width_m), {}}}))
        plan.overlap.push_back(twice);
  plan.overlap = unite(plan.overlap);
  Tally& tally = plan.tally;
  tally = {};
  for (const TrackPiece& piece : plan.pieces) {
    tally.track_length_m += length(piece);
    tally.stops += (piece.stop_at_start ? 1 : 0) + (piece.stop_at_end ? 1 : 0);
  }
  tally.worked_m2 = plan.machine.width_m * tally.track_length_m;
  tally.pieces = static_cast<int>(plan.pieces.size());
  tally.turns = tally.pieces - 1;
  tally.uncovered_m2 = area(plan.uncovered);
  tally.overlap_m2 = tally.worked_m2 - area(plan.body) + tally.uncovered_m2;
}

/// 120 m × 60 m, w = 6 m, tracks along the x axis. Obstacle 1, [58, 62] × [29, 34], lies between the
/// tracks at y = 27 and 33: the first passes it on the right (it is driven east), the second on the left
/// (seen from it, it is driven west: on its right hand). Obstacle 2, [90, 100] × [43, 52], is cut by two
/// tracks; the passable strip 3 lies out of the way.
inline Plan detour_plan() {
  Plan plan;
  plan.field.id = "two detours";
  plan.field.outer = box(0, 0, 120, 60);
  const Ring tree = box(58, 29, 62, 34), barn = box(90, 43, 100, 52);
  plan.field.obstacles.push_back({{tree, {}}, ObstacleKind::kObstacle, "hole 1"});
  plan.field.obstacles.push_back({{barn, {}}, ObstacleKind::kObstacle, "hole 2"});
  plan.field.obstacles.push_back(
      {{box(0, 59.5, 3, 60), {}}, ObstacleKind::kPassable, "strips.geojson feature 1"});
  plan.machine.width_m = 6;
  plan.body = {{plan.field.outer, {reversed(tree), reversed(barn)}}};
  plan.subfields.push_back({plan.body[0], Direction::clockwise_from_north(Angle::degrees(90))});
  for (int track = 0; track < 10; ++track) {
    const double y = 3 + 6 * track;
    const bool east = track % 2 == 0;
    if (track == 7 || track == 8) {
      TrackPiece west_of{{0, y}, {90, y}, 0, track, false, true}, east_of{{100, y}, {120, y}, 0, track, true};
      if (!east) {
        west_of = {{90, y}, {0, y}, 0, track, true};
        east_of = {{120, y}, {100, y}, 0, track, false, true};
      }
      plan.pieces.push_back(east ? west_of : east_of);
      plan.pieces.push_back(east ? east_of : west_of);
      continue;
    }
    TrackPiece piece{{east ? 0.0 : 120.0, y}, {east ? 120.0 : 0.0, y}, 0, track};
    if (track == 4) piece.detours.push_back({sidestep_round(60, y, -1.0, 8, 4), Passing::kRight, {0}});
    if (track == 5) piece.detours.push_back({reversed(sidestep_round(60, y, 4, 6, 4)), Passing::kRight, {0}});
    plan.pieces.push_back(piece);
  }
  count_faults(plan);
  plan.encounters = {
      {0, 4, {60, 27}, {0}, Passing::kRight, {false, 0, "detour would leave the body"}, {true, -14.3, ""}},
      {0, 5, {60, 33}, {0}, Passing::kRight, {true, 2.5, ""}, {true, -8.05, ""}},
      {0, 7, {95, 45}, {1}, Passing::kCut, {false, 0, "too tight"}, {true, 3.2, ""}},
      {0, 8, {95, 51}, {1}, Passing::kCut, {true, 1.1, ""}, {false, 0, "too tight"}}};
  plan.cost = 31.4;
  return plan;
}

}  // namespace tramline::render
