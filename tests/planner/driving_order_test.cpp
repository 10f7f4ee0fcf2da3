// In which order and which way round pieces are driven: scenes by hand, every order of a few pieces, random
// scenes against a nearest-neighbour tour.

#include "tramline/planner/assembly/driven_tracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "planner/prepared.h"
#include "properties/seeds.h"
#include "support/box_ring.h"
#include "support/hops.h"
#include "tramline/planner/plan_field.h"
#include "tramline/route/order/best_tour.h"
#include "tramline/route/order/tours.h"

namespace tramline {
namespace {

using order::End;
using order::Tour;
using order::WorkedLine;
using testing::for_each_seed;
using testing_support::Hops;
using testing_support::hops_of;
using testing_support::nearest_neighbour_m;

constexpr double kWidth_m = 6;

Field field_of(Ring outer, const std::vector<Ring>& ponds = {}) {
  Field out;
  out.id = "drawn";
  out.outer = std::move(outer);
  for (const Ring& pond : ponds) out.obstacles.push_back({{pond, {}}, ObstacleKind::kObstacle, "pond"});
  return out;
}

using testing_support::box;

/// A piece from west to east on track k, whose middle is at y = (k + ½)·w.
WorkedLine piece(int track, double from_x, double to_x, std::size_t subfield = 0) {
  TrackPiece out;
  const double y = (track + 0.5) * kWidth_m;
  out.start = {from_x, y};
  out.end = {to_x, y};
  out.subfield = subfield;
  out.track = track;
  return {out};
}

void append_tracks(int first, int last, double from_x, double to_x, std::vector<WorkedLine>& out) {
  for (int track = first; track <= last; ++track) out.push_back(piece(track, from_x, to_x));
}

void sort_by_track(std::vector<WorkedLine>& lines) {
  std::stable_sort(lines.begin(), lines.end(), [](const WorkedLine& a, const WorkedLine& b) {
    return a.front().track < b.front().track;
  });
}

Plan driven(const Field& field, const std::vector<WorkedLine>& lines, double width_m = kWidth_m) {
  Plan out;
  out.field = field;
  out.machine.width_m = width_m;
  out.pieces = order::pieces_on(order::best_tour(lines, field, width_m), lines);
  return out;
}

/// How often the drive changes between pieces that are in the group and pieces that are not.
template <class InGroup>
int changes(const Plan& plan, InGroup in_group) {
  int out = 0;
  for (std::size_t i = 1; i < plan.pieces.size(); ++i)
    out += in_group(plan.pieces[i - 1]) != in_group(plan.pieces[i]) ? 1 : 0;
  return out;
}

double middle_x(const TrackPiece& piece) { return midpoint(piece.start, piece.end).x; }

// A field like an L: four tracks of 100 m and on top of them, in the west, ten of 30 m. Up and down from one
// end to the other, every hop to the next track: 13 hops of 6 m, for which the short tracks are left in the
// west where the long ones begin.
TEST(DrivingOrder, AnAngleIsDrivenFromEndToEnd) {
  std::vector<WorkedLine> lines;
  append_tracks(0, 3, 0, 100, lines);
  append_tracks(4, 13, 0, 30, lines);
  const Plan plan = driven(field_of({{0, 0}, {100, 0}, {100, 24}, {30, 24}, {30, 84}, {0, 84}}), lines);
  EXPECT_NEAR(hops_of(plan).length_m, 13 * 6, 1e-6);
  EXPECT_EQ(plan.pieces.front().track, 0);
  EXPECT_EQ(plan.pieces.back().track, 13);
}

// A field like a U: a base of three tracks of 100 m and two legs with ten tracks of 30 m each. Down one leg
// in 9 hops of 6 m, to the base on the outer side, over its three tracks to the other side (2 · 6 m), up the
// other leg. An odd number of base tracks leads across; to drive them from the far one back or the other way
// takes 6 + 18 m in all to get from leg to base and from base to leg: 54 + 24 + 12 + 54 = 144 m. Track after
// track, each all the way across, would take 40 m more for each track of the legs.
TEST(DrivingOrder, LegsAreFinishedOneAfterTheOther) {
  std::vector<WorkedLine> lines;
  append_tracks(0, 2, 0, 100, lines);
  append_tracks(3, 12, 0, 30, lines);
  append_tracks(3, 12, 70, 100, lines);
  sort_by_track(lines);
  const Field field =
      field_of({{0, 0}, {100, 0}, {100, 78}, {70, 78}, {70, 18}, {30, 18}, {30, 78}, {0, 78}});
  const Plan plan = driven(field, lines);
  const Hops hops = hops_of(plan);
  EXPECT_NEAR(hops.length_m, 144, 1e-6);
  EXPECT_EQ(hops.far_outside, 0);
  EXPECT_EQ(changes(plan, [](const TrackPiece& p) { return p.track < 3; }), 2) << "leg, base, leg";
}

// Legs 5 m apart: across the gap is nearer (5 m) than the next track of the same leg (6 m), so that the
// nearest end is always in the other leg. But nobody drives across; leg by leg is a tenth longer.
TEST(DrivingOrder, AcrossAGapThatIsNotOfTheFieldNobodyDrives) {
  std::vector<WorkedLine> lines;
  append_tracks(0, 0, 0, 45, lines);
  append_tracks(1, 30, 0, 20, lines);
  append_tracks(1, 30, 25, 45, lines);
  sort_by_track(lines);
  const double top = 31 * kWidth_m;
  const Plan plan =
      driven(field_of({{0, 0}, {45, 0}, {45, top}, {25, top}, {25, 6}, {20, 6}, {20, top}, {0, top}}), lines);
  EXPECT_LE(changes(plan, [](const TrackPiece& p) { return p.track > 0 && middle_x(p) < 22; }), 2);
  EXPECT_LE(changes(plan, [](const TrackPiece& p) { return p.track > 0 && middle_x(p) > 22; }), 2);
  EXPECT_LE(hops_of(plan).length_m, 1.2 * nearest_neighbour_m(plan.pieces));
}

// Four tracks below a pond, two pieces on either side of it, five tracks above. Below, then one side (two
// pieces, so that the drive comes back to the edge of the field); the lowest track above the pond leads to
// the other side, and from there it is 3 tracks back to the rest: 11 hops of 6 m and one of 18. To drive each
// track on behind the pond would take 20 m through it, twice.
TEST(DrivingOrder, OneSideOfAPondIsFinishedBeforeTheOther) {
  std::vector<WorkedLine> lines;
  append_tracks(0, 3, 0, 100, lines);
  append_tracks(4, 5, 0, 40, lines);
  append_tracks(4, 5, 60, 100, lines);
  append_tracks(6, 10, 0, 100, lines);
  sort_by_track(lines);
  const Plan plan = driven(field_of(box(0, 0, 100, 66), {box(41, 24, 59, 36)}), lines);
  const Hops hops = hops_of(plan);
  EXPECT_NEAR(hops.length_m, 11 * 6 + 18, 1e-6);
  EXPECT_EQ(hops.through_obstacles, 0);
  const auto beside = [](const TrackPiece& p) { return p.track == 4 || p.track == 5; };
  EXPECT_EQ(changes(plan, [&](const TrackPiece& p) { return beside(p) && middle_x(p) < 50; }), 2);
  EXPECT_EQ(changes(plan, [&](const TrackPiece& p) { return beside(p) && middle_x(p) > 50; }), 2);
}

// A pole on every other track of a field: a hop past a pole is a few metres, to come back for the other side
// hundreds. A drive without such hops would be far longer, and is not asked for.
TEST(DrivingOrder, APoleIsPassedWhereItIsMet) {
  std::vector<WorkedLine> lines;
  std::vector<Ring> poles;
  for (int track = 0; track < 20; ++track) {
    if (track % 4 != 1) {
      lines.push_back(piece(track, 0, 400));
      continue;
    }
    lines.push_back(piece(track, 0, 199));
    lines.push_back(piece(track, 201, 400));
    const double y = (track + 0.5) * kWidth_m;
    poles.push_back(box(199, y - 1, 201, y + 1));
  }
  const Plan plan = driven(field_of(box(0, 0, 400, 120), poles), lines);
  EXPECT_NEAR(hops_of(plan).length_m, 19 * 6 + 5 * 2, 1e-6);
}

// What a crossing joins is driven in one go, whichever way.
TEST(DrivingOrder, PiecesThatACrossingJoinsStayTogether) {
  std::vector<WorkedLine> lines;
  for (int track = 0; track < 8; ++track) {
    WorkedLine line = piece(track, 0, 45);
    line.push_back(piece(track, 50, 100).front());
    line.front().stop_at_start = true;
    line.back().after_crossing = true;
    lines.push_back(std::move(line));
  }
  const Plan plan = driven(field_of(box(0, 0, 100, 48)), lines);
  ASSERT_EQ(plan.pieces.size(), 16U);
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    const TrackPiece& at = plan.pieces[i];
    EXPECT_EQ(at.after_crossing, i % 2 == 1);
    EXPECT_EQ(at.track, static_cast<int>(i / 2));
    const bool from_west = at.end.x > at.start.x;
    EXPECT_EQ(from_west, (i / 2) % 2 == 0) << "up and down";
    EXPECT_EQ(at.stop_at_start, from_west && at.start.x == 0);
    EXPECT_EQ(at.stop_at_end, !from_west && at.end.x == 0);
  }
}

// Three subfields in a row, given in the order left, right, middle: after the left comes the middle, whose
// track begins where the first one ends.
TEST(DrivingOrder, TakesTheNearestSubfieldNext) {
  const testing::Prepared prepared{{field_of(box(0, 0, 63, 50)), {"", 3, 6, -1}, {}, {}}};
  Candidate candidate;
  const StripGrid grid{TrackFrame(Direction::clockwise_from_north(Angle::degrees(0))), 0, 3};
  for (const int strip : {0, 20, 10}) {
    candidate.subfields.emplace_back();
    candidate.families.push_back({grid, {}});
    candidate.avoided.tracks.push_back({grid, {}, {}});
    LaidPiece only;
    only.track = strip;
    only.to = 50;
    candidate.avoided.tracks.back().pieces.push_back(only);
  }
  const std::vector<TrackPiece> pieces = driven_tracks(prepared.task(), candidate).pieces;
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].subfield, 0U);
  EXPECT_EQ(pieces[1].subfield, 2U);
  EXPECT_EQ(pieces[2].subfield, 1U);
  EXPECT_NEAR(pieces[1].start.y, pieces[0].end.y, 1e-9) << "from where the machine is";
}

