// Ring sectors with random poles, planned along a curve and judged by the verifier.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "properties/draws.h"
#include "tramline/check/verify.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

Point on(double radius_m, double angle) { return {radius_m * std::cos(angle), radius_m * std::sin(angle)}; }

struct Sector {
  double inner_m = 60, outer_m = 110, from = 0.2, to = 1.4;

  Ring ring() const {
    constexpr int kChords = 40;
    Ring out;
    for (int i = 0; i <= kChords; ++i) out.push_back(on(outer_m, from + (to - from) * i / kChords));
    for (int i = kChords; i >= 0; --i) out.push_back(on(inner_m, from + (to - from) * i / kChords));
    return out;
  }
  std::vector<Point> guide() const {
    constexpr int kChords = 40;
    std::vector<Point> out;
    for (int i = 0; i <= kChords; ++i) out.push_back(on(inner_m, from + (to - from) * i / kChords));
    return out;
  }
};

Ring pole(Point centre, double radius_m, int corners) {
  Ring out;
  for (int i = 0; i < corners; ++i)
    out.push_back(centre + on(radius_m, 2 * 3.14159265358979 * (i + 0.3) / corners));
  return out;
}

Field field_of(const Sector& sector) {
  Field field;
  field.id = "sector";
  field.outer = sector.ring();
  return field;
}

void add(Field& field, Ring ring, ObstacleKind kind) {
  for (const Obstacle& other : field.obstacles)
    if (distance_between({other.shape}, {{ring, {}}}) < 0.2) return;
  field.obstacles.push_back({{std::move(ring), {}}, kind, "by chance"});
}

std::string said(const check::Verdict& verdict) {
  std::string out;
  for (const check::Violation& violation : verdict.violations)
    out += fmt::format("{}: {}\n", name(violation.rule), violation.what);
  return out;
}

int detours_in(const Plan& plan) {
  int out = 0;
  for (const TrackPiece& piece : plan.pieces) out += static_cast<int>(piece.detours.size());
  return out;
}

// Every plan holds before the verifier, which knows radii, obstacles, boundaries, tally and encounters; and
// it is no more expensive than the one with all tracks cut.
TEST(CurvedDetours, OfRandomSectorsHold) {
  const char* more = std::getenv("TRAMLINE_SCENES");
  const int scenes = more != nullptr ? std::atoi(more) : 12;
  int detours = 0, crossings = 0, both_ways = 0;
  for (int seed = 1; seed <= scenes; ++seed) {
    std::mt19937_64 random(static_cast<unsigned>(seed));
    const Sector sector{uniform(random, 30, 70), uniform(random, 90, 120), 0.2, uniform(random, 1.2, 2.6)};
    Field field = field_of(sector);
    for (int i = any_of(random, 1, 6); i > 0; --i) {
      const Point at = on(uniform(random, sector.inner_m + 2, sector.outer_m - 2),
                          uniform(random, sector.from + 0.1, sector.to - 0.1));
      add(field, pole(at, uniform(random, 0.2, 3), any_of(random, 3, 12)), ObstacleKind::kObstacle);
    }
    if (any_of(random, 0, 2) == 0) {
      const double angle = uniform(random, sector.from + 0.3, sector.to - 0.3);
      add(field,
          {on(sector.inner_m + 3, angle), on(sector.outer_m - 3, angle), on(sector.outer_m - 3, angle + 0.03),
           on(sector.inner_m + 3, angle + 0.03)},
          ObstacleKind::kPassable);
    }
    PlanSettings settings;
    settings.guide = sector.guide();
    settings.shape = TrackShape::kCurved;
    settings.headlands = any_of(random, 0, 1);
    settings.boundary = any_of(random, 0, 1) == 0 ? EdgeKind::kSoft : EdgeKind::kHard;
    settings.clearance_m = any_of(random, 0, 2) == 0 ? uniform(random, 0.1, 1) : 0;
    settings.end_rule = any_of(random, 0, 1) == 0 ? EndRule::kCheapest : EndRule::kCentre;
    const Machine machine{"", uniform(random, 2, 6), uniform(random, 2, 8)};
    SCOPED_TRACE(fmt::format("seed {}, w {}, r {}, {} headlands, clearance {}", seed, machine.width_m,
                             machine.radius_m, settings.headlands, settings.clearance_m));
    const Plan plan = plan_field(field, machine, {}, settings, 1);
    const check::Verdict verdict = check::verify(plan);
    EXPECT_TRUE(verdict.violations.empty()) << said(verdict);
    EXPECT_NEAR(identity_error_m2(plan), 0, 1e-6);
    EXPECT_EQ(plan.tally.turns, plan.tally.pieces - 1 - plan.tally.crossings);
    settings.avoid = Avoidance::kCut;
    const Plan cut = plan_field(field, machine, {}, settings, 1);
    EXPECT_TRUE(check::verify(cut).violations.empty()) << said(check::verify(cut));
    EXPECT_LE(plan.cost, cut.cost + 1e-9);
    detours += detours_in(plan);
    crossings += plan.tally.crossings;
    bool left = false, right = false;
    for (const TrackPiece& piece : plan.pieces)
      for (const Detour& detour : piece.detours) (detour.side == Passing::kLeft ? left : right) = true;
    // By how much, the verifier has seen.
    for (const TrackPiece& piece : plan.pieces) EXPECT_TRUE(piece.overlap_m2.has_value());
    both_ways += left && right ? 1 : 0;
  }
  EXPECT_GT(detours, scenes);
  EXPECT_GT(crossings, scenes / 2);
  EXPECT_GT(both_ways, scenes / 6);
}

