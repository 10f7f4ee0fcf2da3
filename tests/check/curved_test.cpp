// Plans with curved tracks: known by hand where they hold, and found out where they do not.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "check/plans.h"
#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/cross_section.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

using namespace testing_plans;

void replace_curve(TrackPiece& piece, const Path& curve) {
  piece.curve = curve;
  piece.start = curve.front().from;
  piece.end = curve.back().to;
}

/// Both halves of the land are subfields, and every track is in both.
TEST(CurvedPlans, TracksGoThroughPartsThatLieSideBySide) {
  Plan plan = arcs_plan();
  const Polygon first{ring_sector(30, 45, 0, 45), {}}, second{ring_sector(30, 45, 45, 90), {}};
  const Direction direction = plan.subfields[0].direction;
  plan.body = {first, second};
  const Path reference = plan.subfields[0].reference;
  plan.subfields = {{first, direction, reference}, {second, direction, reference}};
  EXPECT_EQ(found(settled(plan)).count("ends"), 0u);
  plan.body = {first};
  plan.subfields.pop_back();
  EXPECT_EQ(found(settled(plan)).count("ends"), 1u);
}

/// The inner two tracks are a subfield along the inner edge, the outer three one along the line between.
TEST(CurvedPlans, SubfieldsFollowLinesOfTheirOwn) {
  Plan plan = arcs_plan();
  const Direction direction = plan.subfields[0].direction;
  const Path inner = plan.subfields[0].reference,
             middle = {{{36, -60}, {36, 0}, 0}, {{36, 0}, {0, 36}, 1.0 / 36}, {{0, 36}, {-60, 36}, 0}};
  plan.subfields = {{{ring_sector(30, 36, 0, 90), {}}, direction, inner},
                    {{ring_sector(36, 45, 0, 90), {}}, direction, middle}};
  for (int i = 2; i < 5; ++i) {
    plan.pieces[i].subfield = 1;
    plan.pieces[i].track -= 2;
  }
  plan = settled(plan);
  expect_holds(plan);
  // Numbered along the other's line, the tracks lie two widths off where they should.
  std::swap(plan.subfields[0].reference, plan.subfields[1].reference);
  EXPECT_TRUE(found(settled(plan)).contains("parallel"));
}

TEST(CurvedPlans, ArcsAboutOnePointHoldUnderEveryEndRule) {
  Plan plan = arcs_plan();
  for (const EndRule rule : {EndRule::kCentre, EndRule::kCover, EndRule::kInside, EndRule::kCheapest})
    for (const EdgeKind boundary : {EdgeKind::kSoft, EdgeKind::kHard}) {
      plan.settings.end_rule = rule;
      plan.settings.boundary = boundary;
      expect_holds(plan);
    }
  EXPECT_NEAR(plan.tally.worked_m2, std::numbers::pi / 4 * (45 * 45 - 30 * 30), 1e-9);
  EXPECT_NEAR(plan.tally.overlap_m2, 0, 1e-2);
  EXPECT_NEAR(plan.tally.uncovered_m2, 0, 1e-2);
  EXPECT_EQ(plan.tally.turns, 4);
  EXPECT_EQ(plan.tally.stops, 0);
}

TEST(CurvedPlans, FollowAReferenceLine) {
  Plan plan = arcs_plan();
  plan.subfields[0].reference.clear();
  EXPECT_TRUE(found(plan).contains("pieces"));
}

TEST(CurvedPlans, ObstacleAcrossACurvedTrack) {
  const Plan plan = blocked_arc_plan();
  expect_holds(plan);
  EXPECT_EQ(plan.tally.stops, 2);
  EXPECT_EQ(plan.tally.pieces, 6);
}

TEST(CurvedPlans, TurningAndMovingChangesNothing) {
  for (const double degrees : {1.0, 122.4})
    for (const Plan& plan : {arcs_plan(), blocked_arc_plan()})
      expect_holds(settled(turned(plan, Angle::degrees(degrees), {-712.3, 455.1})));
}