TEST(DrivingOrder, OfNothingThereIsNone) {
  EXPECT_TRUE(order::best_tour({}, field_of(box(0, 0, 10, 10)), kWidth_m).empty());
  EXPECT_EQ(order::best_tour({piece(0, 0, 10)}, field_of(box(0, 0, 10, 10)), kWidth_m), Tour{0});
}

double random_between(std::mt19937_64& random, double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(random);
}

/// Lines anywhere, each a track that has no neighbour.
std::vector<WorkedLine> scattered(std::mt19937_64& random, int count) {
  std::vector<WorkedLine> out;
  for (int i = 0; i < count; ++i) {
    TrackPiece line;
    line.start = {random_between(random, 0, 300), random_between(random, 0, 300)};
    const double angle = random_between(random, 0, 2 * std::numbers::pi);
    line.end = line.start + random_between(random, 5, 150) * Point{std::cos(angle), std::sin(angle)};
    line.track = 2 * i;
    out.push_back({line});
  }
  return out;
}

/// The shortest hops of all orders and headings, m: by sets of lines driven and the end reached last.
double least_hops_m(const std::vector<WorkedLine>& lines) {
  const std::size_t n = lines.size(), sets = std::size_t{1} << n;
  const auto at = [&](End end) {
    return end % 2 == 0 ? lines[end / 2].front().start : lines[end / 2].back().end;
  };
  std::vector<std::vector<double>> least(sets,
                                         std::vector<double>(2 * n, std::numeric_limits<double>::infinity()));
  for (End left = 0; left < 2 * n; ++left) least[std::size_t{1} << (left / 2)][left] = 0;
  for (std::size_t set = 1; set < sets; ++set)
    for (End left = 0; left < 2 * n; ++left)
      for (End entered = 0; entered < 2 * n; ++entered) {
        const std::size_t with = set | (std::size_t{1} << (entered / 2));
        if (with == set) continue;
        double& best = least[with][entered ^ 1U];
        best = std::min(best, least[set][left] + distance(at(left), at(entered)));
      }
  return *std::min_element(least.back().begin(), least.back().end());
}