// What the verifier says of detours that are not what they say.
TEST(CurvedDetours, FalsifiedAreFoundOut) {
  const Sector sector{};
  Field field = field_of(sector);
  add(field, pole(on(84, 0.8), 1, 6), ObstacleKind::kObstacle);
  PlanSettings settings;
  settings.guide = sector.guide();
  settings.shape = TrackShape::kCurved;
  const Plan plan = plan_field(field, {"", 4, 6}, {}, settings, 1);
  ASSERT_EQ(said(check::verify(plan)), "");
  ASSERT_GT(detours_in(plan), 0);
  std::size_t with = 0;
  while (plan.pieces[with].detours.empty()) ++with;
  const auto found = [&](auto change) {
    Plan changed = plan;
    change(changed, changed.pieces[with], changed.pieces[with].detours.front());
    std::string rules;
    for (const check::Violation& violation : check::verify(changed).violations)
      if (rules.find(name(violation.rule)) == std::string::npos)
        rules += fmt::format("{} ", name(violation.rule));
    return rules;
  };
  EXPECT_EQ(found([](Plan&, TrackPiece&, Detour& d) {
              d.side = d.side == Passing::kLeft ? Passing::kRight : Passing::kLeft;
            }),
            "encounters ");
  EXPECT_EQ(found([](Plan&, TrackPiece&, Detour& d) { d.obstacles.clear(); }), "encounters ");
  EXPECT_EQ(found([](Plan& p, TrackPiece&, Detour&) { p.encounters.clear(); }), "encounters ");
  EXPECT_EQ(found([](Plan& p, TrackPiece&, Detour&) { p.settings.avoid = Avoidance::kCut; }), "encounters ");
  // The line of the next number is elsewhere.
  EXPECT_EQ(found([](Plan&, TrackPiece& t, Detour&) { ++t.track; }), "parallel encounters ");
  EXPECT_EQ(found([](Plan&, TrackPiece& t, Detour&) { *t.overlap_m2 += 0.1; }), "swath overlap ");
  EXPECT_EQ(found([](Plan&, TrackPiece&, Detour& d) { d.path.front().curvature *= 1.01; }), "pieces ");
  // What is not called a detour is a track that comes too near to its neighbour.
  EXPECT_NE(found([](Plan&, TrackPiece& t, Detour&) { t.detours.clear(); }).find("parallel"),
            std::string::npos);
}

}  // namespace
}  // namespace tramline
