// What a machine can drive between two poses: each once, by its own name, the quickest first.

#include "tramline/turns/manoeuvres/manoeuvre_choice.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"
#include "turns/expect_manoeuvre.h"

namespace tramline {
namespace {

using testing::expect_leads;
using testing::expect_no_tighter;
using testing::pose;

Machine turning_machine(bool reverses) {
  Machine machine;
  machine.turning.reverse = reverses;
  return machine;
}

int count_of(const std::vector<Manoeuvre>& all, ManoeuvreKind kind) {
  return static_cast<int>(
      std::count_if(all.begin(), all.end(), [&](const Manoeuvre& m) { return m.kind == kind; }));
}

const Pose kEndOfWork = testing::pose(0, 0, 0);

TEST(ManoeuvreChoice, AUIsThereOnceAndUnderItsName) {
  for (const bool reverses : {false, true}) {
    const auto all = manoeuvres_between(kEndOfWork, pose(24, 0, 180), turning_machine(reverses));
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(all.front().kind, ManoeuvreKind::kU);
    EXPECT_EQ(count_of(all, ManoeuvreKind::kU), 1);
    EXPECT_EQ(count_of(all, ManoeuvreKind::kFishtail), 0);
    EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const Manoeuvre& m) { return m.word == "RSR"; }), 1);
  }
}

TEST(ManoeuvreChoice, NearTracksAskForAnOmegaOrAFishtail) {
  const auto onward = manoeuvres_between(kEndOfWork, pose(6, 0, 180), turning_machine(false));
  EXPECT_EQ(onward.front().kind, ManoeuvreKind::kOmega);
  EXPECT_EQ(count_of(onward, ManoeuvreKind::kFishtail) + count_of(onward, ManoeuvreKind::kReedsShepp), 0);
  Machine machine = turning_machine(true);
  const auto both = manoeuvres_between(kEndOfWork, pose(6, 0, 180), machine);
  EXPECT_EQ(count_of(both, ManoeuvreKind::kOmega), 2);  // the other bulges to the other side
  EXPECT_EQ(count_of(both, ManoeuvreKind::kFishtail), 2);
  // π 6/1.5 + 6/1 + 2·3 = 24.6 s against 6 (π + 4 acos(9/12))/1.5 = 24.1 s; without gears to change, less
  const auto first_of = [](const std::vector<Manoeuvre>& all, ManoeuvreKind kind) {
    return std::find_if(all.begin(), all.end(), [&](const Manoeuvre& m) { return m.kind == kind; });
  };
  EXPECT_LT(first_of(both, ManoeuvreKind::kOmega), first_of(both, ManoeuvreKind::kFishtail));
  machine.turning.gear_change_s = 0;
  const auto quick = manoeuvres_between(kEndOfWork, pose(6, 0, 180), machine);
  EXPECT_LT(first_of(quick, ManoeuvreKind::kFishtail), first_of(quick, ManoeuvreKind::kOmega));
}

TEST(ManoeuvreChoice, NothingOnADrawbarIsReversed) {
  Machine machine = turning_machine(true);
  machine.turning.implement = Coupling::kTowed;
  machine.turning.drawbar_m = 3;
  const auto all = manoeuvres_between(kEndOfWork, pose(3, 0, 180), machine);
  ASSERT_FALSE(all.empty());
  for (const Manoeuvre& manoeuvre : all)
    for (const SteeredStretch& stretch : manoeuvre.path)
      EXPECT_EQ(stretch.gear, Gear::kForward) << manoeuvre.word;
}

TEST(ManoeuvreChoice, StaggeredEndsHaveTheLeadAndTheArcs) {
  const auto all = manoeuvres_between(kEndOfWork, pose(24, 5, 180), turning_machine(false));
  std::set<std::string> unequal;
  for (const Manoeuvre& manoeuvre : all)
    if (manoeuvre.kind == ManoeuvreKind::kUnequalArcs) unequal.insert(manoeuvre.word);
  EXPECT_EQ(unequal, (std::set<std::string>{"RSR", "SRSR"}));
}

TEST(ManoeuvreChoice, EqualTimesKeepAStatedOrder) {
  // straight behind: left and right are mirror images
  const auto all = manoeuvres_between(kEndOfWork, pose(0, -20, 0), turning_machine(false));
  ASSERT_GE(all.size(), 2U);
  EXPECT_NEAR(length(all[0].path), length(all[1].path), 1e-9);
  EXPECT_LT(all[0].word, all[1].word);
}

TEST(ManoeuvreChoice, EveryOneLeadsThereAndNoneTwice) {
  std::mt19937_64 random(6);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 200; ++i) {
    const Machine machine = turning_machine(i % 2 == 1);
    const Pose from = pose(between(-20, 20), between(-20, 20), between(0, 360));
    // among them the poses of parallel tracks
    const Pose to = i % 4 < 2
                        ? pose(between(-20, 20), between(-20, 20), between(0, 360))
                        : Pose{from.at + Point{between(-30, 30), between(-5, 5)},
                               Heading::clockwise_from_north(from.heading.angle() + Angle::degrees(180))};
    const auto all = manoeuvres_between(from, to, machine);
    ASSERT_FALSE(all.empty());
    for (std::size_t k = 0; k < all.size(); ++k) {
      expect_leads(all[k], from, to);
      expect_no_tighter(all[k], machine.radius_m);
      EXPECT_TRUE(machine.turning.reverse || gear_changes(all[k]) == 0);
      if (k > 0) {
        EXPECT_LE(seconds(all[k - 1], machine), seconds(all[k], machine) + 1e-6);
      }
      for (std::size_t j = 0; j < k; ++j)
        EXPECT_FALSE(all[j].word == all[k].word &&
                     std::equal(all[j].path.begin(), all[j].path.end(), all[k].path.begin(),
                                all[k].path.end(),
                                [](const SteeredStretch& a, const SteeredStretch& b) {
                                  return std::abs(a.length_m - b.length_m) < 1e-8;
                                }))
            << all[k].word;
      if (HasFailure()) FAIL() << i;
    }
    const auto least = std::min_element(all.begin(), all.end(), [](const Manoeuvre& a, const Manoeuvre& b) {
      return length(a.path) < length(b.path);
    });
    EXPECT_NEAR(length(least->path),
                machine.turning.reverse ? reeds_shepp_length(from, to, machine.radius_m)
                                        : dubins_length(from, to, machine.radius_m),
                1e-7);
  }
}

}  // namespace
}  // namespace tramline