/// A ditch like a spoke: the work is interrupted, and the track goes on.
TEST(CurvedPlans, Crossings) {
  Plan plan = arcs_plan();
  const auto on = [](double radius_m, double degrees) {
    const double radians = degrees * std::numbers::pi / 180;
    return Point{radius_m * std::cos(radians), radius_m * std::sin(radians)};
  };
  const Path middle{{on(37.5, 40), on(37.5, 44), 1 / 37.5}};
  const Ring ditch = check::bands_along(middle, 15, kLayerSagitta)[0].outer;
  plan.field.obstacles = {{{ditch, {}}, ObstacleKind::kPassable, "ditch"}};
  plan.body = difference(plan.body, {{ditch, {}}});
  plan.pieces.clear();
  for (int i = 0; i < 5; ++i) {
    plan.pieces.push_back(i % 2 == 0 ? arc_piece(i, 0, 40) : arc_piece(i, 44, 90));
    plan.pieces.push_back(i % 2 == 0 ? arc_piece(i, 44, 90) : arc_piece(i, 0, 40));
    plan.pieces.back().after_crossing = true;
  }
  plan = settled(plan);
  expect_holds(plan);
  EXPECT_EQ(plan.tally.turns, 4);

  // The same track, but behind.
  Plan backwards = plan;
  std::swap(backwards.pieces[0], backwards.pieces[1]);
  backwards.pieces[0].after_crossing = false;
  backwards.pieces[1].after_crossing = true;
  EXPECT_EQ(found(settled(backwards)), Names{"crossings"});
  Plan other = plan;
  other.pieces[1].track = 7;
  EXPECT_EQ(found(other), (Names{"crossings", "parallel"}));
}

TEST(CurvedPlans, CrossingWithoutAPassable) {
  Plan plan = arcs_plan();
  plan.pieces[0] = arc_piece(0, 0, 40);
  plan.pieces.insert(plan.pieces.begin() + 1, arc_piece(0, 44, 90));
  plan.pieces[1].after_crossing = true;
  EXPECT_EQ(found(settled(plan)), Names{"crossings"});
}

/// Nearer to its neighbour by ten centimetres, with a tally that says so.
TEST(CurvedPlans, PieceMovedOntoItsNeighbour) {
  Plan plan = arcs_plan();
  plan.settings.end_rule = EndRule::kCentre;
  const auto with_radius = [&plan](double radius_m) {
    Plan moved = plan;
    const Point from{radius_m, 0}, to{0, radius_m};
    replace_curve(moved.pieces[2], {{from, to, 1 / radius_m}});
    return found(settled(moved));
  };
  EXPECT_EQ(with_radius(37.5), Names{});
  EXPECT_EQ(with_radius(37.5005), Names{});
  EXPECT_EQ(with_radius(37.502), Names{"parallel"});
  EXPECT_EQ(with_radius(37.6), Names{"parallel"});
  EXPECT_EQ(with_radius(37.4), Names{"parallel"});
  Plan moved = plan;
  for (TrackPiece* piece : {&moved.pieces[2]}) {
    for (PathSegment& segment : piece->curve) {
      segment.from = segment.from + Point{0.1, 0};
      segment.to = segment.to + Point{0.1, 0};
    }
    replace_curve(*piece, piece->curve);
  }
  EXPECT_TRUE(found(settled(moved)).contains("parallel"));
  // Driven twice.
  Plan twice = plan;
  twice.pieces.push_back(twice.pieces[2]);
  EXPECT_EQ(found(settled(twice)), Names{"parallel"});
}

/// Away from its only neighbour: no two pieces are too near to one another.
TEST(CurvedPlans, OutermostPieceOffItsDistance) {
  const auto with = [](const Path& curve) {
    Plan plan = arcs_plan();
    plan.settings.end_rule = EndRule::kCentre;
    replace_curve(plan.pieces[4], curve);
    return found(settled(plan));
  };
  const auto about_origin = [](double radius_m) {
    return Path{{{radius_m, 0}, {0, radius_m}, 1 / radius_m}};
  };
  EXPECT_EQ(with(about_origin(43.5)), Names{});
  EXPECT_EQ(with(about_origin(43.5005)), Names{});
  EXPECT_EQ(with(about_origin(43.502)), Names{"parallel"});
  // Its ends are where they were: with h = 43.5/√2 the arc stands out by 4 mm more, r − √(r² − h²).
  EXPECT_EQ(with({{{43.5, 0}, {0, 43.5}, 1 / 43.49}}), Names{"parallel"});
  // In one stretch only.
  const Point sixty{21.75, 21.75 * std::numbers::sqrt3};
  const Path bent{{{43.5, 0}, sixty, 1 / 43.5}, {sixty, {0, 43.5}, 1 / 42.0}};
  EXPECT_TRUE(with(bent).contains("parallel"));
}

