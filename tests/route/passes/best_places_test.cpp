// Places at which passes are entered together, against all places of all passes tried with all others.

#include "tramline/route/passes/best_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <numeric>
#include <vector>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "route/passes/open_land.h"
#include "route/rounded_rectangle.h"
#include "tramline/route/passes/next_pass.h"
#include "tramline/route/passes/pass_tour.h"
#include "tramline/turns/manoeuvres/dubins.h"

namespace tramline {
namespace {

using testing::for_each_seed;

HeadlandPass ring(double half_long_m, double half_wide_m, double radius_m, int number) {
  HeadlandPass out =
      testing::rounded_rectangle(2 * (half_long_m - radius_m), 2 * (half_wide_m - radius_m), radius_m);
  out.number = number;
  out.around_field = true;
  return out;
}

Machine machine_for_passes(std::mt19937_64& random) {
  Machine out;
  out.width_m = uniform(random, 2, 6);
  out.radius_m = uniform(random, 3, 7);
  out.turning.lift_m = out.turning.lower_m = any_of(random, 0, 1) * uniform(random, 0, 2);
  return out;
}

/// Two to four passes round a small field, one inside another, with land to turn on all about.
struct Passes : testing::OpenLand {
  explicit Passes(std::mt19937_64& random) : OpenLand(machine_for_passes(random)) {
    const int count = any_of(random, 2, 4);
    const double inmost_long_m = machine.radius_m + uniform(random, 3, 12),
                 inmost_wide_m = machine.radius_m + uniform(random, 3, 12);
    for (int i = 0; i < count; ++i) {
      const double out_m = (count - 1 - i) * machine.width_m;
      headland.passes.push_back(ring(inmost_long_m + out_m, inmost_wide_m + out_m, machine.radius_m, i + 1));
      all.push_back(static_cast<std::size_t>(i));
    }
    entries = entries_by_pass(headland, machine);
    const double x = uniform(random, -10, 10);
    left = {arc_from({{x, -30}, Heading::from_to({0, 0}, {0, 1})}, 30 + uniform(random, 0, 8), 0,
                     Gear::kForward)};
  }

