// Ways between ends: turns against all straight ways tried one after the other, words against all words tried
// for room, and tours against the same tours driven from their ends.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <vector>

#include "properties/draws.h"
#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/route/build/known_costs.h"
#include "tramline/route/build/lines_beside_boundaries.h"
#include "tramline/route/build/track_tour.h"
#include "tramline/route/connection/arc_room.h"
#include "tramline/route/connection/unreachable.h"
#include "tramline/route/turning/planned_turns.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/outline/outline.h"

namespace tramline {
namespace {

using testing::for_each_seed;

Machine random_machine(std::mt19937_64& random) {
  Machine out;
  out.width_m = uniform(random, 2, 9);
  out.radius_m = uniform(random, 3, 8);
  out.turning.reverse = any_of(random, 0, 1) == 1;
  out.turning.lift_m = out.turning.lower_m = any_of(random, 0, 1) * uniform(random, 0, 3);
  if (any_of(random, 0, 1) == 0) return out;
  out.turning.front_overhang_m = uniform(random, 0, 4);
  out.turning.vehicle_width_m = 2.5;
  if (any_of(random, 0, 2) == 0) out.turning.steering_time_s = 3;
  return out;
}

/// The ends of two tracks beside one another, near the edge of a field with pylons.
struct Hopping {
  Region land;
  Hop hop;
};

Hopping random_hop(std::mt19937_64& random, const Machine& machine) {
  const double slope = uniform(random, -0.5, 0.5), edge_m = uniform(random, 4, 28);
  const auto edge = [&](double x) { return edge_m + slope * x; };
  Polygon field{{{-45, -80}, {45, -80}, {45, edge(45)}, {-45, edge(-45)}}, {}};
  const int pylons = any_of(random, 0, 2);
  for (int i = 0; i < pylons; ++i) {
    const double x = -30.0 + 30 * i + uniform(random, -8, 8), y = edge(x) - uniform(random, 2.5, 9);
    field.holes.push_back({{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}});
  }
  const double jump = machine.width_m * any_of(random, 1, 3) * (any_of(random, 0, 1) == 0 ? 1 : -1);
  const Heading north = Heading::clockwise_from_north(Angle::degrees(0)),
                south = Heading::clockwise_from_north(Angle::degrees(180));
  return {{field}, {{{0, 0}, north}, {{jump, slope * jump}, south}}};
}

std::optional<Manoeuvre> first_of_all(const Hop& hop, const AllowedLand& land, const Machine& machine) {
  const Outline outline = outline_of(machine);
  const double step_m = 0.5 * std::max(machine.radius_m, machine.width_m);
  for (int sum = 0; sum <= 6; ++sum)
    for (int before = 0; before <= sum; ++before)
      for (const HopWay& way : manoeuvres_over(hop, machine, {before * step_m, (sum - before) * step_m}))
        if (!way.over_tracks && land.fits(way.manoeuvre.path, outline)) return way.manoeuvre;
  return std::nullopt;
}

TEST(TurnBeforeEnds, IsTheFirstOfAllStraightWays) {
  int direct = 0, longer = 0, none = 0;
  for_each_seed(1500, [&](std::mt19937_64& random, int) {
    const Machine machine = random_machine(random);
    const auto [region, hop] = random_hop(random, machine);
    const AllowedLand land(region);
    const std::optional<Manoeuvre> expected = first_of_all(hop, land, machine);
    const std::optional<Manoeuvre> found = turn_before_ends(hop, land, machine, {});
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (!found) {
      ++none;
      return;
    }
    EXPECT_EQ(found->word, expected->word);
    EXPECT_EQ(length(found->path), length(expected->path));
    const bool is_direct = std::ranges::any_of(manoeuvres_over(hop, machine, {}), [&](const HopWay& way) {
      return length(way.manoeuvre.path) == length(found->path);
    });
    ++(is_direct ? direct : longer);
  });
  if (testing::case_count(1500) < 1500) return;
  EXPECT_GT(direct, 150);
  EXPECT_GT(longer, 10) << "straight ways are hardly ever needed";
  EXPECT_GT(none, 50);
}

/// Poses on a field with pylons, some of them with room.
std::vector<Pose> random_poses(std::mt19937_64& random, std::size_t count) {
  std::vector<Pose> out;
  while (out.size() < count)
    out.push_back({{uniform(random, -42, 42), uniform(random, -40, 25)},
                   Heading::clockwise_from_north(Angle::degrees(uniform(random, 0, 360)))});
  return out;
}

/// What is known of first and last turns rules out no word that has room, and lets none pass that has not,
/// however many words left and entered the same poses before.
TEST(ArcRoom, FindsTheFirstOfAllWordsWithRoom) {
  int found = 0, not_the_first = 0, none = 0;
  for_each_seed(60, [&](std::mt19937_64& random, int) {
    Machine machine = random_machine(random);
    machine.turning.steering_time_s = 0;
    const Region region = random_hop(random, machine).land;
    const AllowedLand land(region);
    Field field;
    field.outer = region.front().outer;
    const DrivingGround ground(land, field, machine, region);
    ArcRoom room(ground);
    const std::vector<Pose> poses = random_poses(random, 8);
    for (const Pose& from : poses)
      for (const Pose& to : poses) {
        const std::vector<Manoeuvre> words = dubins_words(from, to, machine.radius_m);
        const auto expected = std::ranges::find_if(
            words, [&](const Manoeuvre& word) { return land.fits(word.path, ground.outline()); });
        const auto path = room.first_with_room(from, to, {from, to, machine.radius_m});
        ASSERT_EQ(path.has_value(), expected != words.end());
        if (!path) {
          ++none;
          continue;
        }
        ++found;
        not_the_first += expected != words.begin() ? 1 : 0;
        EXPECT_NEAR(length(*path), length(expected->path), 1e-9 * (1 + length(*path)));
        // A few words are the first few.
        const bool first = expected == words.begin();
        EXPECT_EQ(ArcRoom(ground).first_with_room(from, to, {from, to, machine.radius_m}, 1).has_value(),
                  first);
      }
  });
  if (testing::case_count(60) < 60) return;
  EXPECT_GT(found, 500);
  EXPECT_GT(not_the_first, 100);
  EXPECT_GT(none, 500);
}

/// Tracks from south to north over a field whose edges slope, with as much land beyond their ends.
struct Tracks {
  Field field;
  Region body;
  std::vector<order::WorkedLine> lines;
};

Tracks random_tracks(std::mt19937_64& random, double width_m) {
  const int count = any_of(random, 4, 12);
  const double depth_m = uniform(random, 6, 18), low = uniform(random, -0.3, 0.3),
               high = uniform(random, -0.3, 0.3);
  const double east = width_m * count;
  const auto corner = [&](double x, double slope, double y) { return Point{x, y + slope * x}; };
  Tracks out;
  out.field.outer = {corner(-depth_m, low, -depth_m), corner(east + depth_m, low, -depth_m),
                     corner(east + depth_m, high, 120 + depth_m), corner(-depth_m, high, 120 + depth_m)};
  out.body = {{{corner(0, low, 0), corner(east, low, 0), corner(east, high, 120), corner(0, high, 120)}, {}}};
  for (int i = 0; i < count; ++i) {
    const double x = width_m * (i + 0.5);
    TrackPiece piece{corner(x, low, 0), corner(x, high, 120)};
    piece.track = i;
    out.lines.push_back({piece});
  }
  return out;
}

/// Random tracks and all it takes to find ways between them. Its members refer to one another.
struct TracksToJoin {
  /// There may be walls round the first track, which nothing gets over.
  explicit TracksToJoin(std::mt19937_64& random, bool first_is_walled = false)
      : machine(machine_without_overhang(random)),
        tracks(random_tracks(random, machine.width_m)),
        land({{tracks.field.outer, first_is_walled ? walls() : std::vector<Ring>{}}}),
        ground(land, tracks.field, machine, tracks.body),
        roadmap(new_roadmap()),
        connector(ground, roadmap, {}),
        least(machine) {
    for (const order::WorkedLine& line : tracks.lines) lines.push_back(route_line(line, machine.turning));
  }
  TracksToJoin(const TracksToJoin&) = delete;
  TracksToJoin& operator=(const TracksToJoin&) = delete;