TEST(CurvedPlans, TracksOfOtherNumbers) {
  Plan plan = arcs_plan();
  std::swap(plan.pieces[1].track, plan.pieces[3].track);
  EXPECT_EQ(found(plan), Names{"parallel"});
  plan = arcs_plan();
  for (TrackPiece& piece : plan.pieces) ++piece.track;
  EXPECT_EQ(found(plan), Names{"parallel"});
  plan = arcs_plan();
  for (TrackPiece& piece : plan.pieces) piece.track = -1 - piece.track;  // on the reference's other side
  EXPECT_EQ(found(plan), Names{"parallel"});
  plan.subfields[0].reference = reversed(plan.subfields[0].reference);
  EXPECT_EQ(found(plan), Names{});
}

TEST(CurvedPlans, MovedPieceWithTheOldTally) {
  Plan plan = arcs_plan();
  replace_curve(plan.pieces[4], {{{43.4, 0}, {0, 43.4}, 1 / 43.4}});
  EXPECT_EQ(found(plan), (Names{"parallel", "tally"}));
}

TEST(CurvedPlans, CurveThatCannotBeDriven) {
  Plan plan = arcs_plan();
  plan.machine.radius_m = 31.5;
  EXPECT_EQ(found(settled(plan)), Names{});
  plan.machine.radius_m = 32;
  EXPECT_EQ(found(settled(plan)), Names{"drivable"});
  // A kink: two arcs that meet at an angle.
  plan = arcs_plan();
  plan.settings.end_rule = EndRule::kCover;
  const double half = std::numbers::sqrt2 / 2;
  const Point from = plan.pieces[4].start, to = plan.pieces[4].end;
  const Point middle{43.5 * half, 43.5 * half};
  replace_curve(plan.pieces[4], {{from, middle, 1 / 46.0}, {middle, to, 1 / 46.0}});
  EXPECT_TRUE(found(settled(plan)).contains("drivable"));
}

TEST(CurvedPlans, EndBeyondTheBody) {
  const auto with_end = [](EndRule rule, double to_deg) {
    Plan plan = arcs_plan();
    plan.settings.end_rule = rule;
    plan.pieces[2] = arc_piece(2, 0, to_deg);
    return found(settled(plan));
  };
  for (const EndRule rule : {EndRule::kInside, EndRule::kCover, EndRule::kCentre, EndRule::kCheapest}) {
    EXPECT_EQ(with_end(rule, 90.001), Names{});  // 0.65 mm
    EXPECT_EQ(with_end(rule, 90.01), Names{"ends"});
    EXPECT_EQ(with_end(rule, 80), Names{});
  }
}

/// North of the line y = h, which crosses the spokes obliquely, is nothing: at the angle φ a spoke is inside
/// up to h/sin φ.
TEST(CurvedPlans, EndsAtAnObliqueEdge) {
  const double h = 25;
  Plan plan = arcs_plan();
  plan.field.outer = difference({{plan.field.outer, {}}}, {{box(-50, h, 50, 50), {}}})[0].outer;
  plan.body = {{plan.field.outer, {}}};
  plan.subfields[0].shape = plan.body[0];
  const auto driven = [&plan, h](EndRule rule, double share, double further_m) {
    Plan out = plan;
    out.settings.end_rule = rule;
    for (int i = 0; i < 5; ++i) {
      const double radius_m = 31.5 + 3 * i, at_edge = radius_m - 1.5 + 3 * share;
      const double angle = std::asin(h / at_edge) + further_m / radius_m;
      out.pieces[static_cast<std::size_t>(i)] = arc_piece(i, 0, angle * 180 / std::numbers::pi);
    }
    return found(settled(out));
  };
  const double share = cheapest_share(Objective{});
  for (const auto& [rule, f] : {std::pair{EndRule::kCentre, 0.5}, std::pair{EndRule::kCover, 0.0},
                                std::pair{EndRule::kInside, 1.0}, std::pair{EndRule::kCheapest, share}}) {
    EXPECT_EQ(driven(rule, f, 0), Names{}) << name(rule);
    EXPECT_EQ(driven(rule, f, 0.01), Names{"ends"}) << name(rule);
    EXPECT_EQ(driven(rule, f, -0.5), Names{}) << name(rule);
  }
}