TEST(DrivingOrderProperties, IsNearTheBestOfAllOrders) {
  for_each_seed(300, [](std::mt19937_64& random, int number) {
    const std::vector<WorkedLine> lines = scattered(random, 2 + number % 6);
    const Plan plan = driven(field_of(box(-500, -500, 1000, 1000)), lines, 1);
    EXPECT_LE(hops_of(plan).length_m, 1.2 * least_hops_m(lines) + 1e-9);
  });
}

bool is_permutation_of_lines(const Tour& tour, std::size_t lines) {
  std::set<std::size_t> seen;
  for (const End end : tour) seen.insert(order::line_of(end));
  return tour.size() == lines && seen.size() == lines && *seen.rbegin() + 1 == lines;
}

TEST(DrivingOrderProperties, HopsAreNoLongerThanNearestNeighbourNorTrackByTrack) {
  for_each_seed(40, [](std::mt19937_64& random, int number) {
    const std::vector<WorkedLine> lines = scattered(random, 20 + 10 * number);
    const Field field = field_of(box(-500, -500, 1000, 1000));
    ASSERT_TRUE(is_permutation_of_lines(order::best_tour(lines, field, 1), lines.size()));
    const Plan plan = driven(field, lines, 1);
    EXPECT_LE(hops_of(plan).length_m, 1.2 * nearest_neighbour_m(plan.pieces));
    const order::HopGround ground(field, 2);
    const order::HopCosts costs(lines, ground);
    EXPECT_LE(hops_of(plan).length_m, order::length_m(order::track_by_track(lines, costs), costs) + 1e-6);
  });
}

