// What is decided about poles. Areas come from polygon booleans, pieces and stops from counting.

#include "tramline/avoidance/choose_detours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "avoidance/pole_field.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/tracks/end_rule.h"
#include "tramline/tracks/straight_tracks.h"

namespace tramline::choose_detours_test {

using namespace testing_poles;

TEST(ChooseDetours, ASymmetricPoleCostsTheSameOnBothSides) {
  for (const double width : {1.5, 3.0, 6.0, 12.0})
    for (const double radius : {0.0, 6.0})
      for (const int corners : {4, 8, 16}) {
        const Pole pole{width, radius, 0.6, 0, corners};
        SCOPED_TRACE(description(pole));
        const PoleField field(field_ring(width), {ring_of(pole)}, machine(width, radius), {});
        const std::vector<PlacedEncounter> found = encounters_in(field.task(), field.plan());
        ASSERT_EQ(found.size(), 1u);
        ASSERT_TRUE(found[0].left.possible && found[0].right.possible);
        EXPECT_NEAR(found[0].left.cost, found[0].right.cost, 1e-6);
        EXPECT_EQ(found[0].obstacles, std::vector<std::size_t>{0});
        EXPECT_EQ(found[0].track, 3);
        EXPECT_NEAR(distance(found[0].at, {3.5 * width, 80}), 0, 1e-6);
      }
}

TEST(ChooseDetours, MirroredPolesCostTheSame) {
  for (const double width : {1.5, 3.0, 6.0})
    for (const double off : {0.1, 0.3, 0.45}) {
      const Pole right{width, 6, 0.6, off * width, 16}, left{width, 6, 0.6, -off * width, 16};
      SCOPED_TRACE(description(right));
      const PoleField a(field_ring(width), {ring_of(right)}, machine(width, 6), {});
      const PoleField b(field_ring(width), {ring_of(left)}, machine(width, 6), {});
      EXPECT_NEAR(a.plan().cost, b.plan().cost, 1e-6);
      std::vector<PlacedEncounter> there = encounters_in(a.task(), a.plan()),
                                   back = encounters_in(b.task(), b.plan());
      ASSERT_EQ(there.size(), back.size());
      std::reverse(back.begin(), back.end());
      for (std::size_t i = 0; i < there.size(); ++i) {
        EXPECT_EQ(there[i].track, 6 - back[i].track);
        EXPECT_EQ(there[i].left.possible, back[i].right.possible);
        EXPECT_EQ(there[i].right.possible, back[i].left.possible);
        EXPECT_NEAR(there[i].left.cost, back[i].right.cost, 1e-6);
        EXPECT_NEAR(there[i].right.cost, back[i].left.cost, 1e-6);
      }
    }
}

// 16 m of the last strip are a subfield of their own, of which a cut leaves two ends too short to drive. A
// detour works 45 m² more for a turn; the subfield it adds to the plan has its price, too.
TEST(ChooseDetours, TheFirstPieceOfASubfieldPaysForIt) {
  const auto planned = [](double subfield_price) {
    Machine with = machine(3, 1);
    with.min_length_m = 8;
    const Objective prices{0.02, 0.1, 1, 5, subfield_price};
    const PoleField whole(box(0, 0, 24, 16), {box(22.2, 7.7, 22.8, 8.3)}, with, prices);
    const AvoidanceTask one = whole.task();
    const TurnedGround turned{one.ground.hard, one.ground.passable, {}, one.ground.beyond};
    const std::vector<Polygon> parts{{box(0, 0, 21, 16), {}}, {box(21, 0, 24, 16), {}}};
    std::vector<Subfield> subfields;
    std::vector<TrackFamily> families;
    for (const Polygon& part : parts) {
      subfields.push_back({part, one.subfields.front().direction});
      families.push_back(straight_tracks(one.families.front().grid, part, turned,
                                         end_criterion(EndRule::kCheapest, prices, 3)));
    }
    const AvoidanceTask task{one.field,    one.ground, one.machine, one.objective,
                             one.settings, subfields,  families,    one.body_m2};
    const Avoided found = choose_detours(task);
    const std::vector<PlacedEncounter> met = encounters_in(task, found);
    EXPECT_EQ(met.size(), 1u);
    return std::pair(found.tally.subfields, met.front());
  };
  const auto [free_subfields, free] = planned(0);
  EXPECT_EQ(free_subfields, 2);
  EXPECT_NE(free.chosen, Passing::kCut);
  const auto [priced_subfields, priced] = planned(5);
  EXPECT_EQ(priced_subfields, 1);
  EXPECT_EQ(priced.chosen, Passing::kCut);
  ASSERT_TRUE(priced.left.possible && free.left.possible);
  EXPECT_GT(priced.left.cost, 0);
  EXPECT_NEAR(priced.left.cost - free.left.cost, 5, 1e-9);
}

// If fewer stops came with a lower price, changing the plans round would make one of them cheaper.
TEST(ChooseDetours, CostlierStopsNeverMakeMoreOfThem) {
  int changed = 0;
  for (const Pole& pole : poles()) {
    SCOPED_TRACE(description(pole));
    int before = 1000, first = -1;
    for (const double stop : {0.0, 5.0, 1000.0}) {
      Objective prices;
      prices.stop = stop;
      const PoleField field(field_ring(pole.width_m), {ring_of(pole)}, machine(pole.width_m, pole.radius_m),
                            prices);
      const int stops = field.plan().tally.stops;
      EXPECT_LE(stops, before) << "at " << stop;
      if (first < 0) first = stops;
      before = stops;
    }
    changed += before < first ? 1 : 0;
  }
  EXPECT_GT(changed, 50) << "the price has to matter";
}

TEST(ChooseDetours, NothingIsCutWhereTurnsAreWorthMoreThanTheField) {
  for (const Pole& pole : poles()) {
    SCOPED_TRACE(description(pole));
    const PoleField field(field_ring(pole.width_m), {ring_of(pole)}, machine(pole.width_m, pole.radius_m),
                          {0.04, 0.10, 99999, 5});
    const Avoided found = field.plan();
    int never_passed = 0;
    for (const Track& strip : field.family().tracks) {
      const StripWays ways = rolling_circle_paths(field, strip);
      never_passed += ways.ways.size() == 1 && ways.ways[0].size() == 2 ? 1 : 0;
    }
    EXPECT_EQ(found.tally.pieces, 7 + never_passed);
    EXPECT_EQ(found.tally.stops, 2 * never_passed);
    expect_own_tally(field, found);
  }
}

/// The paper's way round may be tighter than the machine can follow; it may then cost less than any that it
/// can.
bool can_be_driven(const Avoided& found, double radius_m) {
  for (const auto& family : found.tracks)
    for (const LaidPiece& piece : family.pieces)
      for (const TrackDetour& detour : piece.detours)
        if (smallest_radius(detour.path) < radius_m - 1e-9) return false;
  return true;
}

TEST(ChooseDetours, CheapestIsNeverCostlierThanCutNorThanPaperWhereThatCanBeDriven) {
  int paper_drives_round = 0, drivable = 0;
  for (const Pole& pole : poles())
    for (const Objective& prices : {Objective{}, Objective{0, 0, 0, 0}, Objective{1, 0, 0, 0},
                                    Objective{0, 1, 0, 0}, Objective{99999, 1, 1, 1}}) {
      SCOPED_TRACE(description(pole));
      const PoleField field(field_ring(pole.width_m), {ring_of(pole)}, machine(pole.width_m, pole.radius_m),
                            prices);
      const Avoided paper = field.plan(Avoidance::kPaper), cut = field.plan(Avoidance::kCut);
      const double found = field.plan().cost;
      EXPECT_LE(found, cut.cost + 1e-9 * (1 + cut.cost));
      if (can_be_driven(paper, std::max(pole.radius_m, pole.width_m / 2))) {
        EXPECT_LE(found, paper.cost + 1e-9 * (1 + paper.cost));
        drivable += detours_in(paper) > 0 ? 1 : 0;
      }
      EXPECT_EQ(detours_in(cut), 0);
      expect_own_tally(field, paper);
      expect_own_tally(field, cut);
      paper_drives_round += detours_in(paper) > 0 ? 1 : 0;
    }
  EXPECT_GT(paper_drives_round, 100);
  EXPECT_GT(drivable, 20);
}

const Objective kExpensiveStops{0.04, 0.10, 0.45, 1000};

// Half a metre of pole on a track of 3 m asks for h = 1.75 and √(4·12·1.75 − 1.75²) = 9.0 m behind it. There
// are 5 m to the northern edge.
TEST(ChooseDetours, ATrackThatEndsBeforeTheDetourWouldIsCut) {
  const auto pole_at = [](double y) { return box(10.25, y - 0.25, 10.75, y + 0.25); };
  const PoleField near(box(0, 0, 21, 100), {pole_at(95)}, machine(3, 12), kExpensiveStops);
  EXPECT_EQ(detours_in(near.plan()), 0);
  EXPECT_EQ(near.plan().tally.stops, 2);
  const std::vector<PlacedEncounter> found = encounters_in(near.task(), near.plan());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].chosen, Passing::kCut);
  EXPECT_FALSE(found[0].left.possible || found[0].right.possible);
  EXPECT_EQ(found[0].left.why_not, "the track ends before a detour could");
  const PoleField far(box(0, 0, 21, 100), {pole_at(90)}, machine(3, 12), kExpensiveStops);
  EXPECT_EQ(detours_in(far.plan()), 1);
}

