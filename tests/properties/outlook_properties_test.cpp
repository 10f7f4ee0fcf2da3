// What the sweep leaves unlooked at could not have been the cheapest.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "planner/prepared.h"
#include "properties/random_field.h"
#include "properties/random_scene.h"
#include "properties/seeds.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/search/sweep_search.h"

namespace tramline::outlook_properties_test {

using testing::Scene;

constexpr std::size_t kMostDirections = 14;

double between(std::mt19937_64& random, double a, double b) {
  return std::uniform_real_distribution<double>(a, b)(random);
}

/// A field with a few obstacles to every one that is full of them.
Scene scene_of(std::mt19937_64& random) {
  if (random() % 3 == 0) return testing::random_scene(random);
  Scene scene;
  scene.field = testing::random_field(random, 5);
  scene.machine = {"", between(random, 2, 12), between(random, 0, 8), -1};
  scene.objective = {between(random, 0, 1), between(random, 0, 1), between(random, 0, 3),
                     between(random, 0, 5)};
  scene.settings.end_rule = static_cast<EndRule>(random() % 4);
  scene.settings.boundary = random() % 4 == 0 ? EdgeKind::kHard : EdgeKind::kSoft;
  scene.settings.merge_threshold = Angle::degrees(between(random, 0, 30));
  return scene;
}

/// Candidates of the sweep, evenly taken where there are many, in order.
std::vector<SweptCandidate> some_swept(const SearchTask& task) {
  const std::vector<SweptCandidate> all = swept_candidates(task, SearchContext(1));
  std::vector<SweptCandidate> out;
  const std::size_t step = (all.size() + kMostDirections - 1) / kMostDirections;
  for (std::size_t i = 0; i < all.size(); i += step) out.push_back(all[i]);
  return out;
}

struct Seen {
  int scenes = 0;
  int with_obstacles_met = 0;  ///< by candidates
  int left_out = 0;            ///< candidates that cheapest_swept need not look at
};

void look_at(const SearchTask& task, Seen& seen) {
  const std::vector<SweptCandidate> swept = some_swept(task);
  if (swept.empty()) return;
  ++seen.scenes;
  std::vector<Candidate> candidates;
  for (const SweptCandidate& one : swept) {
    candidates.push_back(candidate_on(task, one.lined_subfields));
    const double cost = candidates.back().cost();
    EXPECT_LE(one.outlook.least, cost + 1e-9 * (1 + std::abs(cost)));
    seen.with_obstacles_met += one.outlook.least < one.outlook.cut ? 1 : 0;
  }
  const auto cheaper = [](const Candidate& a, const Candidate& b) { return is_better(a.avoided, b.avoided); };
  const Candidate& cheapest = *std::min_element(candidates.begin(), candidates.end(), cheaper);
  for (const int threads : {1, 2}) {
    const auto found =
        cheapest_swept(task, swept, std::numeric_limits<double>::infinity(), SearchContext(threads));
    ASSERT_EQ(found.has_value(), cheapest.works());
    if (!found) continue;
    EXPECT_EQ(found->cost(), cheapest.cost());
    ASSERT_EQ(found->subfields.size(), cheapest.subfields.size());
    for (std::size_t i = 0; i < found->subfields.size(); ++i) {
      EXPECT_EQ(found->subfields[i].direction, cheapest.subfields[i].direction);
      EXPECT_EQ(found->subfields[i].shape, cheapest.subfields[i].shape);
      EXPECT_EQ(found->families[i].grid.origin_m, cheapest.families[i].grid.origin_m);
    }
  }
  // What is known already has to be undercut.
  EXPECT_FALSE(cheapest_swept(task, swept, cheapest.cost(), SearchContext(1)));
  for (const SweptCandidate& one : swept) seen.left_out += one.outlook.least > cheapest.cost() ? 1 : 0;
}

TEST(OutlookProperties, NoCandidateCostsLessThanItsOutlookAndTheCheapestIsFound) {
  Seen seen;
  const int cases = testing::case_count(100);
  for (int i = 0; i < cases; ++i) {
    testing::SeededRandom random(i);
    try {
      const Scene scene = scene_of(random);
      const testing::Prepared prepared{{scene.field, scene.machine, scene.objective, scene.settings}};
      look_at(prepared.task(), seen);
    } catch (const Error& error) {
      // A scene without land left is none.
      EXPECT_NE(std::string(error.what()).find("cover the whole field"), std::string::npos) << error.what();
    }
  }
  if (cases < 20) return;  // too few to tell whether scenes are what they should be
  EXPECT_GT(2 * seen.scenes, cases);
  EXPECT_GT(seen.with_obstacles_met, cases);
  EXPECT_GT(seen.left_out, cases);
}

/// 300 × 200 m with a pond of 100 × 100 m in the middle, tracks 6 m wide along y from the left edge on. 16 of
/// them lie in the pond's width altogether. To drive on past it is 100 m longer at least, 24 € of overlap,
/// which no ground left by others repays: each of them is cut, at two stops and a turn, whatever is done.
TEST(Outlook, CountsTheTracksThatAPondCuts) {
  Field field;
  field.outer = {{0, 0}, {300, 0}, {300, 200}, {0, 200}};
  field.obstacles = {{{{{100, 50}, {200, 50}, {200, 150}, {100, 150}}, {}}, ObstacleKind::kObstacle, "pond"}};
  const testing::Prepared prepared{{field, {"", 6, 6, -1}, {}, {}}};
  const SearchTask task = prepared.task();
  const Subfield whole{task.ground.plannable.front(), Direction::clockwise_from_north(Angle::degrees(0))};
  const Outlook outlook = outlook_on(task, {{whole, 0}});
  EXPECT_GE(outlook.least, 16 * (2 * 5 + 0.45));
  EXPECT_LE(outlook.least, candidate_on(task, {{whole, 0}}).cost());
}

}  // namespace tramline::outlook_properties_test