TEST(CurvedPlans, SwathInAnObstacleOrBeyondAHardBoundary) {
  const auto with_end = [](double to_deg) {
    Plan plan = blocked_arc_plan();
    plan.pieces[2] = arc_piece(2, 0, to_deg);
    plan.pieces[2].stop_at_end = true;
    plan.settings.end_rule = EndRule::kCover;
    return found(settled(plan));
  };
  EXPECT_EQ(with_end(40), Names{});
  EXPECT_EQ(with_end(40.001), Names{});  // 0.65 mm
  EXPECT_TRUE(with_end(40.01).contains("swaths"));

  Plan plan = arcs_plan();
  plan.settings.boundary = EdgeKind::kHard;
  replace_curve(plan.pieces[4], {{{43.51, 0}, {0, 43.51}, 1 / 43.51}});
  EXPECT_TRUE(found(settled(plan)).contains("swaths"));
  plan.settings.boundary = EdgeKind::kSoft;
  EXPECT_FALSE(found(settled(plan)).contains("swaths"));

  // Over land given up, which is no obstacle.
  plan = blocked_arc_plan();
  plan.given_up = {plan.field.obstacles[0].shape};
  plan.field.obstacles.clear();
  plan.body[0].holes.clear();
  plan.encounters[0].obstacles.clear();
  EXPECT_EQ(found(settled(plan)), Names{});
  plan.pieces[3] = arc_piece(2, 49.9, 90);
  plan.pieces[3].stop_at_start = true;
  EXPECT_TRUE(found(settled(plan)).contains("swaths"));
}

TEST(CurvedPlans, Clearance) {
  Plan plan = blocked_arc_plan();
  plan.settings.clearance_m = 0.5;
  EXPECT_EQ(found(plan), Names{"clearance"});
}

TEST(CurvedPlans, WrongStopsAndEncounters) {
  Plan plan = blocked_arc_plan();
  plan.pieces[2].stop_at_end = false;
  EXPECT_EQ(found(plan), Names{"stops"});
  plan = blocked_arc_plan();
  plan.pieces[0].stop_at_end = true;
  EXPECT_EQ(found(plan), Names{"stops"});
  plan = blocked_arc_plan();
  plan.encounters[0].at = check::point_on(plan.pieces[2].curve, 10);
  EXPECT_EQ(found(plan), Names{"encounters"});
}

/// Where something lies across a curved track there is an encounter that names it.
TEST(CurvedPlans, EncountersLeftOut) {
  Plan plan = blocked_arc_plan();
  plan.encounters.clear();
  EXPECT_EQ(found(plan), Names{"encounters"});
  plan = blocked_arc_plan();
  plan.encounters[0].obstacles.clear();
  EXPECT_EQ(found(plan), Names{"encounters"});
  // Nor may a cut lie where the track does not run: in the second track beside it.
  plan = blocked_arc_plan();
  plan.encounters[0].at = (34.5 / 37.5) * plan.encounters[0].at;
  EXPECT_EQ(found(plan), Names{"encounters"});
}

