// What is true of every plan, on random fields with obstacles.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "support/refusals.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/planner/plan_field.h"

namespace tramline::plan_properties_test {

using testing::base_seed;
using testing::case_count;
using testing::for_each_seed;
using testing::random_field;

struct Request {
  Machine machine;
  Objective objective;
  PlanSettings settings;
};

Request random_request(std::mt19937_64& random) {
  Request out;
  const auto pick = [&random](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  out.machine.width_m = std::array{2.0, 3.0, 4.5, 6.0}[static_cast<std::size_t>(pick(4))];
  out.objective = std::array{Objective{}, Objective{99999, 1, 1, 0}, Objective{1, 99999, 1, 0},
                             Objective{1, 1, 99999, 0}}[static_cast<std::size_t>(pick(4))];
  out.settings.end_rule = static_cast<EndRule>(pick(4));
  out.settings.boundary = pick(3) == 0 ? EdgeKind::kHard : EdgeKind::kSoft;
  out.settings.merge_threshold = Angle::degrees(pick(2) * 15);
  out.settings.decomposition_threshold = Angle::degrees(180 + 25 * pick(2));
  // The best search takes several times as long as the sweep.
  out.settings.strategy = pick(4) != 0 ? Strategy::kSweep : Strategy::kBest;
  return out;
}

/// The plan, or nothing where no track fits.
std::optional<Plan> try_plan(const Field& field, const Request& request, int threads = 1) {
  return testing_support::unless_refused(
      [&] { return plan_field(field, request.machine, request.objective, request.settings, threads); });
}

class PlanProperties : public ::testing::Test {
 protected:
  template <class Property>
  void for_random_fields(int standard, Property property) {
    int planned = 0;
    for_each_seed(standard, [&](std::mt19937_64& random, int) {
      const Field field = random_field(random, 6);
      const Request request = random_request(random);
      if (property(field, request)) ++planned;
    });
    EXPECT_GT(planned, case_count(standard) / 2);
  }

  /// Zhou §2.3.5: what swaths overlap, each by itself, is what the plan does.
  void expect_overlaps_to_sum_up(int cases, TrackShape shape) {
    for_random_fields(cases, [shape](const Field& field, Request request) {
      request.settings.shape = shape;
      const auto plan = try_plan(field, request);
      if (!plan) return false;
      double sum = 0;
      for (const TrackPiece& piece : plan->pieces) {
        EXPECT_TRUE(piece.overlap_m2.has_value());
        EXPECT_GE(piece.overlap_m2.value_or(-1), 0);
        EXPECT_LE(piece.overlap_m2.value_or(0), request.machine.width_m * length(piece) * (1 + 1e-9));
        sum += piece.overlap_m2.value_or(0);
      }
      EXPECT_NEAR(sum, plan->track_tally.overlap_m2, 1e-8 * area(Polygon{field.outer, {}}));
      return true;
    });
  }
};

/// The other road: the useful area by polygon booleans.
TEST_F(PlanProperties, TallyAgreesWithPolygonBooleans) {
  for_random_fields(20, [](const Field& field, const Request& request) {
    const auto plan = try_plan(field, request);
    if (!plan) return false;
    const double tolerance = 1e-6 * area(Polygon{field.outer, {}});
    double worked = 0;
    for (const Polygon& swath : swaths(*plan)) worked += area(swath);
    const double useful = area(intersection(unite(swaths(*plan)), plan->body));
    EXPECT_NEAR(plan->tally.worked_m2, worked, tolerance);
    EXPECT_NEAR(plan->tally.overlap_m2, worked - useful, tolerance);
    EXPECT_NEAR(plan->tally.uncovered_m2, area(plan->body) - useful, tolerance);
    EXPECT_NEAR(worked, area(plan->body) - plan->tally.uncovered_m2 + plan->tally.overlap_m2, tolerance);
    EXPECT_NEAR(area(plan->uncovered), plan->tally.uncovered_m2, tolerance);
    return true;
  });
}

TEST_F(PlanProperties, OverlapsOfStraightSwathsSumUp) {
  expect_overlaps_to_sum_up(30, TrackShape::kStraight);
}

/// The search along curves takes many times as long.
TEST_F(PlanProperties, OverlapsOfCurvedSwathsSumUp) { expect_overlaps_to_sum_up(10, TrackShape::kCurved); }

/// The other road to what each swath overlaps: what polygon booleans leave of it after those before it. Along
/// the first edges of the field, by parallel tracks with detours and by Zhou's own construction.
TEST_F(PlanProperties, OverlapsOfCurvedSwathsAgreeWithPolygonBooleans) {
  int detours = 0, kinked = 0;
  for_random_fields(5, [&](const Field& field, Request request) {
    bool any = false;
    request.machine.width_m = 7;  // overlays of many arcs take long
    for (const TrackConstruction tracks : {TrackConstruction::kParallel, TrackConstruction::kPaper}) {
      request.settings = {};
      request.settings.shape = TrackShape::kCurved;
      request.settings.guide.assign(field.outer.begin(), field.outer.begin() + 4);
      request.settings.tracks = tracks;
      if (tracks == TrackConstruction::kPaper) {
        request.settings.obstacle_headlands = 1;
        request.settings.end_rule = EndRule::kCover;
        request.machine.min_length_m = 0;
      }
      const auto plan = try_plan(field, request);
      if (!plan) continue;
      any = true;
      const double width_m = request.machine.width_m;
      Region left = plan->body;
      double sum = 0;
      for (const TrackPiece& piece : plan->pieces) {
        Region own;
        for (Ring& part : swath_parts(piece, width_m, kLayerSagitta)) own.push_back({std::move(part), {}});
        own = unite(own);
        const double useful_m2 = area(intersection(own, left));
        left = difference(left, own);
        const double tolerance_m2 = 4 * kLayerSagitta * (length(piece) + width_m);
        EXPECT_NEAR(piece.overlap_m2.value_or(-1), width_m * length(piece) - useful_m2, tolerance_m2);
        sum += piece.overlap_m2.value_or(0);
        detours += static_cast<int>(piece.detours.size());
        kinked += tracks == TrackConstruction::kPaper && piece.curve.size() > 1 ? 1 : 0;
      }
      EXPECT_NEAR(sum, plan->track_tally.overlap_m2, 1e-6 * area(Polygon{field.outer, {}}));
    }
    return any;
  });
  EXPECT_GT(detours, 0);
  EXPECT_GT(kinked, 0);
}

/// Zhou's L·w − O = |F_b|, with tracks that begin at the envelope on either side, by strips and by the
/// paper's own construction along a straight line with its plain headlands.
TEST_F(PlanProperties, MapsBegunAtTheEnvelopeCoverTheBody) {
  for_random_fields(15, [&](Field field, Request request) {
    std::erase_if(field.obstacles, [](const Obstacle& o) { return o.kind == ObstacleKind::kPassable; });
    bool any = false;
    for (const TrackConstruction tracks : {TrackConstruction::kParallel, TrackConstruction::kPaper}) {
      request.settings = {};
      request.settings.guide = {field.outer[1], field.outer[0]};
      request.settings.ab_anchor = AbAnchor::kEnvelope;
      request.settings.tracks = tracks;
      request.settings.end_rule = EndRule::kCover;
      request.settings.headlands = request.settings.obstacle_headlands = 1;
      request.machine.min_length_m = 0;
      const auto plan = try_plan(field, request);
      if (!plan) continue;
      any = true;
      const double tolerance = 1e-6 * area(Polygon{field.outer, {}}) + 1e-3;
      const Tally& tally = plan->track_tally;
      EXPECT_NEAR(request.machine.width_m * tally.track_length_m - tally.overlap_m2, area(plan->body),
                  tolerance);
      EXPECT_NEAR(tally.uncovered_m2, 0, tolerance);
      EXPECT_NEAR(identity_error_m2(*plan), 0, tolerance);
      const Headland& headland = plan->headland;
      EXPECT_NEAR(headland.worked_m2, area(headland.ground) - headland.uncovered_m2 + headland.overlap_m2,
                  tolerance);
    }
    return any;
  });
}

/// Hard land is entered by no swath; what the end rule promises holds for whole swaths.
TEST_F(PlanProperties, SwathsKeepOffHardLandAndWithinTheirRule) {
  for_random_fields(20, [](const Field& field, const Request& request) {
    const auto plan = try_plan(field, request);
    if (!plan) return false;
    const double tolerance = 1e-3 * (1 + plan->tally.track_length_m * 1e-3);
    const Region worked = unite(swaths(*plan));
    for (const Obstacle& obstacle : field.obstacles)
      EXPECT_LT(area(intersection(worked, {obstacle.shape})), tolerance) << obstacle.origin;
    EXPECT_LT(area(intersection(worked, plan->given_up)), tolerance);
    const Region outside = difference(worked, {{field.outer, {}}});
    // A detour's swath may pass a soft edge, whatever the end rule.
    const bool straight = std::all_of(plan->pieces.begin(), plan->pieces.end(),
                                      [](const TrackPiece& piece) { return piece.detours.empty(); });
    if (request.settings.boundary == EdgeKind::kHard ||
        (request.settings.end_rule == EndRule::kInside && straight)) {
      EXPECT_LT(area(outside), tolerance);
    }
    // Every cross-section of a swath reaches the field: nothing of it is a width away.
    for (const Polygon& part : outside)
      EXPECT_LT(distance_between({part}, {{field.outer, {}}}), request.machine.width_m);
    for (const TrackPiece& piece : plan->pieces) {
      const bool long_enough = length(piece) > min_length_m(plan->machine) - 1e-9;
      EXPECT_TRUE(long_enough || piece.after_crossing);
    }
    return true;
  });
}

TEST_F(PlanProperties, CoverLeavesOnlyHardAndShortPiecesUncovered) {
  for_random_fields(60, [](const Field& field, Request request) {
    request.settings.end_rule = EndRule::kCover;
    request.settings.boundary = EdgeKind::kSoft;
    request.machine.min_length_m = 0;
    Field open = field;
    open.obstacles.clear();
    const auto plan = try_plan(open, request);
    if (!plan) return false;
    // What stays is thinner than the planner's tolerance of 10 micrometres, along edges and borders.
    EXPECT_LT(plan->tally.uncovered_m2, 1e-4 * perimeter(open.outer) + 1e-3);
    return true;
  });
}

TEST_F(PlanProperties, OneAndFourThreadsGiveTheSamePlan) {
  for_random_fields(6, [](const Field& field, const Request& request) {
    const auto one = try_plan(field, request, 1), four = try_plan(field, request, 4);
    EXPECT_EQ(one.has_value(), four.has_value());
    if (!one || !four) return false;
    EXPECT_EQ(one->cost, four->cost);
    EXPECT_EQ(one->pieces.size(), four->pieces.size());
    for (std::size_t i = 0; i < one->pieces.size() && i < four->pieces.size(); ++i) {
      EXPECT_EQ(one->pieces[i].start, four->pieces[i].start);
      EXPECT_EQ(one->pieces[i].end, four->pieces[i].end);
    }
    return true;
  });
}

// The candidates of the sweep are the same set whatever the frame, so the least cost is the same as long as
// no two candidates tie: random fields are in general position.
TEST_F(PlanProperties, CostDoesNotChangeWhenTheFieldIsTurnedOrMoved) {
  for_random_fields(15, [](const Field& field, Request request) {
    request.settings.strategy = Strategy::kSweep;
    const auto plan = try_plan(field, request);
    if (!plan) return false;
    for (const Field& other : {testing::quarter_turned(field), testing::shifted(field, {613.25, -1207.5})}) {
      const auto moved = try_plan(other, request);
      if (!moved) {
        ADD_FAILURE() << "no plan in the other frame";
        continue;
      }
      EXPECT_NEAR(moved->tally.overlap_m2, plan->tally.overlap_m2, 1e-6 * area_m2(field));
      EXPECT_NEAR(moved->tally.uncovered_m2, plan->tally.uncovered_m2, 1e-6 * area_m2(field));
      EXPECT_EQ(moved->tally.turns, plan->tally.turns);
      EXPECT_EQ(moved->tally.stops, plan->tally.stops);
    }
    return true;
  });
}

/// A waterway across the field: the pieces on both banks are one track, and the verdict of the other
/// road on the areas is the same.
TEST_F(PlanProperties, PassableObstaclesCostNeitherTurnsNorStops) {
  for_random_fields(8, [](const Field& field, const Request& request) {
    Field crossed = field;
    const Box box = bounds(field.outer);
    const Polygon waterway{
        {{box.min_x - 5, -2.5}, {box.max_x + 5, -1.5}, {box.max_x + 5, 2.5}, {box.min_x - 5, 1.5}}, {}};
    Region solid;
    for (const Obstacle& obstacle : field.obstacles) solid.push_back(obstacle.shape);
    for (const Polygon& part : difference(intersection({waterway}, {{field.outer, {}}}), unite(solid)))
      crossed.obstacles.push_back({part, ObstacleKind::kPassable, "waterway"});
    const auto plan = try_plan(crossed, request);
    if (!plan) return false;
    const double tolerance = 1e-6 * area_m2(field);
    const double useful = area(intersection(unite(swaths(*plan)), plan->body));
    EXPECT_NEAR(plan->tally.uncovered_m2, area(plan->body) - useful, tolerance);
    EXPECT_EQ(plan->tally.turns, std::max(0, plan->tally.pieces - 1 - plan->tally.crossings));
    int crossings = 0;
    for (std::size_t i = 0; i < plan->pieces.size(); ++i) {
      if (!plan->pieces[i].after_crossing) continue;
      ++crossings;
      if (i == 0) {
        ADD_FAILURE() << "the first piece follows no other";
        continue;
      }
      const TrackPiece &before = plan->pieces[i - 1], &after = plan->pieces[i];
      EXPECT_FALSE(before.stop_at_end || after.stop_at_start);
      EXPECT_NEAR(cross(before.end - before.start, after.end - before.start) / length(before), 0, 1e-6);
      EXPECT_LT(
          area(intersection({{swath({before.end, after.start}, plan->machine.width_m), {}}}, unite(solid))),
          1e-3);
    }
    EXPECT_EQ(crossings, plan->tally.crossings);
    return true;
  });
}

}  // namespace tramline::plan_properties_test