// Each alone would take 9 m to both sides of its pole.
TEST(ChooseDetours, DetoursThatWouldRunIntoEachOtherBecomeOne) {
  const auto pole_at = [](double y) { return box(10.25, y - 0.25, 10.75, y + 0.25); };
  for (const double apart : {4.0, 8.0, 12.0, 17.0}) {
    SCOPED_TRACE(apart);
    const PoleField field(box(0, 0, 21, 100), {pole_at(40), pole_at(40 + apart)}, machine(3, 12),
                          kExpensiveStops);
    const Avoided found = field.plan();
    EXPECT_EQ(found.tally.stops, 0);
    ASSERT_EQ(found.tracks.front().pieces.size(), 7u);
    ASSERT_EQ(detours_in(found), 1);
    EXPECT_EQ(found.tracks.front().pieces[3].detours.front().obstacles, (std::vector<std::size_t>{0, 1}));
    expect_own_tally(field, found);
    expect_off_poles(field, found);
  }
  const PoleField field(box(0, 0, 21, 100), {pole_at(30), pole_at(60)}, machine(3, 12), kExpensiveStops);
  EXPECT_EQ(detours_in(field.plan()), 2);
  expect_own_tally(field, field.plan());
}

// Poles on either side of the centre line, too far apart for one straight way between: whatever is done,
// detours on one track never overlap.
TEST(ChooseDetours, PolesOnAlternateSidesArePassedWithoutOverlap) {
  for (const double apart : {4.0, 7.0, 11.0, 16.0, 25.0})
    for (const double off : {0.6, 1.0, 1.3})
      for (const double radius : {0.0, 3.0, 6.0, 12.0}) {
        SCOPED_TRACE(::testing::Message() << apart << " apart, off " << off << ", r " << radius);
        const auto pole = [](double x, double y) { return box(x - 0.2, y - 0.2, x + 0.2, y + 0.2); };
        const PoleField field(box(0, 0, 21, 120), {pole(10.5 + off, 60), pole(10.5 - off, 60 + apart)},
                              machine(3, radius), kExpensiveStops);
        const Avoided found = field.plan();
        expect_own_tally(field, found);
        expect_off_poles(field, found);
        EXPECT_LE(found.cost, field.plan(Avoidance::kCut).cost);
      }
}