TEST(CurvedPlans, FalseFigures) {
  const auto with = [](auto change) {
    Plan plan = blocked_arc_plan();
    change(plan);
    return found(plan);
  };
  EXPECT_EQ(with([](Plan& p) { p.tally.worked_m2 += 0.05; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.overlap_m2 += 0.05; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.uncovered_m2 += 0.05; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.track_length_m += 0.001; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.overlap.push_back({box(31, 1, 32, 2), {}}); }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.uncovered.push_back({box(31, 1, 32, 2), {}}); }), Names{"tally"});
}

/// Land worked twice has to be in the layer.
TEST(CurvedPlans, OverlapThatIsNotShown) {
  Plan plan = arcs_plan();
  replace_curve(plan.pieces[2], {{{37.6, 0}, {0, 37.6}, 1 / 37.6}});
  plan = settled(plan);
  EXPECT_GT(area(plan.overlap), 1);
  EXPECT_EQ(found(plan), Names{"parallel"});
  plan.overlap.clear();
  EXPECT_EQ(found(plan), (Names{"parallel", "tally"}));
}

TEST(CurvedPlans, TooShortACurve) {
  Plan plan = arcs_plan();
  plan.pieces[2] = arc_piece(2, 0, 9);  // 5.89 m of 6 m
  EXPECT_EQ(found(settled(plan)), Names{"length"});
}

TEST(CurvedPlans, UnsoundCurves) {
  const auto with = [](auto change) {
    Plan plan = arcs_plan();
    change(plan.pieces[2]);
    return found(plan);
  };
  EXPECT_EQ(with([](TrackPiece& p) { p.end.x += 0.01; }), Names{"pieces"});
  EXPECT_EQ(with([](TrackPiece& p) { p.start.y -= 0.01; }), Names{"pieces"});
  EXPECT_EQ(with([](TrackPiece& p) { p.curve[0].curvature = 0.1; }), Names{"pieces"});
  EXPECT_EQ(with([](TrackPiece& p) { p.curve.push_back(p.curve[0]); }), Names{"pieces"});
  EXPECT_EQ(with([](TrackPiece& p) {
              p.detours.push_back({reversed(p.curve), Passing::kLeft, {}});
            }),
            Names{"pieces"});
  EXPECT_EQ(with([](TrackPiece& p) { p.detours.push_back({p.curve, Passing::kCut, {}}); }), Names{"pieces"});
  // Straight tracks still lie in the direction of their subfield.
  Plan plan = rectangle_plan();
  plan.pieces[4].end.y += 0.01;
  plan.subfields[0].reference = straight_path({0, 0}, {100, 0});
  EXPECT_EQ(found(plan), Names{"pieces"});
}

/// Of a family along a line with a bend, tracks may have straight pieces, in another direction than others.
TEST(CurvedPlans, StraightPiecesOfABentFamily) {
  Plan plan = arcs_plan();
  plan.field.outer = {{30, -20}, {45, -20}};
  for (const Point p : chords(Path{{{45, 0}, {0, 45}, 1 / 45.0}}, kLayerSagitta))
    plan.field.outer.push_back(p);
  for (const Point p : chords(Path{{{0, 30}, {30, 0}, -1 / 30.0}}, kLayerSagitta))
    plan.field.outer.push_back(p);
  plan.body = {{plan.field.outer, {}}};
  plan.subfields[0].shape = plan.body[0];
  for (int i = 0; i < 5; ++i) {
    const double x = 31.5 + 3 * i;
    Path curve{{{x, -20}, {x, 0}, 0}, arc_piece(0, 0, 90).curve[0]};
    curve[1] = {{x, 0}, {0, x}, 1 / x};
    replace_curve(plan.pieces[static_cast<std::size_t>(i)], i % 2 == 0 ? curve : reversed(curve));
  }
  expect_holds(settled(plan));
  // The innermost in two.
  TrackPiece straight;
  straight.start = {31.5, -20};
  straight.end = {31.5, 0};
  replace_curve(plan.pieces[0], {{{31.5, 0}, {0, 31.5}, 1 / 31.5}});
  plan.pieces.push_back(straight);
  expect_holds(settled(plan));
  plan.pieces.back().start.x += 0.1;
  plan.pieces.back().end.x += 0.1;
  EXPECT_EQ(found(settled(plan)), Names{"parallel"});
}

