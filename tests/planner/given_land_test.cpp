// Land that the user divides by hand, leaves out, has done already or plans for alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "properties/seeds.h"
#include "support/temporary_folder.h"
#include "tramline/admission/given/place_subfields.h"
#include "tramline/check/file/compare_warnings.h"
#include "tramline/check/verify.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/io/plan/fields_in.h"
#include "tramline/io/plan/plan_metadata.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/planner/given/narrow_tails.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

using testing::SeededRandom;

const Machine kFiveMetres{"", 5, 5, -1};

Polygon rectangle(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

Direction north_and_south() { return Direction::clockwise_from_north(Angle::degrees(0)); }
Direction east_and_west() { return Direction::clockwise_from_north(Angle::degrees(90)); }

/// 100 m from west to east, 60 m from south to north.
Field oblong() {
  Field field;
  field.id = "oblong";
  field.outer = rectangle(0, 0, 100, 60).outer;
  return field;
}

// Both run over the edge of the field.
Region western_half() { return {rectangle(-10, -10, 50, 70)}; }
Region eastern_half() { return {rectangle(50, -10, 110, 70)}; }

Plan planned(const GivenLand& given, const Machine& machine = kFiveMetres, PlanSettings settings = {}) {
  settings.given = given;
  return plan_field(oblong(), machine, {}, settings);
}

std::string faults(const Plan& plan) {
  std::string out;
  const check::Verdict verdict = check::verify(plan);
  for (const check::Violation& violation : verdict.violations) out += violation.what + "\n";
  return verdict.complete ? out : out + "not complete";
}

bool warns(const Plan& plan, const std::string& words) {
  return std::any_of(plan.warnings.begin(), plan.warnings.end(),
                     [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

std::vector<double> lengths_in(const Plan& plan, std::size_t subfield) {
  std::vector<double> out;
  for (const TrackPiece& piece : plan.pieces)
    if (piece.subfield == subfield) out.push_back(length(piece));
  return out;
}

void expect_all_near(const std::vector<double>& values, double expected) {
  for (const double value : values) EXPECT_NEAR(value, expected, 1e-6);
}

// The eastern half takes 50/5 = 10 tracks of 60 m from south to north, the western 60/5 = 12 of 50 m from
// west to east: 1200 m, 21 turns and a further subfield, with nothing worked twice.
TEST(GivenLand, EachHalfIsDrivenInItsOwnDirection) {
  GivenLand given;
  given.subfields = {{eastern_half(), "halves feature 1", north_and_south()},
                     {western_half(), "halves feature 2", east_and_west()}};
  for (const Strategy strategy : {Strategy::kBest, Strategy::kSweep}) {
    PlanSettings settings;
    settings.strategy = strategy;
    const Plan plan = planned(given, kFiveMetres, settings);
    EXPECT_EQ(faults(plan), "");
    ASSERT_EQ(plan.subfields.size(), 2U);
    EXPECT_EQ(plan.subfields[0].given_by, "halves feature 1");
    EXPECT_EQ(lengths_in(plan, 0).size(), 10U);
    expect_all_near(lengths_in(plan, 0), 60);
    EXPECT_EQ(lengths_in(plan, 1).size(), 12U);
    expect_all_near(lengths_in(plan, 1), 50);
    EXPECT_EQ(plan.tally.turns, 21);
    EXPECT_NEAR(plan.tally.overlap_m2, 0, 1e-6);
    EXPECT_NEAR(plan.tally.uncovered_m2, 0, 1e-6);
    EXPECT_NEAR(plan.cost, 21 + 5, 1e-6);
  }
}

// At 7 m the western half takes 9 swaths of 50 m, 150 m² too much. In the eastern half swaths lie flush with
// x = 46: 8 of 60 m, 4 m of the first within the other half, and 2 m of the last over the edge, 360 m² too
// much.
TEST(GivenLand, OverlapAtTheSeamCounts) {
  GivenLand given;
  given.subfields = {{eastern_half(), "e", std::nullopt, {{46, 0}, {46, 60}}},
                     {western_half(), "w", east_and_west()}};
  const Plan plan = planned(given, {"", 7, 5, -1});
  EXPECT_EQ(faults(plan), "");
  EXPECT_EQ(plan.tally.pieces, 17);
  EXPECT_NEAR(plan.tally.overlap_m2, 510, 1e-6);
  EXPECT_NEAR(plan.tally.uncovered_m2, 0, 1e-6);
  EXPECT_NEAR(area(intersection(plan.overlap, {rectangle(0, 0, 50, 60)})), 240, 1e-6);
}

// Halves without a direction are 50 m by 60 m: 10 tracks of 60 m, not 12 of 50 m.
TEST(GivenLand, ACutMakesPartsThatAreSearched) {
  GivenLand given;
  given.cuts = {{{{50, -20}, {50, 80}}, "cut feature 1"}};
  const Plan plan = planned(given);
  EXPECT_EQ(faults(plan), "");
  ASSERT_EQ(plan.subfields.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(plan.subfields[i].given_by, "cut feature 1");
    EXPECT_NEAR(area(plan.subfields[i].shape), 3000, 1e-6);
    EXPECT_EQ(lengths_in(plan, i).size(), 10U);
  }
}

TEST(GivenLand, ACutThatEndsShortOfTheEdgeIsExtended) {
  GivenLand given;
  given.cuts = {{{{50, 2}, {50, 57}}, "short"}, {{{80, 20}, {80, 40}}, "inside"}};
  const Plan plan = planned(given);
  EXPECT_EQ(faults(plan), "");
  EXPECT_EQ(plan.subfields.size(), 2U);
  EXPECT_TRUE(warns(plan, "inside divides nothing"));
  EXPECT_FALSE(warns(plan, "short divides nothing"));
}

// What no polygon takes is planned as ever: 100 m less 40 m in the middle leaves two parts of 30 m by 60 m,
// six tracks of 60 m each; the middle one gets 60/5 = 12 tracks of 40 m.
TEST(GivenLand, TheRestIsSearched) {
  GivenLand given;
  given.subfields = {{{rectangle(30, -5, 70, 65)}, "middle", east_and_west()}};
  const Plan plan = planned(given);
  EXPECT_EQ(faults(plan), "");
  ASSERT_EQ(plan.subfields.size(), 3U);
  EXPECT_EQ(plan.subfields[0].given_by, "middle");
  EXPECT_EQ(plan.subfields[1].given_by, "");
  EXPECT_EQ(plan.tally.pieces, 12 + 6 + 6);
  EXPECT_NEAR(plan.cost, 23 + 2 * 5, 1e-6);
}

TEST(GivenLand, TracksFollowALineThatIsNamed) {
  GivenLand given;
  given.subfields = {{eastern_half(), "e", std::nullopt, {{60, 0}, {60, 10}}},
                     {western_half(), "w", std::nullopt, {{0, 10}, {25, 13}, {50, 22}}}};
  const Plan plan = planned(given);
  EXPECT_EQ(faults(plan), "");
  ASSERT_EQ(plan.subfields.size(), 2U);
  EXPECT_EQ(lengths_in(plan, 0).size(), 10U);  // flush with x = 60
  EXPECT_TRUE(plan.subfields[0].reference.empty());
  EXPECT_FALSE(plan.subfields[1].reference.empty());
}

// 3000 m² at 0.10, and 9 turns. No track ends at the land left out, so there is no stop.
TEST(GivenLand, LandLeftOutIsGivenUp) {
  GivenLand given;
  given.left_out = eastern_half();
  const Plan plan = planned(given);
  EXPECT_EQ(faults(plan), "");
  EXPECT_EQ(plan.left_out, 1U);
  EXPECT_NEAR(area(plan.given_up), 3000, 1e-6);
  EXPECT_NEAR(plan.tally.uncovered_m2, 3000, 1e-6);
  EXPECT_EQ(plan.tally.pieces, 10);
  EXPECT_NEAR(plan.cost, 9 + 300, 1e-6);
  EXPECT_TRUE(warns(plan, "3000.0 m² are left out on purpose"));
}

// In the middle it is in the way of tracks, as an obstacle is, and has no number to be named by.
TEST(GivenLand, TracksGoRoundLandLeftOut) {
  GivenLand given;
  given.left_out = {rectangle(48, 28, 54, 33)};
  const Plan plan = planned(given);
  EXPECT_EQ(faults(plan), "");
  EXPECT_FALSE(plan.encounters.empty());
}

// The strip of 2 m that the polygon leaves, and the one of 1 m round three of its sides, are no subfields.
TEST(GivenLand, SliversAreJoined) {
  GivenLand given;
  given.subfields = {{{rectangle(2, -10, 110, 70)}, "all but two metres", north_and_south()}};
  const Plan strip = planned(given);
  EXPECT_EQ(faults(strip), "");
  ASSERT_EQ(strip.subfields.size(), 1U);
  EXPECT_NEAR(area(strip.subfields[0].shape), 6000, 1e-6);
  EXPECT_TRUE(warns(strip, "(1.00, 30.0"));

  given.subfields = {{{rectangle(50, 1, 99, 59)}, "not quite", north_and_south()}};
  const Plan tails = planned(given);
  EXPECT_EQ(faults(tails), "");
  ASSERT_EQ(tails.subfields.size(), 2U);
  EXPECT_NEAR(area(tails.subfields[0].shape), 3000, 10);
}

TEST(GivenLand, NarrowTailsLeaveCornersAlone) {
  // A square of 20 m with a handle of 1 m by 30 m.
  const Polygon pan{{{0, 0}, {20, 0}, {20, 9}, {50, 9}, {50, 10}, {20, 10}, {20, 20}, {0, 20}}, {}};
  const Region tails = narrow_tails(pan, 2, 5);
  ASSERT_EQ(tails.size(), 1U);
  EXPECT_NEAR(area(tails), 30, 0.1);
  EXPECT_TRUE(narrow_tails(rectangle(0, 0, 20, 20), 2, 5).empty());
}

// The plan for the half alone: the same tracks, areas and cost.
TEST(GivenLand, OnlyAHalfIsThePlanOfThatHalf) {
  GivenLand given;
  given.elsewhere = difference({{oblong().outer, {}}}, eastern_half());
  const Plan part = planned(given);
  Field half = oblong();
  half.outer = rectangle(50, 0, 100, 60).outer;
  const Plan alone = plan_field(half, kFiveMetres, {}, {});
  EXPECT_EQ(faults(part), "");
  EXPECT_FALSE(is_repair(part));
  EXPECT_NEAR(area(part.body), 3000, 1e-6);
  EXPECT_NEAR(area(part.worked), 3000, 1e-6);
  EXPECT_EQ(part.pieces.size(), alone.pieces.size());
  EXPECT_NEAR(part.cost, alone.cost, 1e-6);
  EXPECT_NEAR(part.tally.uncovered_m2, 0, 1e-6);
}

// The half of 50 m at 3 m: 17 tracks of 60 m, 60 m² of them over land done or the edge, at 16 + 1.20; 20
// tracks of 50 m would cost 19.
TEST(GivenLand, WhatIsLeftIsPlannedWithAnotherWidth) {
  GivenLand first;
  first.elsewhere = difference({{oblong().outer, {}}}, western_half());
  const Plan before = planned(first, {"", 6, 5, -1});
  EXPECT_EQ(faults(before), "");
  EXPECT_EQ(before.tally.pieces, 10);  // 60/6 of 50 m

  GivenLand second;
  second.done = unite(swaths(before));
  const Plan rest = planned(second, {"", 3, 5, -1});
  EXPECT_EQ(faults(rest), "");
  EXPECT_NEAR(area(rest.body), 3000, 1e-6);
  EXPECT_EQ(rest.tally.pieces, 17);
  EXPECT_NEAR(rest.cost, 16 + 0.02 * 60, 1e-6);
}

TEST(GivenLand, WhatIsTooNarrowToPlanIsLeft) {
  GivenLand given;
  given.done = {rectangle(-1, -1, 50, 61), rectangle(52, 10, 60, 61)};
  const Plan plan = planned(given);
  EXPECT_EQ(faults(plan), "");
  // Of the land beside the second rectangle the strip of 2 m by 50 m is wide enough for the end rule, and
  // stays.
  EXPECT_NEAR(area(plan.body), 3000 - 8 * 50, 1e-6);
  given.done[1] = rectangle(50.5, 10, 60, 61);
  const Plan narrow = planned(given);
  EXPECT_EQ(faults(narrow), "");
  EXPECT_NEAR(area(narrow.body), 3000 - 10 * 50, 0.1);
  EXPECT_TRUE(warns(narrow, "too narrow"));
}

std::string refusal(const GivenLand& given, const PlanSettings& settings = {}) {
  try {
    planned(given, kFiveMetres, settings);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(GivenLand, NothingLeftToPlanIsRefused) {
  GivenLand given;
  given.done = {rectangle(-1, -1, 98, 61)};
  EXPECT_NE(refusal(given).find("nothing of field 'oblong' is left to plan"), std::string::npos);
  given = {};
  given.left_out = {rectangle(-1, -1, 101, 61)};
  EXPECT_NE(refusal(given).find("leaves out all"), std::string::npos);
  given = {};
  given.elsewhere = {rectangle(-1, -1, 101, 61)};
  EXPECT_NE(refusal(given).find("--only"), std::string::npos);
  given.elsewhere = western_half();
  PlanSettings settings;
  settings.headlands = 1;
  EXPECT_NE(refusal(given, settings).find("leave out --headlands"), std::string::npos);
}

TEST(GivenLand, ComesBackFromAFile) {
  GivenLand given;
  given.subfields = {{{rectangle(60, -5, 110, 65)}, "drawn feature 7", north_and_south()}};
  given.left_out = {rectangle(40, -5, 60, 65)};
  given.elsewhere = {rectangle(-5, -5, 10, 65)};
  const Plan plan = planned(given);
  EXPECT_EQ(faults(plan), "");
  EXPECT_EQ(io::metadata_of(plan).at("format_version"), "8");
  const testing_support::TemporaryFolder folder;
  io::write_plan(plan, folder.path() / "plan.gpkg");
  EXPECT_TRUE(io::is_plan_file(folder.path() / "plan.gpkg"));
  const Plan back = io::read_plan(folder.path() / "plan.gpkg");
  EXPECT_EQ(back.kind, PlanKind::kField);
  EXPECT_EQ(back.worked, plan.worked);
  EXPECT_EQ(back.left_out, 1U);
  EXPECT_EQ(back.given_up, plan.given_up);
  ASSERT_EQ(back.subfields.size(), 2U);
  EXPECT_EQ(back.subfields[0].given_by, "drawn feature 7");
  EXPECT_EQ(back.subfields[1].given_by, "");
  EXPECT_EQ(faults(back), "");
}

// The verifier has to see land that is lost between body and land done, and land left out that is worked.
TEST(GivenLand, FaultsArePlantedAndFound) {
  GivenLand given;
  given.elsewhere = western_half();
  given.left_out = {rectangle(90, -5, 110, 65)};
  const Plan good = planned(given);
  EXPECT_EQ(faults(good), "");
  EXPECT_TRUE(check::compare_warnings(good).empty());

  Plan lost = good;
  lost.worked = difference(lost.worked, {rectangle(0, 0, 10, 10)});
  EXPECT_NE(faults(lost).find("body and worked ground together differ"), std::string::npos);
  Plan twice = good;
  twice.worked = unite(twice.worked, {rectangle(50, 0, 60, 10)});
  EXPECT_NE(faults(twice).find("body and worked ground overlap"), std::string::npos);
  Plan entered = good;
  entered.given_up = {rectangle(85, 0, 100, 60)};
  EXPECT_NE(faults(entered).find("of land given up"), std::string::npos);
  Plan unsaid = good;
  unsaid.left_out = 0;
  EXPECT_FALSE(check::compare_warnings(unsaid).empty());
}

LooseSubfield drawn(const Polygon& polygon, const std::string& origin) {
  LooseSubfield out;
  out.feature.origin = origin;
  out.feature.polygons = {{{{polygon.outer, true}}}};
  out.feature.bounds = bounds(polygon);
  return out;
}

TEST(GivenLand, OfOverlappingPolygonsTheFirstKeepsTheLand) {
  std::vector<LooseSubfield> all{drawn(rectangle(50, -10, 110, 70), "a feature 1"),
                                 drawn(rectangle(-10, -10, 60, 70), "a feature 2"),
                                 drawn(rectangle(500, 0, 600, 70), "a feature 3")};
  std::vector<char> used(3, 0);
  GivenLand given;
  place_subfields(oblong(), all, used, given);
  EXPECT_EQ(used, (std::vector<char>{1, 1, 0}));
  ASSERT_EQ(given.subfields.size(), 2U);
  EXPECT_NEAR(area(given.subfields[0].shape), 3000, 1e-6);
  EXPECT_NEAR(area(given.subfields[1].shape), 3000, 1e-6);
  ASSERT_EQ(given.remarks.size(), 1U);
  EXPECT_NE(given.remarks[0].find("a feature 1 and a feature 2 overlap by 600.0 m² at (55.00, "),
            std::string::npos);
}

Polygon random_box(SeededRandom& random, const Box& over) {
  std::uniform_real_distribution<double> x(over.min_x, over.max_x), y(over.min_y, over.max_y),
      share(0.1, 0.6);
  const Point p{x(random), y(random)};
  return rectangle(p.x, p.y, p.x + share(random) * over.width(), p.y + share(random) * over.height());
}

Point random_point(SeededRandom& random, const Box& over) {
  std::uniform_real_distribution<double> x(over.min_x, over.max_x), y(over.min_y, over.max_y);
  return {x(random), y(random)};
}

GivenLand random_land(SeededRandom& random, const Field& field) {
  const Box over = bounds(field.outer).grown(10);
  std::uniform_int_distribution<int> some(0, 2), degrees(0, 179);
  std::vector<LooseSubfield> all;
  for (int i = some(random); i > 0; --i) {
    all.push_back(drawn(random_box(random, over), "box " + std::to_string(i)));
    if (some(random) > 0)
      all.back().direction = Direction::clockwise_from_north(Angle::degrees(degrees(random)));
    all.back().left_out = some(random) == 0;
  }
  GivenLand out;
  std::vector<char> used(all.size(), 0);
  place_subfields(field, all, used, out);
  for (int i = some(random); i > 0; --i)
    out.cuts.push_back({{random_point(random, over), random_point(random, over)}, "line"});
  if (some(random) == 0) out.done = {random_box(random, over)};
  if (some(random) == 0) out.elsewhere = {random_box(random, over)};
  return out;
}

// Σ w·L = body − u + o, the subfields tile the land to be worked, and the verifier finds no fault.
TEST(GivenLandProperties, RandomCutsOfRandomFieldsHold) {
  testing::for_each_seed(35, [](SeededRandom& random, int number) {
    const Field field = testing::random_field(random, number % 3 == 0 ? 4 : 0);
    std::uniform_real_distribution<double> width(3, 15);
    const Machine machine{"", width(random), 6, -1};
    PlanSettings settings;
    settings.strategy = number % 2 == 0 ? Strategy::kSweep : Strategy::kBest;
    settings.boundary = number % 5 == 0 ? EdgeKind::kHard : EdgeKind::kSoft;
    settings.given = random_land(random, field);
    Plan plan;
    try {
      plan = plan_field(field, machine, {}, settings);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
      return;
    }
    EXPECT_EQ(faults(plan), "");
    EXPECT_NEAR(identity_error_m2(plan), 0, 1e-6 * area_m2(field));
    double tiles_m2 = 0;
    for (const Subfield& subfield : plan.subfields) tiles_m2 += area(subfield.shape);
    EXPECT_NEAR(tiles_m2, area(plan.body) - area(plan.given_up), 1e-6 * area_m2(field));
    EXPECT_NEAR(area(plan.body) + area(plan.worked), area_m2(field), 1e-6 * area_m2(field));
  });
}

// The threads do not show.
TEST(GivenLandProperties, AnyNumberOfThreadsGivesTheSamePlan) {
  SeededRandom random(7);
  const Field field = testing::random_field(random, 2);
  PlanSettings settings;
  const Box box = bounds(field.outer);
  settings.given.cuts = {{{{box.min_x, box.centre().y}, {box.max_x, box.centre().y}}, "line"}};
  const Plan one = plan_field(field, {"", 6, 6, -1}, {}, settings, 1);
  const Plan many = plan_field(field, {"", 6, 6, -1}, {}, settings, 4);
  ASSERT_EQ(one.pieces.size(), many.pieces.size());
  EXPECT_EQ(one.cost, many.cost);
  for (std::size_t i = 0; i < one.pieces.size(); ++i) EXPECT_EQ(one.pieces[i].start, many.pieces[i].start);
}

}  // namespace
}  // namespace tramline