/// A rectangle with a thin spike of foreign land from the west. Its tip lies 4 m north of a pole on the
/// track at x = 10.5, so 3.75 m from the pole's corners. There the path west of the pole has moved by
/// 1.75 − (12 − √(12² − 3.75²)) = 1.15 m, its centre line to x = 9.35; its swath's edge, on an arc of 13.5 m,
/// by 3.25 − (13.5 − √(13.5² − 3.75²)) = 2.72 m, to x = 7.78. Half a metre nearer the edge is at x = 7.65.
std::vector<PlacedEncounter> encounters_by_a_spike(double tip_x, EdgeKind boundary,
                                                   const std::vector<Ring>& passable = {}) {
  PlanSettings settings;
  settings.end_rule = EndRule::kCentre;
  settings.boundary = boundary;
  Ring outer{{0, 0}, {21, 0}, {21, 100}, {0, 100}};
  if (tip_x > 0) outer.insert(outer.end(), {{0, 54.05}, {tip_x, 54}, {0, 53.95}});
  const PoleField field(outer, {box(10.25, 49.75, 10.75, 50.25)}, machine(3, 12), kExpensiveStops, settings,
                        passable);
  std::vector<PlacedEncounter> out;
  for (PlacedEncounter& encounter : encounters_in(field.task(), field.plan()))
    if (encounter.track == 3) out.push_back(std::move(encounter));
  return out;
}

