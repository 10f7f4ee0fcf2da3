// What passes that are left take, against all orders of them through all places tried.

#include "tramline/route/passes/passes_ahead.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <numbers>
#include <vector>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "route/passes/open_land.h"
#include "route/rounded_rectangle.h"
#include "tramline/route/passes/next_pass.h"
#include "tramline/route/passes/passes_round_obstacles.h"

namespace tramline::passes_ahead_test {
namespace {

using testing::for_each_seed;

constexpr double kRadius_m = 5, kWidth_m = 4;

HeadlandPass moved(HeadlandPass pass, Point by) {
  for (PathSegment& segment : pass.path) {
    segment.from = segment.from + by;
    segment.to = segment.to + by;
  }
  return pass;
}

/// Two passes round a field of random size, one inside the other, and one or two round obstacles in it.
struct Passes : testing::OpenLand {
  explicit Passes(std::mt19937_64& random) : OpenLand(machine_for_passes()) {
    const double long_m = uniform(random, 150, 300), wide_m = uniform(random, 60, 120);
    for (const int number : {1, 2}) {
      const double in_m = 2 * kWidth_m * number;
      headland.passes.push_back(testing::rounded_rectangle(long_m - in_m, wide_m - in_m, kRadius_m));
      headland.passes.back().number = number;
      headland.passes.back().around_field = true;
    }
    const int obstacles = any_of(random, 1, 2);
    for (int i = 0; i < obstacles; ++i) {
      const Point at{uniform(random, -long_m / 3, long_m / 3), uniform(random, -wide_m / 5, wide_m / 5)};
      headland.passes.push_back(moved(testing::rounded_rectangle(uniform(random, 1, 20), 2, kRadius_m), at));
      headland.passes.back().obstacles = {static_cast<std::size_t>(i)};
    }
    for (std::size_t i = 0; i < headland.passes.size(); ++i) all.push_back(i);
    entries = entries_by_pass(headland, machine);
    if (any_of(random, 0, 1) == 1) task.gate = Point{uniform(random, -200, 200), uniform(random, -80, 80)};
  }

  static Machine machine_for_passes() {
    Machine out;
    out.width_m = kWidth_m;
    out.radius_m = kRadius_m;
    return out;
  }
};

double seconds(const Passes& scene, Point from, Point to) {
  return lane_change_m(distance(from, to), kRadius_m) / scene.machine.turning.turning_speed_mps;
}

/// In one order, through any places of the passes.
double in_order_s(const Passes& scene, const std::vector<std::size_t>& order, Point left) {
  std::vector<Point> from{left};
  std::vector<double> there_s{0};
  for (const std::size_t pass : order) {
    std::vector<Point> places;
    std::vector<double> on_s;
    for (const PassEntry& entry : scene.entries[pass]) {
      if (entry.sense == Sense::kAgainst) continue;
      places.push_back(entry.entered.at);
      double least_s = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < from.size(); ++i)
        least_s = std::min(least_s, there_s[i] + seconds(scene, from[i], places.back()));
      on_s.push_back(least_s);
    }
    from = std::move(places);
    there_s = std::move(on_s);
  }
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < from.size(); ++i)
    out = std::min(out, there_s[i] + (scene.task.gate ? distance(from[i], *scene.task.gate) /
                                                            scene.machine.turning.turning_speed_mps
                                                      : 0));
  return out;
}

// It knows no places that the orders tried do not know, so it is never less; and it is hardly more.
TEST(PassesAhead, AreAboutTheBestOfAllOrders) {
  double foreseen_s = 0, best_s = 0;
  for_each_seed(20, [&](std::mt19937_64& random, int) {
    const Passes scene(random);
    const std::size_t first =
        static_cast<std::size_t>(any_of(random, 0, static_cast<int>(scene.all.size()) - 1));
    const Point left = scene.entries[first][static_cast<std::size_t>(any_of(random, 0, 20))].left.at;
    std::vector<bool> worked(scene.all.size(), false);
    worked[first] = true;
    std::vector<std::size_t> order;
    for (const std::size_t pass : scene.all)
      if (pass != first) order.push_back(pass);
    double least_s = std::numeric_limits<double>::infinity();
    do {
      least_s = std::min(least_s, in_order_s(scene, order, left));
    } while (std::ranges::next_permutation(order).found);
    const double ahead_s = PassesAhead(scene.task).onward_s(worked, left);
    EXPECT_GE(ahead_s, least_s - 1e-9);
    EXPECT_LE(ahead_s, 1.25 * least_s + 2);
    foreseen_s += ahead_s;
    best_s += least_s;
  });
  std::cout << foreseen_s / best_s << " of the least time of all orders and places\n";
  EXPECT_LT(foreseen_s, 1.05 * best_s);
}

// What was remembered of other places changes nothing: asked of every tenth place of a pass they say what
// they say when they are asked of that alone.
TEST(PassesAhead, DoNotDependOnWhatWasAskedBefore) {
  for_each_seed(5, [&](std::mt19937_64& random, int) {
    const Passes scene(random);
    const PassesAhead ahead(scene.task);
    for (const std::size_t first : scene.all) {
      std::vector<bool> worked(scene.all.size(), false);
      worked[first] = true;
      for (std::size_t i = 0; i < scene.entries[first].size(); i += 10) {
        const Point left = scene.entries[first][i].left.at;
        EXPECT_EQ(ahead.onward_s(worked, left), PassesAhead(scene.task).onward_s(worked, left));
      }
    }
  });
}

