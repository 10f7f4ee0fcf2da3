// The shortest words of random poses against those of OMPL, the Open Motion Planning Library.

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <memory>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "tramline/turns/manoeuvres/driven_word.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/manoeuvre_choice.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"
#include "turns/expect_manoeuvre.h"

namespace tramline {
namespace {

using testing::expect_leads;
using testing::expect_no_tighter;

template <class Space>
double distance_by(const Pose& from, const Pose& to, double radius_m) {
  const auto space = std::make_shared<Space>(radius_m);
  ompl::base::ScopedState<Space> a(space), b(space);
  for (auto [state, pose] : {std::pair{&a, &from}, std::pair{&b, &to}}) {
    const testing::DrivenPose driven = testing::driven_pose(*pose);
    (*state)->setXY(driven.x, driven.y);
    (*state)->setYaw(std::remainder(driven.angle, 2 * std::numbers::pi));
  }
  return space->distance(a.get(), b.get());
}

struct PosePair {
  Pose from, to;
  double radius_m;
};

/// Poses anywhere, of parallel tracks, and such that differ by round numbers.
PosePair random_poses(std::mt19937_64& random) {
  const double size = std::exp(uniform(random, -1, 5));
  const auto anywhere = [&] {
    return testing::pose(uniform(random, -size, size), uniform(random, -size, size), uniform(random, 0, 360));
  };
  PosePair out{anywhere(), anywhere(), std::exp(uniform(random, 0, 3))};
  switch (any_of(random, 0, 3)) {
    case 0:
      out.to.heading = Heading::clockwise_from_north(out.from.heading.angle() +
                                                     Angle::degrees(any_of(random, 0, 1) * 180.0));
      break;
    case 1:
      out.radius_m = any_of(random, 1, 4);
      out.from = testing::pose(any_of(random, -9, 9), any_of(random, -9, 9), 30 * any_of(random, 0, 11));
      out.to = testing::pose(any_of(random, -9, 9), any_of(random, -9, 9), 30 * any_of(random, 0, 11));
      break;
    default:
      break;
  }
  return out;
}

/// Ours is as long as theirs, or it is shorter and right.
void expect_no_longer(double length_m, double theirs_m, double scale_m, int& shorter) {
  EXPECT_LE(length_m, theirs_m + 1e-8 * scale_m);
  if (length_m < theirs_m - 1e-8 * scale_m) ++shorter;
}

TEST(WordsProperties, ShortestWaysAreNoLongerThanThoseOfOmpl) {
  int shorter_dubins = 0, shorter_both = 0;
  testing::for_each_seed(3000, [&](std::mt19937_64& random, int) {
    const auto [from, to, radius_m] = random_poses(random);
    const double scale = distance(from.at, to.at) + radius_m;
    const Manoeuvre forward = shortest_dubins(from, to, radius_m),
                    both = shortest_reeds_shepp(from, to, radius_m);
    expect_no_longer(length(forward.path), distance_by<ompl::base::DubinsStateSpace>(from, to, radius_m),
                     scale, shorter_dubins);
    expect_no_longer(length(both.path), distance_by<ompl::base::ReedsSheppStateSpace>(from, to, radius_m),
                     scale, shorter_both);
    for (const Manoeuvre* word : {&forward, &both}) {
      expect_leads(*word, from, to, 600);
      expect_no_tighter(*word, radius_m);
    }
    EXPECT_NEAR(dubins_length(from, to, radius_m), length(forward.path), 1e-9 * scale + 1e-7);
    EXPECT_NEAR(reeds_shepp_length(from, to, radius_m), length(both.path), 1e-9 * scale + 1e-7);
    EXPECT_LE(least_length(from, to, radius_m), length(both.path) + 1e-9 * scale + 1e-7);
  });
  RecordProperty("shorter_than_dubins_of_ompl", shorter_dubins);
  RecordProperty("shorter_than_reeds_shepp_of_ompl", shorter_both);
  if (std::getenv("TRAMLINE_CASES") != nullptr)
    std::printf("shorter than OMPL: %d Dubins, %d Reeds-Shepp\n", shorter_dubins, shorter_both);
}

/// The turn that a path begins with, or ends with, m: positive to the left; 0 for a line.
double turned_m(const SteeredStretch& stretch) {
  return stretch.curvature_at_start == 0 ? 0 : std::copysign(stretch.length_m, stretch.curvature_at_start);
}

/// Words that are not built yet say how they begin and end, and once built are those of dubins_words().
TEST(WordsProperties, WordsKnowTheirEndsBeforeTheyAreBuilt) {
  int words = 0, lines = 0, joined = 0;
  testing::for_each_seed(1000, [&](std::mt19937_64& random, int) {
    const auto [from, to, radius_m] = random_poses(random);
    const DubinsWords unbuilt(from, to, radius_m);
    std::vector<Manoeuvre> built;
    for (std::size_t i = 0; i < unbuilt.size(); ++i) {
      built.push_back(unbuilt.built(i));
      const SteeredPath& path = built.back().path;
      if (path.empty()) continue;
      ++words;
      const auto [first_m, last_m] = unbuilt.ends(i);
      const double first = turned_m(path.front()), last = turned_m(path.back());
      if (path.size() == 1 && first != 0 && std::abs(first_m - first) > 1e-6 * radius_m) {
        ++joined;
        EXPECT_LE(std::abs(first_m), std::abs(first));
        EXPECT_LE(std::abs(last_m), std::abs(last));
        EXPECT_NEAR(first_m + last_m, first, 1e-6 * radius_m);
        continue;
      }
      // Turns by less than rounding are left out of what is built.
      EXPECT_NEAR(first_m, first, 1e-9 * radius_m) << built.back().word;
      EXPECT_NEAR(last_m, path.size() == 1 ? last_m : last, 1e-9 * radius_m) << built.back().word;
      lines += first == 0 || last == 0 ? 1 : 0;
    }
    drop_repeated(built);
    const std::vector<Manoeuvre> expected = dubins_words(from, to, radius_m);
    ASSERT_EQ(built.size(), expected.size());
    for (std::size_t i = 0; i < built.size(); ++i) {
      EXPECT_EQ(built[i].word, expected[i].word);
      EXPECT_EQ(length(built[i].path), length(expected[i].path));
    }
  });
  if (testing::case_count(1000) < 1000) return;
  EXPECT_GT(words, 3000);
  EXPECT_GT(lines, 0);
  RecordProperty("joined", joined);
}

TEST(WordsProperties, EveryManoeuvreOfAMachineIsRight) {
  testing::for_each_seed(150, [&](std::mt19937_64& random, int) {
    auto [from, to, radius_m] = random_poses(random);
    Machine machine;
    machine.radius_m = radius_m;
    machine.turning.reverse = any_of(random, 0, 1) == 1;
    machine.turning.steering_time_s = any_of(random, 0, 1) * uniform(random, 0, 4);
    const double sharpness = 1 / (radius_m * machine.turning.steering_time_s);
    const std::vector<Manoeuvre> all = manoeuvres_between(from, to, machine);
    if (machine.turning.steering_time_s == 0) {
      EXPECT_FALSE(all.empty());
    }
    for (const Manoeuvre& manoeuvre : all) {
      expect_leads(manoeuvre, from, to, 1000);
      expect_no_tighter(manoeuvre, radius_m);
      if (machine.turning.steering_time_s > 0)
        testing::expect_steerable(manoeuvre, sharpness / machine.turning.turning_speed_mps,
                                  sharpness / machine.turning.reverse_speed_mps);
      // no faster than a straight line, no shorter than the shortest of its kind
      EXPECT_GE(length(manoeuvre.path), (machine.turning.reverse ? reeds_shepp_length(from, to, radius_m)
                                                                 : dubins_length(from, to, radius_m)) -
                                            1e-7);
    }
  });
}

}  // namespace
}  // namespace tramline
