// Detours on curved tracks: against straight ones, against the triangle between the circles, and what each
// way costs against polygon booleans.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "support/box_ring.h"
#include "tramline/avoidance/choose_detours.h"
#include "tramline/avoidance/detour/curved_detour_path.h"
#include "tramline/avoidance/detour/way_round.h"
#include "tramline/avoidance/least_cost_with_detours.h"
#include "tramline/cost/tally_by_booleans.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline::curved_detours_test {

constexpr double kPi = std::numbers::pi;

using testing_support::box;

Ring regular(int corners, double radius, Point centre) {
  Ring out;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * i / corners;
    out.push_back(centre + radius * Point{std::cos(angle), std::sin(angle)});
  }
  return out;
}

/// A field with tracks laid by hand. Copies refer to themselves, so there are none.
class Laid {
 public:
  Laid(const Ring& outer, const std::vector<Ring>& poles, const std::vector<FamilyTrack>& family,
       const Machine& machine, const Objective& objective = {}, const std::vector<Ring>& passable = {},
       const PlanSettings& settings = {})
      : machine_(machine), objective_(objective), settings_(settings) {
    field_.outer = outer;
    for (const Ring& ring : poles) field_.obstacles.push_back({{ring, {}}, ObstacleKind::kObstacle, "pole"});
    for (const Ring& ring : passable)
      field_.obstacles.push_back({{ring, {}}, ObstacleKind::kPassable, "strip"});
    ground_ = classify_obstacles(field_, machine.width_m, settings.clearance_m);
    const CurvedGround ground{
        EdgeIndex(ground_.plannable), EdgeIndex(ground_.hard),
        EdgeIndex(settings.boundary == EdgeKind::kHard ? Region{{outer, {}}} : Region{}),
        EdgeIndex(ground_.passable), EdgeIndex(ground_.beyond)};
    families_ = {curved_tracks(family, machine.width_m, ground,
                               end_criterion(settings.end_rule, objective, machine.width_m))};
  }
  Laid(const Laid&) = delete;
  Laid& operator=(const Laid&) = delete;

  AvoidanceTask task() const {
    static const std::vector<Subfield> kNoBorders;
    return {field_, ground_, machine_, objective_, settings_, kNoBorders, families_, area(ground_.body)};
  }
  const std::vector<Track>& tracks() const { return families_.front().tracks; }
  double cost_by_booleans(const LaidTracks& laid) const {
    return cost(objective_, tally_by_booleans({laid}, ground_.body));
  }

 private:
  Field field_;
  Machine machine_;
  Objective objective_;
  PlanSettings settings_;
  ClassifiedGround ground_;
  std::vector<TrackFamily> families_;
};

// Tracks about the origin, driven anticlockwise: radius 75 + (k + ½)·3, in a rectangle well within their
// ends.
constexpr double kWidth = 3, kRadius = 6;
std::vector<FamilyTrack> arcs(int first, int last) {
  const Path reference{{{75, 0}, {0, 75}, 1 / 75.0}, {{0, 75}, {-75, 0}, 1 / 75.0}};
  return parallel_family(reference, first, last, {kRadius, kWidth});
}
const Ring kOuter = box(-45, 55, 45, 95);
const Machine kMachine{"", kWidth, kRadius, 0};

int detours_in(const Avoided& avoided) {
  int out = 0;
  for (const LaidPiece& piece : avoided.tracks.front().pieces) out += static_cast<int>(piece.detours.size());
  return out;
}

double uniform(std::mt19937_64& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

TEST(CurvedDetourPath, OnAStraightTrackIsTheStraightDetour) {
  std::mt19937_64 random(5);
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<KeepOut> discs;
    const double half = uniform(random, 0.5, 3), radius = std::max(half, uniform(random, 1, 12));
    for (int k = std::uniform_int_distribution<int>(1, 5)(random); k > 0; --k)
      discs.push_back({{uniform(random, -6, 6), uniform(random, -half, 9)}, half});
    const std::optional<Path> straight = detour_path(discs, radius);
    const TrackLine line{MeasuredPath(straight_path({-200, 0}, {200, 0})), 194, 206};
    const auto curved = curved_detour_path(discs, radius, line);
    ASSERT_EQ(straight.has_value(), curved.has_value()) << i;
    if (!straight) continue;
    ++met;
    ASSERT_EQ(straight->size(), curved->path.size()) << i;
    EXPECT_NEAR(curved->from, straight->front().from.x + 200, 1e-8) << i;
    EXPECT_NEAR(curved->to, straight->back().to.x + 200, 1e-8) << i;
    for (std::size_t k = 0; k < straight->size(); ++k) {
      EXPECT_LT(distance((*straight)[k].to, curved->path[k].to), 1e-6) << i;
      EXPECT_EQ((*straight)[k].curvature, curved->path[k].curvature) << i;
    }
  }
  EXPECT_GT(met, 200);
}