void expect_only_right(const std::vector<PlacedEncounter>& found, const char* why_not_left) {
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].left.possible);
  EXPECT_EQ(found[0].left.why_not, why_not_left);
  EXPECT_TRUE(found[0].right.possible);
  EXPECT_EQ(found[0].chosen, Passing::kRight);
}

void expect_both(const std::vector<PlacedEncounter>& found) {
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].left.possible && found[0].right.possible);
}

TEST(ChooseDetours, NoCentreLineLeavesASoftEdge) {
  expect_only_right(encounters_by_a_spike(9.45, EdgeKind::kSoft), "it would leave the field");
  expect_both(encounters_by_a_spike(9.25, EdgeKind::kSoft));
}

TEST(ChooseDetours, NoSwathPassesAHardEdge) {
  expect_only_right(encounters_by_a_spike(7.9, EdgeKind::kHard), "its swath would pass the hard boundary");
  expect_both(encounters_by_a_spike(7.7, EdgeKind::kHard));
  expect_both(encounters_by_a_spike(7.9, EdgeKind::kSoft));
}

TEST(ChooseDetours, NoSwathEntersAPassableObstacle) {
  const auto beside = [](double max_x) { return std::vector<Ring>{box(6.5, 53.5, max_x, 54)}; };
  expect_only_right(encounters_by_a_spike(0, EdgeKind::kSoft, beside(7.75)),
                    "its swath would enter a passable obstacle");
  expect_both(encounters_by_a_spike(0, EdgeKind::kSoft, beside(7.55)));
}

// Twenty poles of 40 cm on one track, some near enough to share a detour.
TEST(ChooseDetours, ARowOfPolesIsPassedFromEndToEnd) {
  for (const double apart : {5.0, 11.0, 19.0, 30.0})
    for (const double slant : {0.0, 0.05}) {
      SCOPED_TRACE(::testing::Message() << apart << " apart, slant " << slant);
      std::vector<Ring> row;
      for (int i = 0; i < 20; ++i) {
        const Point at{10.5 + slant * i, 40 + apart * i};
        row.push_back(box(at.x - 0.2, at.y - 0.2, at.x + 0.2, at.y + 0.2));
      }
      const Ring outer = box(0, 0, 21, 80 + 20 * apart);
      const PoleField expensive(outer, row, machine(3, 6), kExpensiveStops);
      const Avoided passed = expensive.plan();
      expect_own_tally(expensive, passed);
      expect_off_poles(expensive, passed);
      EXPECT_EQ(passed.tally.stops, 0);
      EXPECT_EQ(encounters_in(expensive.task(), passed).size(), 20u);
      const PoleField usual(outer, row, machine(3, 6), {});
      const Avoided found = usual.plan();
      expect_own_tally(usual, found);
      expect_off_poles(usual, found);
      EXPECT_LE(found.cost, usual.plan(Avoidance::kCut).cost + 1e-9);
    }
}