/// Tracks across a field, cut at ponds: 1.5 to 2 m is kept from each. No two hops are of one length, or else
/// there would be many nearest-neighbour tours.
void cut_at_ponds(std::mt19937_64& random, int tracks, double length, const std::vector<Ring>& ponds,
                  std::vector<WorkedLine>& out) {
  const auto ragged = [&random] { return random_between(random, 0, 0.5); };
  for (int track = 0; track < tracks; ++track) {
    std::vector<std::pair<double, double>> blocked;
    for (const Ring& pond : ponds)
      if (pond[0].y < (track + 1) * kWidth_m && pond[2].y > track * kWidth_m)
        blocked.emplace_back(pond[0].x - 1.5 - ragged(), pond[2].x + 1.5 + ragged());
    std::sort(blocked.begin(), blocked.end());
    double from = ragged();
    for (const auto& [begin, end] : blocked) {
      if (begin > from + 5) out.push_back(piece(track, from, begin));
      from = std::max(from, end);
    }
    if (length > from + 5) out.push_back(piece(track, from, length - ragged()));
  }
}

// Up to five ponds anywhere in a rectangle: hops are as short as is promised, and fewer of them lead through
// ponds than track by track.
TEST(DrivingOrderProperties, FewHopsLeadThroughPonds) {
  int through = 0, through_by_track = 0;
  for_each_seed(60, [&](std::mt19937_64& random, int number) {
    std::vector<Ring> ponds;
    for (int i = 0; i <= number % 5; ++i) {
      const Point at{random_between(random, 20, 250), random_between(random, 10, 200)};
      ponds.push_back(
          box(at.x, at.y, at.x + random_between(random, 1, 60), at.y + random_between(random, 1, 60)));
    }
    std::vector<WorkedLine> lines;
    cut_at_ponds(random, 40, 300, ponds, lines);
    const Field field = field_of(box(0, 0, 300, 240), ponds);
    Plan plan = driven(field, lines);
    const Hops hops = hops_of(plan);
    EXPECT_LE(hops.length_m, 1.2 * nearest_neighbour_m(plan.pieces));
    const order::HopGround ground(field, 2 * kWidth_m);
    const order::HopCosts costs(lines, ground);
    plan.pieces = order::pieces_on(order::track_by_track(lines, costs), lines);
    const Hops by_track = hops_of(plan);
    const bool fewer = hops.through_obstacles < by_track.through_obstacles;
    EXPECT_LE(hops.length_m, (fewer ? 1.2 : 1) * by_track.length_m + 1e-6);
    through += hops.through_obstacles;
    through_by_track += by_track.through_obstacles;
  });
  EXPECT_LT(4 * through, through_by_track);
  EXPECT_GT(through_by_track, 60) << "the scenes ask for it";
}