  SteeredPath left{};
};

/// The least time of all choices of places half a metre apart, s.
double least_of_all_places_s(const Passes& scene, const std::vector<std::size_t>& order) {
  std::vector<Pose> from{end_of(scene.left)};
  std::vector<double> seconds{0};
  for (const std::size_t pass : order) {
    std::vector<Pose> places;
    for (const PassEntry& entry : entries_of(scene.headland.passes[pass], 0.5, scene.machine.turning))
      places.push_back(entry.entered);
    std::vector<double> there(places.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t j = 0; j < from.size(); ++j)
        if (seconds[j] + scene.least.crude(from[j], places[i]) < there[i])
          there[i] = std::min(there[i], seconds[j] + scene.least.forward(from[j], places[i]));
    from = places;
    seconds = there;
  }
  return *std::ranges::min_element(seconds);
}

double seconds_of(const std::vector<WorkedPass>& tour) {
  return std::accumulate(tour.begin(), tour.end(), 0.0,
                         [](double sum, const WorkedPass& worked) { return sum + worked.before.time_s; });
}

/// Every way begins where the pass before was left, and ends where its pass is entered.
void expect_joined(const std::vector<WorkedPass>& tour, const SteeredPath& left) {
  Pose at = end_of(left);
  for (const WorkedPass& worked : tour) {
    ASSERT_FALSE(worked.before.path.empty());
    EXPECT_LT(distance(worked.before.path.front().start.at, at.at), 1e-9);
    EXPECT_LT(distance(end_of(worked.before.path).at, worked.entry.entered.at), 1e-6);
    at = worked.entry.left;
  }
}

TEST(BestPlaces, TakeAboutTheLeastOfAllPlaces) {
  int least = 0, cases = 0;
  for_each_seed(30, [&](std::mt19937_64& random, int) {
    const Passes scene(random);
    const auto tour = at_best_places(scene.task, scene.all, scene.left, 1000);
    const double least_s = least_of_all_places_s(scene, scene.all);
    ++cases;
    if (!tour) return;  // more ways than the search looks for
    expect_joined(*tour, scene.left);
    EXPECT_GE(seconds_of(*tour), least_s - 1e-6);
    EXPECT_LE(seconds_of(*tour), 1.05 * least_s + 0.5);
    if (seconds_of(*tour) < 1.01 * least_s) ++least;
    EXPECT_FALSE(at_best_places(scene.task, scene.all, scene.left, least_s - 1e-6)) << "nothing takes less";
  });
  std::cout << least << " of " << cases << " within 1 % of the least\n";
  if (cases < 30) return;
  EXPECT_GT(2 * least, cases);
}

/// A tour of the passes takes no more than each from the place that is nearest to where the machine is.
TEST(PassTour, EntersPassesWhereTheyTakeLeastTogether) {
  double one_by_one_s = 0, together_s = 0;
  for_each_seed(40, [&](std::mt19937_64& random, int) {
    const Passes scene(random);
    const std::vector<WorkedPass> tour = pass_tour(scene.task, scene.left);
    ASSERT_EQ(tour.size(), scene.all.size());
    expect_joined(tour, scene.left);
    std::vector<bool> worked(scene.all.size(), false);
    for (const WorkedPass& one : tour) worked[one.pass] = true;
    EXPECT_EQ(std::ranges::count(worked, true), static_cast<std::ptrdiff_t>(scene.all.size()));

    double nearest_s = 0;
    std::vector<std::size_t> still = scene.all;
    for (SteeredPath left = scene.left; !still.empty();) {
      PassTask task{scene.headland, scene.entries, still, PassSequence::kAny, scene.connector, scene.least};
      const WorkedPass next = NextPass(task, Foresight::kNone).after(left).pass;
      nearest_s += next.before.time_s;
      left = axle_path(scene.headland.passes[next.pass], next.entry, scene.machine.turning);
      std::erase(still, next.pass);
    }
    EXPECT_LE(seconds_of(tour), nearest_s + 1e-6);
    one_by_one_s += nearest_s;
    together_s += seconds_of(tour);
  });
  std::cout << together_s / one_by_one_s << " of the time of the nearest places\n";
  EXPECT_LT(together_s, 0.97 * one_by_one_s);
}

/// The last pass is left where the gate is near, if the way there is not longer by more.
TEST(PassTour, CountsTheWayToTheGate) {
  double without_s = 0, with_s = 0;
  for_each_seed(40, [&](std::mt19937_64& random, int) {
    const Passes scene(random);
    PassTask task = scene.task;
    const auto to_end_s = [&](const std::vector<WorkedPass>& tour) {
      return seconds_of(tour) + to_gate_s(task, tour.back().entry.left);
    };
    const std::vector<WorkedPass> anywhere = pass_tour(task, scene.left);
    task.gate = Point{uniform(random, -50, 50), uniform(random, 20, 60)};
    const std::vector<WorkedPass> tour = pass_tour(task, scene.left);
    expect_joined(tour, scene.left);
    without_s += to_end_s(anywhere);
    with_s += to_end_s(tour);
  });
  std::cout << with_s / without_s << " of the time to the gate where it does not count\n";
  EXPECT_LT(with_s, 0.97 * without_s);
}

/// What nothing comes before begins at its own beginning, and only others are entered elsewhere.
TEST(PassTour, BeginsAtTheBeginningOfItsFirstPass) {
  for_each_seed(20, [&](std::mt19937_64& random, int) {
    const Passes scene(random);
    const std::vector<WorkedPass> tour = pass_tour(scene.task, {});
    ASSERT_EQ(tour.size(), scene.all.size());
    EXPECT_TRUE(tour.front().before.path.empty());
    const PassEntry& first = scene.entries[tour.front().pass].front();
    EXPECT_EQ(tour.front().entry.entered.at, first.entered.at);
    EXPECT_LT(distance(tour[1].before.path.front().start.at, first.left.at), 1e-9);
  });
}

}  // namespace
}  // namespace tramline