/// Centre of a pole's keep-out circle on a track of radius q about the origin, seen from there: the middle
/// arc of radius ρ has its centre h − ρ beyond the track, the leaving arc's is r beyond it, and both touch.
double half_turn(double q, double h, double rho, double r, double outwards) {
  const double middle = q + outwards * (h - rho), leaving = q + outwards * r;
  return std::acos((middle * middle + leaving * leaving - (rho + r) * (rho + r)) / (2 * middle * leaving));
}

TEST(CurvedDetourPath, RoundAPoleOnACircle) {
  for (const double pole : {0.5, 2.0, 5.0})
    for (const Passing side : {Passing::kLeft, Passing::kRight}) {
      const Laid laid(kOuter, {regular(64, pole, {0, 76.5})}, arcs(0, 0), kMachine);
      ASSERT_EQ(laid.tracks().size(), 1u);
      const Track& track = laid.tracks().front();
      const auto task = laid.task();
      const WayRound way =
          way_round({task.families.front().grid, track, 1, kRadius}, side,
                    turned_surroundings(task.ground, task.field.outer, EdgeKind::kSoft, TrackFrame()));
      ASSERT_TRUE(way.possible()) << sentence(way.why_not);
      const double h = pole + 0.5 * kWidth, rho = std::max(h, kRadius);
      // Driven anticlockwise, the left is inwards.
      const double turn = half_turn(76.5, h, rho, kRadius, side == Passing::kLeft ? -1 : 1);
      EXPECT_NEAR(way.detour.to - way.detour.from, 2 * 76.5 * turn, 1e-5) << pole << name(side);
      EXPECT_NEAR(way.detour.from + way.detour.to, 2 * 76.5 * kPi / 2, 1e-6);
      ASSERT_GE(way.detour.path.size(), 3u);
      // The pole has been through the precision grid.
      EXPECT_NEAR(radius(way.detour.path[1]), rho, 1e-6);
      const Path all{way.detour.path};
      double nearest = 1e9;
      for (const PathSegment& segment : all)
        nearest = std::min(nearest, distance_to_edge(segment, {0, 76.5}, {0, 76.5}));
      EXPECT_NEAR(nearest, h, 1e-6) << "the swath touches the pole's circle";
      EXPECT_LT(distance(direction_at_end(all[0]), direction_at_start(all[1])), 1e-6);
      const Point leaves = all.front().from, heading = direction_at_start(all.front());
      EXPECT_NEAR(length(leaves), 76.5, 1e-9);
      EXPECT_NEAR(dot(leaves, heading), 0, 1e-7) << "tangential";
    }
}