double y_of(const TrackPiece& p) { return midpoint(p.start, p.end).y; }

// Pieces on both sides of a pond may be driven in different directions. What is left and right of an
// encounter is seen by the piece next to it, of the two the one driven first: of the lowest track that meets
// the pond the way past on the south is the cheaper one, of the highest that on the north.
TEST(DrivingOrder, SidesOfEncountersAreThoseOfThePieceBeforeThem) {
  const Field field = field_of(box(0, 0, 200, 66), {box(90, 24.5, 110, 41.5)});
  PlanSettings settings;
  settings.avoid = Avoidance::kCut;
  settings.decomposition_threshold = Angle::degrees(300);
  settings.strategy = Strategy::kSweep;
  const Plan plan = plan_field(field, {"", kWidth_m, 2, -1}, {}, settings);
  ASSERT_EQ(plan.encounters.size(), 3U);
  int looked_at = 0;
  for (const Encounter& encounter : plan.encounters) {
    if (std::abs(encounter.at.y - 33) < 1) continue;
    const auto first = std::find_if(plan.pieces.begin(), plan.pieces.end(), [&](const TrackPiece& p) {
      return std::abs(y_of(p) - encounter.at.y) < 0.1;
    });
    ASSERT_NE(first, plan.pieces.end());
    ASSERT_TRUE(encounter.left.possible);
    ASSERT_TRUE(encounter.right.possible);
    const bool north_is_left = first->end.x > first->start.x;
    const double north = north_is_left ? encounter.left.cost : encounter.right.cost;
    const double south = north_is_left ? encounter.right.cost : encounter.left.cost;
    EXPECT_EQ(south < north, encounter.at.y < 33) << "at y = " << encounter.at.y;
    ++looked_at;
  }
  EXPECT_EQ(looked_at, 2);
}

// The same mechanism for curved tracks: along the bent side of a field like a U.
TEST(DrivingOrder, CurvedTracksKeepToTheirLegToo) {
  Field field = field_of({});
  for (int i = 0; i <= 60; ++i) {
    const double angle = i * std::numbers::pi / 60;
    field.outer.push_back({100 * std::cos(angle), 100 * std::sin(angle)});
  }
  field.outer.push_back({-100, -150});
  field.outer.push_back({-60, -150});
  for (int i = 60; i >= 0; --i) {
    const double angle = i * std::numbers::pi / 60;
    field.outer.push_back({60 * std::cos(angle), 60 * std::sin(angle)});
  }
  field.outer.push_back({60, -150});
  field.outer.push_back({100, -150});
  PlanSettings settings;
  settings.shape = TrackShape::kCurved;
  const Plan plan = plan_field(field, {"", kWidth_m, 6, -1}, {}, settings);
  ASSERT_TRUE(is_curved(plan));
  EXPECT_LE(hops_of(plan).length_m, 1.2 * nearest_neighbour_m(plan.pieces));
  EXPECT_EQ(hops_of(plan).far_outside, 0);
}

}  // namespace
}  // namespace tramline