  /// On both sides of the first track and across its ends, a metre thick.
  std::vector<Ring> walls() const {
    const TrackPiece& first = tracks.lines.front().front();
    const double x = first.start.x, beside_m = 0.7 * machine.width_m;
    const double south = first.start.y - 2, north = first.end.y + 2;
    const auto box = [](double from_x, double from_y, double to_x, double to_y) {
      return Ring{{from_x, from_y}, {from_x, to_y}, {to_x, to_y}, {to_x, from_y}};
    };
    return {box(x - beside_m - 1, south, x - beside_m, north),
            box(x + beside_m, south, x + beside_m + 1, north),
            box(x - beside_m - 1, south - 1.5, x + beside_m + 1, south - 0.5),
            box(x - beside_m - 1, north + 0.5, x + beside_m + 1, north + 1.5)};
  }

  RoadmapOnDemand new_roadmap() const {
    return {[this] {
              return Roadmap(lines_beside_boundaries({}, tracks.field, ground), 0.75 * machine.radius_m);
            },
            ground};
  }

  static Machine machine_without_overhang(std::mt19937_64& random) {
    Machine out;
    out.width_m = uniform(random, 3, 7);
    out.radius_m = uniform(random, 3, 7);
    return out;
  }

  Machine machine;
  Tracks tracks;
  AllowedLand land;
  DrivingGround ground;
  RoadmapOnDemand roadmap;
  Connector connector;
  std::vector<RouteLine> lines;
  LeastSeconds least;
};

double seconds_of(const TrackTour& tour) {
  double out = 0;
  for (const Way& way : tour.ways) out += way.cost_s;
  return out;
}

auto lacking(const TrackTour& tour) {
  return std::ranges::count_if(tour.ways, [](const Way& way) { return !way.has_room(); });
}

SteeredPath eastwards(double from_m, double length_m, Gear gear) {
  const Heading heading = Heading::clockwise_from_north(Angle::degrees(90));
  return {arc_from({{from_m, 0}, heading}, length_m, 0, gear)};
}

// Ten metres before, four of them backed, seven forward again, and two of the work come over by backing into
// it.
TEST(DrivenForward, LeavesOutWhatWasBackedOver) {
  const SteeredPath before = eastwards(0, 10, Gear::kForward), work = eastwards(11, 20, Gear::kForward);
  Way way;
  way.backs_out = way.backs_in = true;
  way.path = {eastwards(10, 4, Gear::kReverse).front(), eastwards(6, 7, Gear::kForward).front(),
              eastwards(13, 2, Gear::kReverse).front()};
  const SteeredPath driven = driven_forward(before, way, work);
  EXPECT_NEAR(length(driven), 6 + 7 + 18, 1e-9);
  EXPECT_NEAR(driven.front().start.at.x, 0, 1e-9);
  EXPECT_NEAR(driven.back().start.at.x + driven.back().length_m, 31, 1e-9);
  // Backed along land that it had not come over: from there on only.
  const SteeredPath elsewhere = eastwards(100, 10, Gear::kForward);
  EXPECT_NEAR(length(driven_forward(elsewhere, way, work)), 7 + 18, 1e-9);
  way.missing_m = 1;
  EXPECT_NEAR(length(driven_forward(before, way, work)), 20, 1e-9);
}

/// Ways from an end are expected to cost more once one was found that does: not less than before, and by no
/// more than that one. A way without room tells nothing of others.
TEST(KnownCosts, ExpectMoreWhereAWayCostMore) {
  int dearer = 0, without_room = 0;
  for_each_seed(200, [&](std::mt19937_64& random, int) {
    const TracksToJoin scene(random);
    KnownCosts costs(scene.lines, scene.connector, scene.least);
    const order::End a = 1, b = 3, c = 5;  // where the first three tracks end
    costs.expect_more();
    const double foreseen_s = costs.between(a, b), other_s = costs.between(a, c);
    const Way way = costs.way(a, b);
    const double more_s = costs.between(a, c) - other_s;
    if (!way.has_room()) {
      EXPECT_EQ(more_s, 0);
      ++without_room;
    } else if (const double excess_s = way.cost_s - foreseen_s; excess_s > 1) {
      EXPECT_GT(more_s, 0);
      EXPECT_LT(more_s, excess_s);
      ++dearer;
    }
  });
  EXPECT_GT(dearer, 10);
  std::cout << dearer << " ways dearer than foreseen, " << without_room << " without room\n";
}

// Of three poses, the first leads to neither end, the second to the other one only, the third to both.
TEST(Unreachable, IsWhatLeadsToNoneOfTheEnds) {
  const Pose one{{0, 0}, Heading::clockwise_from_north(Angle::degrees(0))},
      other{{0, 0}, Heading::clockwise_from_north(Angle::degrees(90))};
  Unreachable known(3);
  EXPECT_EQ(known.to_any({one}), Unreachable::From({0, 0, 0})) << "nothing is known";
  EXPECT_EQ(known.to(one), nullptr);
  known.add(one, {1, 0, 0});
  known.add(one, {0, 1, 0});
  EXPECT_EQ(known.to_any({one}), Unreachable::From({1, 1, 0})) << "the second search adds to the first";
  ASSERT_NE(known.to(one), nullptr);
  EXPECT_EQ(*known.to(one), known.to_any({one}));
  EXPECT_EQ(known.to_any({one, other}), Unreachable::From({0, 0, 0})) << "of the other nothing is known";
  known.add(other, {1, 0, 0});
  EXPECT_EQ(known.to_any({one, other}), Unreachable::From({1, 0, 0}));
  known.add_all(other);
  EXPECT_EQ(known.to_any({one, other}), Unreachable::From({1, 1, 0}));
  EXPECT_EQ(known.to_any({other}), Unreachable::From({1, 1, 1}));
}

/// What failed searches teach leaves out no way: one that meets a roadmap on which many were made before
/// finds a way where the first on a roadmap does. Searches follow estimates up to a fifth too high, which
/// know of the ends that lead nowhere, so what is found may differ by as much.
TEST(Connector, LearnsFromWaysWithoutRoomOnlyWhatHolds) {
  int found = 0, without_room = 0;
  for_each_seed(12, [&](std::mt19937_64& random, int i) {
    const TracksToJoin scene(random, i % 2 == 0);
    for (order::End left = 0; left < 2 * scene.lines.size(); left += 2)
      for (order::End entered = 1; entered < 2 * scene.lines.size(); entered += 3) {
        if (order::line_of(left) == order::line_of(entered)) continue;
        const SteeredPath& from = scene.lines[order::line_of(left)].left_by(left).last;
        const SteeredPath& to = scene.lines[order::line_of(entered)].entered_by(entered).first;
        RoadmapOnDemand roadmap = scene.new_roadmap();
        const Way first = Connector(scene.ground, roadmap, {}).between(from, to),
                  later = scene.connector.between(from, to);
        ASSERT_EQ(first.has_room(), later.has_room());
        if (first.has_room()) {
          EXPECT_LE(std::max(first.cost_s, later.cost_s), 1.2 * std::min(first.cost_s, later.cost_s));
        }
        ++(first.has_room() ? found : without_room);
      }
  });
  std::cout << found << " ways with room, " << without_room << " without\n";
  if (testing::case_count(12) < 12) return;
  EXPECT_GT(found, 100);
  EXPECT_GT(without_room, 30);
}

/// Three ways without room and none with it: no way of that end is expected to have room, until one has.
TEST(KnownCosts, ExpectNoRoomAtDeadEnds) {
  int dead = 0, alive = 0;
  for_each_seed(40, [&](std::mt19937_64& random, int i) {
    const TracksToJoin scene(random, i % 2 == 0);
    if (scene.lines.size() < 6) return;
    KnownCosts costs(scene.lines, scene.connector, scene.least);
    const order::End end = 1;
    const double foreseen_s = costs.between(end, 11);
    bool has_room = false;
    for (const order::End other : {3U, 5U, 7U}) has_room = costs.way(end, other).has_room() || has_room;
    if (has_room) {
      EXPECT_EQ(costs.between(end, 11), foreseen_s);
      ++alive;
    } else {
      EXPECT_GE(costs.between(end, 11), foreseen_s + 1000);
      ++dead;
    }
  });
  std::cout << dead << " dead ends, " << alive << " others\n";
  if (testing::case_count(40) < 40) return;
  EXPECT_GT(dead, 5);
  EXPECT_GT(alive, 5);
}

/// Where nothing reaches out, a tour costs about as much from its end: looking at one sense is enough.
TEST(WithWays, OneSenseIsEnoughForABar) {
  double one_s = 0, both_s = 0;
  for_each_seed(60, [&](std::mt19937_64& random, int) {
    const TracksToJoin scene(random);
    KnownCosts costs(scene.lines, scene.connector, scene.least);
    order::Tour tour;
    for (std::size_t i = 0; i < scene.lines.size(); ++i) tour.push_back(2 * i + i % 2);
    for (int swaps = any_of(random, 0, 2); swaps > 0; --swaps)
      std::swap(tour[static_cast<std::size_t>(any_of(random, 0, static_cast<int>(tour.size()) - 1))],
                tour.front());
    const TrackTour one = with_ways(tour, Senses::kCostTheSame, costs),
                    both = with_ways(tour, Senses::kDiffer, costs);
    EXPECT_EQ(one.ways.size() + 1, scene.lines.size());
    EXPECT_EQ(lacking(one), lacking(both));
    EXPECT_LE(seconds_of(one), 1.1 * seconds_of(both) + 1);
    one_s += seconds_of(one);
    both_s += seconds_of(both);
  });
  EXPECT_LE(one_s, 1.01 * both_s);
  EXPECT_GT(both_s, 0);
}

/// The tours that were settled with less patience are among those with more.
TEST(BestTourWithWays, IsNoWorseWithMorePatience) {
  int better = 0;
  for_each_seed(40, [&](std::mt19937_64& random, int) {
    const TracksToJoin scene(random);
    const auto found = [&](Patience patience) {
      KnownCosts costs(scene.lines, scene.connector, scene.least);
      return best_tour_with_ways({}, Senses::kDiffer, patience, costs);
    };
    const TrackTour usual = found(Patience::kUsual), longer = found(Patience::kLong);
    EXPECT_LE(lacking(longer), lacking(usual));
    if (lacking(longer) == lacking(usual)) {
      EXPECT_LE(seconds_of(longer), seconds_of(usual) + 1e-6);
    }
    if (!usual.gave_up) {
      EXPECT_EQ(longer.tour, usual.tour);
    }
    if (seconds_of(longer) < seconds_of(usual) - 0.1) ++better;
  });
  std::cout << better << " tours are quicker with more patience\n";
}

}  // namespace
}  // namespace tramline