/// The costs said for each way are those of the whole plan, by booleans over chords.
TEST(CurvedDetours, CostWhatThePlanCosts) {
  for (const double off : {0.0, 0.7, 1.4}) {
    const Laid laid(box(-30, 70, 30, 84), {regular(12, 1, {3, 76.5 + off})}, arcs(-3, 2), kMachine);
    const auto task = laid.task();
    const Avoided cut = all_cut(task), best = choose_detours(task);
    const std::vector<PlacedEncounter> encounters = encounters_in(task, cut);
    ASSERT_FALSE(encounters.empty());
    const Encounter& first = encounters.front();
    EXPECT_EQ(first.chosen, Passing::kCut);
    for (const Passing side : {Passing::kLeft, Passing::kRight}) {
      const WayPast& way = side == Passing::kLeft ? first.left : first.right;
      ASSERT_TRUE(way.possible);
      std::vector<std::vector<TrackDetour>> detours(laid.tracks().size());
      std::size_t at = 0;
      while (laid.tracks()[at].index != first.track) ++at;
      const WayRound round =
          way_round({task.families.front().grid, laid.tracks()[at], 1, kRadius}, side,
                    turned_surroundings(task.ground, task.field.outer, EdgeKind::kSoft, TrackFrame()));
      detours[at] = {round.detour};
      LaidTracks with{task.families.front().grid, {}, {}};
      for (std::size_t i = 0; i < laid.tracks().size(); ++i)
        append_pieces(laid.tracks()[i], detours[i], 0, with);
      EXPECT_NEAR(way.cost, laid.cost_by_booleans(with) - laid.cost_by_booleans(cut.tracks.front()), 2e-3)
          << off << name(side);
    }
    EXPECT_EQ(detours_in(best), static_cast<int>(encounters_in(task, best).size()));
    EXPECT_LT(best.cost, cut.cost - 5) << "two stops and a turn, less the bulge";
    EXPECT_NEAR(best.cost, laid.cost_by_booleans(best.tracks.front()), 2e-3);
    EXPECT_NEAR(best.tally.worked_m2, task.body_m2 - best.tally.uncovered_m2 + best.tally.overlap_m2, 1e-6);
    EXPECT_EQ(best.tally.stops, 0);
  }
}

/// Two arcs that meet without a kink in the pole's middle, and their neighbours: turned by half a circle
/// about it everything is as before, and left is right.
TEST(CurvedDetours, CostTheSameOnBothSidesOfASymmetricCurve) {
  const double r = 80, turn = 0.6, x = r * std::sin(turn), y = r * (1 - std::cos(turn));
  const Path s{{{-x, -y}, {0, 0}, -1 / r}, {{0, 0}, {x, y}, 1 / r}};
  std::vector<FamilyTrack> family{{0, {s, false}}};
  for (const int k : {-1, 1})
    for (const ParallelTrack& track : parallel(s, k * kWidth, {kRadius, kWidth}))
      family.push_back({k, track});
  PlanSettings settings;
  settings.avoid_threshold_m = 0;  // Versleijen passes on one side only
  const Laid laid(box(-30, -60, 30, 60), {regular(16, 1, {0, 0})}, family, kMachine, {}, {}, settings);
  const auto encounters = encounters_in(laid.task(), choose_detours(laid.task()));
  ASSERT_EQ(encounters.size(), 1u);
  const Encounter& only = encounters.front();
  ASSERT_TRUE(only.left.possible && only.right.possible);
  EXPECT_NEAR(only.left.cost, only.right.cost, 1e-7);
  EXPECT_LT(only.left.cost, -8);
  EXPECT_NE(only.chosen, Passing::kCut);
  EXPECT_LT(length(only.at), 1e-6);
}

TEST(CurvedDetours, TooLargeAnObstacleIsCut) {
  const Laid laid(kOuter, {box(-14, 62, 14, 90)}, arcs(-7, 6), kMachine, {0.04, 0.10, 0.45, 0.2});
  const Avoided best = choose_detours(laid.task());
  int cut = 0;
  for (const PlacedEncounter& encounter : encounters_in(laid.task(), best))
    if (encounter.chosen == Passing::kCut) ++cut;
  EXPECT_GE(cut, 5);
  EXPECT_LE(best.cost, all_cut(laid.task()).cost);
}

TEST(CurvedDetours, AreDrivenWhereTheSettingsAllowThem) {
  PlanSettings settings;
  settings.avoid = Avoidance::kCut;
  const Laid laid(kOuter, {regular(12, 1, {0, 76.5})}, arcs(-5, 4), kMachine, {}, {}, settings);
  const Avoided avoided = choose_detours(laid.task());
  EXPECT_EQ(detours_in(avoided), 0);
  const auto encounters = encounters_in(laid.task(), avoided);
  ASSERT_EQ(encounters.size(), 1u);
  EXPECT_EQ(encounters.front().chosen, Passing::kCut);
}

