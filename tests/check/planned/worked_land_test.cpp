// Swaths laid over the body part by part, against the union of all of them.

#include "tramline/check/measure/worked_land.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

using check::worked_on;
using check::WorkedPart;

/// A sector of a ring about the origin with poles on it.
Field sector() {
  Field out;
  const auto on = [](double radius_m, int i) {
    const double angle = 0.2 + 1.3 * i / 30;
    return Point{radius_m * std::cos(angle), radius_m * std::sin(angle)};
  };
  for (int i = 0; i <= 30; ++i) out.outer.push_back(on(100, i));
  for (int i = 30; i >= 0; --i) out.outer.push_back(on(60, i));
  for (const int i : {8, 15, 24}) {
    const Point p = on(65.0 + i, i);
    out.obstacles.push_back({{{p, p + Point{1.5, 0}, p + Point{1, 2}}, {}}, ObstacleKind::kObstacle, "pole"});
  }
  return out;
}

Plan curved_plan(EndRule rule, TrackConstruction tracks) {
  PlanSettings settings;
  settings.shape = TrackShape::kCurved;
  settings.end_rule = rule;
  settings.tracks = tracks;
  for (int i = 0; i <= 30; ++i) settings.guide.push_back(sector().outer[static_cast<std::size_t>(61 - i)]);
  if (tracks == TrackConstruction::kPaper) settings.obstacle_headlands = 1;
  return plan_field(sector(), {"", 4, 5, 0}, {}, settings, 1);
}

std::vector<Plan> plans() {
  return {curved_plan(EndRule::kCheapest, TrackConstruction::kParallel),
          curved_plan(EndRule::kCover, TrackConstruction::kPaper),
          plan_field(sector(), {"", 4, 5}, {}, {}, 1)};
}

Region ground_of(const std::vector<WorkedPart>& parts) {
  Region out;
  for (const WorkedPart& part : parts) out.insert(out.end(), part.ground.begin(), part.ground.end());
  return unite(out);
}

/// Of 1.5 ha and some 3 km of swaths: chords of neighbours (kLayerSagitta) and the grid of overlays.
constexpr double kTolerance_m2 = 0.15;

TEST(WorkedLand, CoversWhatTheUnionOfTheSwathsDoes) {
  for (Plan plan : plans()) {
    // As they are, and with a piece driven once more somewhere else, across all others.
    for (const bool crossed : {false, true}) {
      if (crossed) {
        TrackPiece more = plan.pieces[1];
        const auto turned = [](Point p) { return Point{1.02 * p.y, 0.98 * p.x}; };
        more.start = turned(more.start);
        more.end = turned(more.end);
        more.curve = {};
        more.detours.clear();
        plan.pieces.insert(plan.pieces.begin(), more);
      }
      const std::vector<WorkedPart> parts = check::worked_parts(plan);
      const check::WorkedLand found = worked_on(plan.body, parts, plan.pieces.size());
      const Region land = ground_of(parts);
      EXPECT_NEAR(found.covered_m2, area(intersection(land, plan.body)), kTolerance_m2);
    }
  }
}

// A path that comes back to itself works ground twice; one that only bends does not.
TEST(WorkedLand, KnowsSwathsThatMeetThemselves) {
  Plan plan;
  plan.machine.width_m = 4;
  plan.body = {{{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, {}}};
  TrackPiece piece{{0, 0}, {0, 3}};
  // To and fro: legs of 20 m that are 3 m apart, by way of 40 m of loop.
  piece.curve = {{{0, 0}, {20, 0}, 0},
                 {{20, 0}, {20, 23}, 1 / 11.5},
                 {{20, 23}, {0, 23}, 0},
                 {{0, 23}, {0, 3}, 0.1},
                 {{0, 3}, {20, 3}, 0}};
  piece.end = {20, 3};
  plan.pieces = {piece};
  const std::vector<WorkedPart> parts = check::worked_parts(plan);
  const Region land = ground_of(parts);
  const double twice_m2 = 4 * length(piece) - area(land);
  // Legs from 0 to 20 m share a metre of their width, and each what the arcs at its ends bend into it.
  EXPECT_GT(twice_m2, 20);
  const check::WorkedLand found = worked_on(plan.body, parts, plan.pieces.size());
  EXPECT_NEAR(found.covered_m2, area(land), 1e-2);
}

}  // namespace
}  // namespace tramline
