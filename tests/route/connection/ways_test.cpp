// Ways between ends: turns against all straight ways tried one after the other, and words against all words
// tried for room.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <vector>

#include "properties/draws.h"
#include "properties/random_field.h"
#include "properties/seeds.h"
#include "route/tracks_to_join.h"
#include "tramline/route/connection/arc_room.h"
#include "tramline/route/connection/unreachable.h"
#include "tramline/route/turning/planned_turns.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/outline/outline.h"

namespace tramline {
namespace {

using testing::for_each_seed;
using testing::TracksToJoin;

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

}  // namespace
}  // namespace tramline