/// An obstacle between two straight pieces of a track that is bent elsewhere.
TEST(CurvedPlans, ObstacleAcrossTheStraightPartOfABentTrack) {
  Plan plan = arcs_plan();
  const auto piece = [](Point start, Point end) {
    TrackPiece out;
    out.track = 0;
    out.start = start;
    out.end = end;
    return out;
  };
  plan.pieces.push_back(piece({31.5, -30}, {31.5, -20}));
  plan.pieces.push_back(piece({31.5, -15}, {31.5, -5}));
  plan.field.obstacles = {{{box(31, -20, 32, -15), {}}, ObstacleKind::kObstacle, "trough"}};
  EXPECT_TRUE(found(settled(plan)).contains("encounters"));
  plan.encounters = {encounter_on(plan.pieces.back(), {31.5, -17.5}, {0}, Passing::kCut)};
  EXPECT_FALSE(found(settled(plan)).contains("encounters"));
}

/// Against many looks with nothing clever about them, on land with corners and a hole under the swath.
TEST(CurvedPlans, CrossSectionsOfArcs) {
  const Polygon land{{{-60, -3}, {60, 1}, {35, 20}, {41, 24}, {22, 31}, {25, 60}, {-60, 60}},
                     {{{10, 33}, {6, 36}, {9, 39}, {12, 36}}}};
  const double half = 2;
  for (const double radius_m : {33.0, 36.0, 39.0})
    for (const bool backwards : {false, true}) {
      Path path{{{radius_m, 0}, {0, radius_m}, 1 / radius_m}};
      if (backwards) path = reversed(path);
      for (const double required : {1e-9, 1.0, 2.5, 3.999}) {
        const check::Stretch stretch = check::longest_below(land, path, half, required);
        double longest = 0, run = 0;
        const int looks = 4000;
        for (int i = 0; i < looks; ++i) {
          const double angle = (i + 0.5) / looks * std::numbers::pi / 2;
          const Point out{std::cos(angle), std::sin(angle)};
          double inside = 0;
          for (int k = 0; k < 400; ++k)
            if (contains(land, (radius_m - half + (k + 0.5) / 400 * 2 * half) * out))
              inside += 2 * half / 400;
          run = inside < required ? run + 1 : 0;
          longest = std::max(longest, run);
        }
        EXPECT_NEAR(stretch.length(), longest / looks * std::numbers::pi / 2 * radius_m, 0.15)
            << radius_m << ' ' << required;
      }
    }
}

/// A hundred long tracks along a line with many bends.
TEST(CurvedPlans, LargePlansAreJudged) {
  Plan plan;
  plan.machine.width_m = 3;
  const int tracks = 60, waves = 6;
  // Arcs to the left and to the right of 15° each, about points on two rows.
  const auto line = [](double off) {
    Path curve;
    Point at{0, off}, heading{1, 0};
    for (int k = 0; k < waves; ++k)
      for (const double side : {1.0, -1.0}) {
        const double base = 400, radius_m = base - side * off, angle = side * std::numbers::pi / 12;
        const Point left{-heading.y, heading.x};
        const Point centre = at + side * radius_m * left;
        const Point spoke = at - centre;
        const Point to = centre + Point{spoke.x * std::cos(angle) - spoke.y * std::sin(angle),
                                        spoke.x * std::sin(angle) + spoke.y * std::cos(angle)};
        curve.push_back({at, to, side / radius_m});
        heading = direction_at_end(curve.back());
        at = to;
      }
    return curve;
  };
  for (int i = 0; i < tracks; ++i) {
    TrackPiece piece;
    piece.track = i;
    replace_curve(piece, line(1.5 * tracks - 3 * (i + 0.5)));
    plan.pieces.push_back(piece);
  }
  plan.field.outer = band(plan.pieces[tracks / 2].curve, 3.0 * tracks + 3, kLayerSagitta);
  plan.body = {{plan.field.outer, {}}};
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(90)), line(1.5 * tracks)}};
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(verdict.complete);
  EXPECT_FALSE(rules(verdict).contains("parallel"));
}

}  // namespace
}  // namespace tramline