/// The least of all entries: straight there, and on from there.
double about_by_all_s(const Passes& scene, const PassesAhead& ahead, const std::vector<bool>& worked,
                      const Pose& from) {
  double out = std::numeric_limits<double>::infinity();
  for (const std::size_t pass : scene.all) {
    if (worked[pass]) continue;
    std::vector<bool> with = worked;
    with[pass] = true;
    for (const PassEntry& entry : scene.entries[pass])
      out = std::min(out, scene.least.crude(from, entry.entered) +
                              std::max(0.0, ahead.onward_s(with, entry.left.at) - ahead.least_s(worked)));
  }
  return out;
}

TEST(NextPass, IsAboutAsFarAsTheNearestOfAllEntries) {
  for_each_seed(20, [&](std::mt19937_64& random, int) {
    const Passes scene(random);
    const PassesAhead ahead(scene.task);
    NextPass next(scene.task);
    std::vector<bool> worked(scene.all.size(), false);
    for (const std::size_t pass : scene.all) {
      for (int i = 0; i < 10; ++i) {
        const Pose from{{uniform(random, -200, 200), uniform(random, -80, 80)}, Heading()};
        EXPECT_NEAR(next.about_s(from), about_by_all_s(scene, ahead, worked, from), 1e-9);
      }
      next.work(pass);
      worked[pass] = true;
    }
  });
}

TEST(PassesAhead, AreNothingOnceAllIsWorked) {
  for_each_seed(5, [&](std::mt19937_64& random, int) {
    Passes scene(random);
    scene.task.gate.reset();
    EXPECT_EQ(PassesAhead(scene.task).onward_s(std::vector<bool>(scene.all.size(), true), {0, 0}), 0);
    scene.task.gate = Point{30, 40};
    EXPECT_NEAR(PassesAhead(scene.task).onward_s(std::vector<bool>(scene.all.size(), true), {0, 0}),
                50 / scene.machine.turning.turning_speed_mps, 1e-9);
  });
}

// By two quarter circles and the straight line between, or by two arcs that turn as far as the lane is aside:
// 2 r sin a along, 2 r (1 - cos a) across.
TEST(PassesAhead, ChangeLanesByTwoArcs) {
  EXPECT_NEAR(lane_change_m(30, 5), std::numbers::pi * 5 + 20, 1e-12);
  EXPECT_NEAR(lane_change_m(10, 5), std::numbers::pi * 5, 1e-12);
  EXPECT_NEAR(lane_change_m(5, 5), 2 * 5 * std::numbers::pi / 3, 1e-12);
  EXPECT_EQ(lane_change_m(0, 5), 0);
}

/// A pass round some obstacles, or round the field.
HeadlandPass pass_round(std::vector<std::size_t> obstacles, bool field, int number) {
  HeadlandPass out = testing::rounded_rectangle(20, 20, kRadius_m);
  out.obstacles = std::move(obstacles);
  out.around_field = field;
  out.number = number;
  return out;
}

// Obstacle 2 is joined to the field by a pass that follows both, and obstacles 0 and 1 by one round both.
TEST(PassesRoundObstacles, AreThoseOfBoundariesThatNoOtherPassFollows) {
  Headland headland;
  headland.passes = {pass_round({}, true, 1),  pass_round({0}, false, 1),    pass_round({1}, false, 1),
                     pass_round({2}, true, 2), pass_round({0, 1}, false, 2), pass_round({2}, false, 1),
                     pass_round({3}, false, 1)};
  using Groups = std::vector<std::vector<std::size_t>>;
  EXPECT_EQ(passes_round_obstacles(headland, {0, 1, 2, 3, 4, 5, 6}), (Groups{{1, 2, 4}, {6}}));
  headland.passes[6].path.pop_back();  // open
  EXPECT_EQ(passes_round_obstacles(headland, {0, 1, 2, 3, 4, 5, 6}), (Groups{{1, 2, 4}}));
}

// Ten tracks 10 m apart, driven up and down from x = 0 on. The obstacle at x = 38 ends those at 30 and 40.
TEST(PassesAmongTracks, ComeBehindTheTracksThatEndThere) {
  std::vector<std::vector<TrackPiece>> pieces;
  for (int i = 0; i < 10; ++i) {
    TrackPiece piece;
    piece.start = {10.0 * i, i % 2 == 0 ? 0.0 : 100.0};
    piece.end = {10.0 * i, i % 2 == 0 ? 100.0 : 0.0};
    if (i == 3) piece.end.y = 60;  // driven down, to the obstacle
    if (i == 4) piece.end.y = 40;  // driven up, to the obstacle
    pieces.push_back({piece});
  }
  std::vector<DrivenTrack> tracks;
  for (const std::vector<TrackPiece>& piece : pieces) {
    const Heading heading = Heading::from_to(piece.front().start, piece.front().end);
    tracks.push_back({&piece, {piece.front().start, heading}, {piece.front().end, heading}});
  }
  const std::vector<Point> places{{34, 50}, {42, 50}, {38, 54}, {38, 46}};
  EXPECT_EQ(track_before(tracks, places, 10), 4U);
  // Where it ends none, it is worked where the way between two tracks leads by.
  EXPECT_EQ(track_before(tracks, {{75, 103}}, 1), 6U);
  // Only the last track ends there: behind it come all other passes anyway.
  EXPECT_EQ(track_before(tracks, {{90, 2}}, 2), std::nullopt);
}

}  // namespace
}  // namespace tramline::passes_ahead_test