// What counts as narrow is Versleijen's own matter: the search takes its plan only where that is cheaper.
TEST(ChooseDetours, NoThresholdMakesTheCheapestCostlier) {
  std::vector<Ring> poles;
  for (int i = 0; i < 12; ++i) {
    const Point at{3.0 + 2.3 * i, 20.0 + 13 * (i % 5)};
    poles.push_back(box(at.x, at.y, at.x + 0.3 + 0.4 * i, at.y + 0.4 + 0.3 * (i % 4)));
  }
  const auto planned = [&](double threshold_m, Avoidance avoid) {
    PlanSettings settings;
    settings.avoid_threshold_m = threshold_m;
    return PoleField(box(0, 0, 36, 110), poles, machine(3, 6), {}, settings).plan(avoid).cost;
  };
  const double without_paper = planned(0, Avoidance::kCheapest);
  EXPECT_DOUBLE_EQ(planned(0, Avoidance::kPaper), planned(0, Avoidance::kCut));
  for (const double threshold_m : {0.5, 1.0, 2.0, 3.0, 5.0, 20.0}) {
    const double found = planned(threshold_m, Avoidance::kCheapest);
    EXPECT_LE(found, without_paper + 1e-9) << threshold_m;
    EXPECT_LE(found, planned(threshold_m, Avoidance::kCut) + 1e-9) << threshold_m;
  }
}

/// Strips of 3 m, 50 m long; those in `long_strips` are 100 m long, and a pole of 16 corners and 0.25 m
/// radius stands in the middle of each: cut in two, they are no longer than the others.
Ring with_long_strips(int strips, const std::vector<int>& long_strips) {
  Ring out;
  for (int i = 0; i < strips; ++i) {
    const bool is_long = std::count(long_strips.begin(), long_strips.end(), i) > 0;
    out.push_back({3.0 * i, is_long ? 0.0 : 25.0});
    out.push_back({3.0 * (i + 1), is_long ? 0.0 : 25.0});
  }
  for (std::size_t i = out.size(); i-- > 0;) out.push_back({out[i].x, 100 - out[i].y});
  return out;
}

Ring pole_in(int strip) { return regular(16, 0.25, {3 * strip + 1.5, 50}); }

/// A track of 100 m with the detour round its pole: h = 0.25 + 1.5, L = √(4·6·h − h²), and four arcs of
/// asin(L / 12).
double length_past_pole() {
  const double h = 1.75, half = std::sqrt(24 * h - h * h);
  return 100 - 2 * half + 24 * std::asin(half / 12);
}

/// Such a field, planned without Versleijen's ways.
struct LongStrips {
  LongStrips(int strips, const std::vector<int>& long_strips, double least_m, double turn) {
    Machine with_least = machine(3, 6);
    with_least.min_length_m = least_m;
    PlanSettings own_ways;
    own_ways.avoid_threshold_m = 0;
    std::vector<Ring> poles;
    for (const int strip : long_strips) poles.push_back(pole_in(strip));
    field.emplace(with_long_strips(strips, long_strips), poles, with_least, Objective{0.04, 0.10, turn, 5},
                  own_ways);
    found = field->plan();
    encounters = encounters_in(field->task(), found);
  }
  std::optional<PoleField> field;
  Avoided found;
  std::vector<PlacedEncounter> encounters;
};

/// What driving a long strip past its pole saves, turns left aside: it works only ground that nothing else
/// does.
double saved_by_driving() { return 0.10 * 3 * length_past_pole(); }

void expect_costs(const Encounter& encounter, double cost) {
  EXPECT_TRUE(encounter.left.possible && encounter.right.possible);
  EXPECT_NEAR(encounter.left.cost, cost, 1e-6);
  EXPECT_NEAR(encounter.right.cost, cost, 1e-6);
}

// The first piece of a plan comes without a turn. All others being too short, whether the middle track is
// driven must not depend on what a turn costs.
TEST(ChooseDetours, TheOnlyPieceOfAPlanTakesNoTurn) {
  for (const double turn : {0.0, 0.45, 99999.0}) {
    SCOPED_TRACE(turn);
    const LongStrips planned(3, {1}, 60, turn);
    ASSERT_EQ(planned.found.tally.pieces, 1);
    EXPECT_EQ(planned.found.tally.turns, 0);
    const double body_m2 = 3 * (50 + 100 + 50) - signed_area(pole_in(1));
    EXPECT_NEAR(planned.found.cost, 0.10 * body_m2 - saved_by_driving(), 1e-6);
    ASSERT_EQ(planned.encounters.size(), 1u);
    expect_costs(planned.encounters[0], -saved_by_driving());
  }
}