/// A pole 2 m wide, 0.1 m to the outside of the track's line, is passed on the inside: that is the smaller
/// displacement. Driven anticlockwise the inside is left.
TEST(CurvedDetours, ByS1GoRoundWhatIsNarrowerThanTheThreshold) {
  PlanSettings settings;
  settings.avoid = Avoidance::kPaper;
  for (const double threshold_m : {-1.0, 2.5, 1.5})
    for (const double off : {0.1, -0.1}) {
      settings.avoid_threshold_m = threshold_m;
      const Laid laid(kOuter, {regular(12, 1, {0, 76.5 + off})}, arcs(-5, 4), kMachine, {}, {}, settings);
      const Avoided avoided = choose_detours(laid.task());
      const auto encounters = encounters_in(laid.task(), avoided);
      ASSERT_EQ(encounters.size(), 1u);
      const PlacedEncounter& only = encounters.front();
      if (threshold_m == 1.5) {
        EXPECT_EQ(detours_in(avoided), 0);
        EXPECT_EQ(only.left.why_not, "the obstacle is too wide across the track");
        continue;
      }
      ASSERT_EQ(detours_in(avoided), 1);
      EXPECT_EQ(only.chosen, off > 0 ? Passing::kLeft : Passing::kRight);
      // The middle arc of the paper, along the pole's buffer, is tighter than the machine can follow.
      for (const LaidPiece& piece : avoided.tracks.front().pieces)
        for (const TrackDetour& detour : piece.detours) {
          EXPECT_NEAR(smallest_radius(detour.path), 1 + kWidth / 2, 1e-5);
          EXPECT_NEAR(radius(detour.path.front()), kRadius, 1e-9);
          EXPECT_NEAR(radius(detour.path.back()), kRadius, 1e-9);
          EXPECT_NEAR(distance(centre(detour.path[1]), {0, 76.5 + off}), 0, 1e-4);
        }
    }
}

/// Beside a hard edge there is room on one side only; and a clearance moves the detour out by as much.
TEST(CurvedDetours, KeepWithinHardBoundariesAndTheirClearance) {
  PlanSettings settings;
  settings.boundary = EdgeKind::kHard;
  const Laid laid(box(-45, 55, 45, 81), {regular(12, 0.5, {0, 79.2})}, arcs(-5, 2), kMachine, {}, {},
                  settings);
  int left = 0;
  for (const PlacedEncounter& one : encounters_in(laid.task(), choose_detours(laid.task()))) {
    EXPECT_FALSE(one.right.possible);
    left += one.chosen == Passing::kLeft ? 1 : 0;
  }
  EXPECT_GT(left, 0);

  settings = {};
  settings.clearance_m = 0.8;
  const Laid clear(kOuter, {box(-1, 75.5, 1, 77.5)}, arcs(-5, 4), kMachine, {}, {}, settings);
  const Avoided best = choose_detours(clear.task());
  ASSERT_GT(detours_in(best), 0);
  for (const LaidPiece& piece : best.tracks.front().pieces)
    EXPECT_GE(distance_between({{band(piece.path, kWidth), {}}}, {{box(-1, 75.5, 1, 77.5), {}}}), 0.8 - 2e-5);
}

/// Ditches like spokes: each track is interrupted twice, and goes on.
TEST(CurvedTracksAndPassables, AreCrossed) {
  const std::vector<Ring> ditches{box(-12, 50, -10, 100), box(8, 50, 11, 100)};
  const Laid laid(kOuter, {}, arcs(-3, 2), kMachine, {}, ditches);
  const Avoided laid_out = choose_detours(laid.task());
  EXPECT_EQ(laid_out.tally.pieces, 18);
  EXPECT_EQ(laid_out.tally.crossings, 12);
  EXPECT_EQ(laid_out.tally.turns, 5);
  EXPECT_EQ(laid_out.tally.stops, 0);
  // The middle piece of track 0 is as long as its swath keeps off both ditches: from x = −10 at its inner
  // edge of radius 75, or the outer of 78, to x = 8.
  const LaidPiece& middle = laid_out.tracks.front().pieces[3 * 3 + 1];
  ASSERT_EQ(middle.track, 0);
  EXPECT_TRUE(middle.after_crossing);
  EXPECT_NEAR(middle.length_m, 76.5 * (std::asin(8 / 78.0) + std::asin(10 / 78.0)), 1e-3);
  EXPECT_TRUE(encounters_in(laid.task(), laid_out).empty());
}

}  // namespace tramline::curved_detours_test