// With the pieces of 50 m driven, the same detour takes a turn more than a cut, which leaves two pieces
// of 49.75 m undriven.
TEST(ChooseDetours, APieceMoreThanOthersTakesATurn) {
  const LongStrips cheap(3, {1}, 49.9, 0), expensive(3, {1}, 49.9, 1000);
  ASSERT_EQ(cheap.encounters.size(), 1u);
  ASSERT_EQ(expensive.encounters.size(), 1u);
  EXPECT_NE(cheap.encounters[0].chosen, Passing::kCut);
  EXPECT_EQ(expensive.encounters[0].chosen, Passing::kCut);
  EXPECT_NEAR(expensive.encounters[0].left.cost - cheap.encounters[0].left.cost, 1000, 1e-6);
  EXPECT_NEAR(expensive.encounters[0].right.cost - cheap.encounters[0].right.cost, 1000, 1e-6);
}

// Only one of two such tracks is without a turn; which of them is, changes while they are decided.
TEST(ChooseDetours, TheSecondPieceOfAPlanTakesATurn) {
  for (const double turn : {0.0, 1000.0}) {
    SCOPED_TRACE(turn);
    const LongStrips planned(7, {1, 5}, 60, turn);
    EXPECT_EQ(planned.found.tally.pieces, turn == 0 ? 2 : 1);
    ASSERT_EQ(planned.encounters.size(), 2u);
    for (const Encounter& encounter : planned.encounters)
      expect_costs(encounter, (encounter.chosen == Passing::kCut ? turn : 0) - saved_by_driving());
  }
}

// The drivable form of the paper's way keeps the whole turning radius away from the pole's centre, on the
// left. A longer detour is the better one here: nothing else works the ground beside a long strip.
TEST(ChooseDetours, ThePapersWayIsComparedWithAllOthers) {
  Machine with_least = machine(3, 6);
  with_least.min_length_m = 60;
  const PoleField field(with_long_strips(7, {5}), {pole_in(5)}, with_least, {});
  const Avoided found = field.plan();
  const std::vector<PlacedEncounter> encounters = encounters_in(field.task(), found);
  ASSERT_EQ(encounters.size(), 1u);
  EXPECT_EQ(encounters[0].chosen, Passing::kLeft);
  EXPECT_LT(encounters[0].left.cost, -saved_by_driving() - 0.01);
  EXPECT_TRUE(encounters[0].right.possible) << encounters[0].right.why_not;
  EXPECT_NEAR(encounters[0].right.cost, -saved_by_driving(), 1e-6);
}

// Poles 2.5 m apart in a line across the tracks' direction and one far ahead are one hazard: land given up
// joins them. A detour names those it passes.
TEST(ChooseDetours, OnlyTheObstaclesOfAClusterBesideADetourAreNamed) {
  std::vector<Ring> chain;
  // From a pole on the track at y = 50 away to the east, and then far north.
  for (int i = 0; i <= 3; ++i) chain.push_back(box(10.4 + 2.5 * i, 49.8, 10.8 + 2.5 * i, 50.2));
  for (int i = 1; i <= 12; ++i) chain.push_back(box(17.9, 49.8 + 2.5 * i, 18.3, 50.2 + 2.5 * i));
  const PoleField field(box(0, 0, 30, 120), chain, machine(3, 6), kExpensiveStops);
  ASSERT_EQ(field.ground().hard.size(), 1u);
  const Avoided found = field.plan();
  int looked_at = 0;
  for (const LaidPiece& piece : found.tracks.front().pieces)
    for (const TrackDetour& detour : piece.detours) {
      ++looked_at;
      for (std::size_t i = 0; i < chain.size(); ++i) {
        const bool named = std::count(detour.obstacles.begin(), detour.obstacles.end(), i) > 0;
        const Box box = bounds(chain[i]);
        EXPECT_EQ(named, box.max_y > detour.from && box.min_y < detour.to) << i;
      }
    }
  EXPECT_GT(looked_at, 0);
}

}  // namespace tramline::choose_detours_test
