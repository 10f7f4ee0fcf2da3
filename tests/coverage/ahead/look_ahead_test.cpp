// What sections come to and when they have to be switched: by hand, and against cross-sections that are
// measured one by one.

#include "tramline/coverage/ahead/look_ahead.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "coverage/tiles/random_drive.h"
#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/geometry/error.h"

namespace tramline::look_ahead_test {

using coverage::look_ahead;
using coverage::Motion;
using coverage::Need;
using coverage::next_switch;
using coverage::Over;
using coverage::SectionAhead;
using coverage::SectionState;
using coverage::Switch;
using coverage::SwitchRule;
using coverage::TileCoverage;
using coverage::WorkedStep;

/// Equal sections from left to right.
Boom boom_of(int sections, double width_m) {
  Boom out;
  for (int i = 0; i < sections; ++i)
    out.push_back({width_m / 2 - width_m * i / sections, width_m / 2 - width_m * (i + 1) / sections});
  return out;
}

Heading to_north() { return Heading::clockwise_from_north(Angle::degrees(0)); }

// The field lies right of the line y = x: a section from x = a to b needs all work until y = a and none from
// y = b on.
class Slanted : public ::testing::Test {
 protected:
  Region field_{{{{0, 0}, {100, 0}, {100, 100}}, {}}};
  TileCoverage coverage_{field_, {}};
  Motion motion_{{50, 10}, to_north(), 2};
  Boom boom_ = boom_of(4, 12);  // 44–47, 47–50, 50–53, 53–56
};

TEST_F(Slanted, EachSectionEndsByItself) {
  SwitchRule rule;
  rule.horizon_s = 25;
  const auto ahead = look_ahead(coverage_, field_, motion_, boom_, {4, SectionState{true, {}}}, rule);
  const double middles[] = {45.5, 48.5, 51.5, 54.5};
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_TRUE(ahead[i].next) << i;
    EXPECT_FALSE(ahead[i].next->on);
    EXPECT_NEAR(ahead[i].next->ahead_m, middles[i] - 10, 1e-6);
    EXPECT_NEAR(ahead[i].next->effect_s, (middles[i] - 10) / 2, 1e-6);
    EXPECT_DOUBLE_EQ(ahead[i].need, 1);
    EXPECT_EQ(ahead[i].over, Over::kOpen);
    EXPECT_EQ(ahead[i].next_over, Over::kOutside);
  }
}

TEST_F(Slanted, ThresholdsAndLatencies) {
  SwitchRule rule;
  rule.horizon_s = 25;
  rule.off_below = 0.25;  // three quarters of 44–47 are outside: y = 46.25
  rule.off_latency_s = 1.5;
  const auto ahead = look_ahead(coverage_, field_, motion_, boom_, {4, SectionState{true, {}}}, rule);
  ASSERT_TRUE(ahead[0].next);
  EXPECT_NEAR(ahead[0].next->ahead_m, 36.25, 1e-6);
  EXPECT_NEAR(ahead[0].next->command_s, 36.25 / 2 - 1.5, 1e-6);
}

TEST_F(Slanted, WhatIsTooLateIsCommandedNow) {
  motion_.position = {50, 46};  // the left section lost half of its width half a metre back
  SwitchRule rule;
  rule.off_latency_s = 0.5;
  const auto ahead = look_ahead(coverage_, field_, motion_, boom_, {4, SectionState{true, {}}}, rule);
  ASSERT_TRUE(ahead[0].next);
  EXPECT_DOUBLE_EQ(ahead[0].next->command_s, 0);
  EXPECT_DOUBLE_EQ(ahead[0].next->effect_s, 0.5);
  EXPECT_NEAR(ahead[0].need, 1.0 / 3, 1e-3);  // a millimetre ahead
}

TEST_F(Slanted, ACommandUnderWayIsNotGivenAgain) {
  SwitchRule rule;
  rule.horizon_s = 25;
  const SectionState turning_off{true, 0.3};
  const auto ahead = look_ahead(coverage_, field_, motion_, boom_, {4, turning_off}, rule);
  ASSERT_TRUE(ahead[0].next);
  EXPECT_TRUE(ahead[0].next->on) << "there is work until the slanted edge: it has to be switched on again";
  EXPECT_NEAR(ahead[0].next->effect_s, 0.3, 1e-9) << "no earlier than it is off";
}

TEST_F(Slanted, AMachineThatStandsSwitchesNothingAndKnowsWhatItStandsOver) {
  motion_.speed_mps = 0;
  motion_.position = {50, 60};
  const auto ahead = look_ahead(coverage_, field_, motion_, boom_, {4, SectionState{true, {}}}, {});
  for (const SectionAhead& section : ahead) {
    EXPECT_FALSE(section.next);
    EXPECT_DOUBLE_EQ(section.need, 0);
    EXPECT_EQ(section.over, Over::kOutside);
  }
}

// 100 m square with a pond from y = 30 to 40, worked from y = 60 to 70.
TEST(LookAhead, PondsAndWorkedGroundAreToldApart) {
  const Region field{{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{{40, 30}, {40, 40}, {60, 40}, {60, 30}}}}};
  TileCoverage engine(field, {});
  engine.add({{{{{0, 60}, {100, 60}, {100, 70}, {0, 70}}}}, 0, 10, 10, 0});
  SwitchRule rule;
  rule.horizon_s = 60;
  const Boom boom = boom_of(1, 6);
  const auto at = [&](double y, bool on) {
    return look_ahead(engine, field, {{50, y}, to_north(), 2}, boom, {{on, {}}}, rule).front();
  };
  const SectionAhead before_pond = at(10, true);
  ASSERT_TRUE(before_pond.next);
  EXPECT_NEAR(before_pond.next->ahead_m, 20, 1e-6);
  EXPECT_EQ(before_pond.next_over, Over::kObstacle);
  const SectionAhead over_pond = at(35, false);
  ASSERT_TRUE(over_pond.next);
  EXPECT_EQ(over_pond.over, Over::kObstacle);
  EXPECT_TRUE(over_pond.next->on);
  EXPECT_NEAR(over_pond.next->ahead_m, 5, 1e-6);
  const SectionAhead behind_pond = at(45, true);
  ASSERT_TRUE(behind_pond.next);
  EXPECT_NEAR(behind_pond.next->ahead_m, 15, 1e-6);
  EXPECT_EQ(behind_pond.next_over, Over::kWorked);
  const SectionAhead over_worked = at(65, false);
  EXPECT_EQ(over_worked.over, Over::kWorked);
  ASSERT_TRUE(over_worked.next);
  EXPECT_NEAR(over_worked.next->ahead_m, 5, 1e-6);
}

// Between the thresholds a section stays as it is: half of it lies over worked ground all the way.
TEST(LookAhead, BetweenTheThresholdsNothingIsSwitched) {
  TileCoverage engine({}, {});
  engine.add({{{{{-3, 0}, {0, 0}, {0, 100}, {-3, 100}}}}, 0, 100, 3, 0});
  SwitchRule rule;
  rule.on_from = 0.6;
  rule.off_below = 0.4;
  for (const bool on : {false, true}) {
    const auto ahead =
        look_ahead(engine, {}, {{0, 5}, to_north(), 3}, boom_of(1, 6), {{on, {}}}, rule).front();
    EXPECT_NEAR(ahead.need, 0.5, 1e-6);
    EXPECT_FALSE(ahead.next) << on;
  }
}

TEST(LookAhead, RulesThatMakeNoSenseAreRefused) {
  const auto refused = [](double on, double off, double latency_s, double horizon_s) {
    EXPECT_REFUSED(coverage::require_sensible({on, off, latency_s, 0, horizon_s})) << on << ' ' << off;
  };
  refused(0.4, 0.5, 0, 5);
  refused(0.5, 0, 0, 5);
  refused(1.1, 0.5, 0, 5);
  refused(NAN, 0.5, 0, 5);
  refused(0.5, 0.5, -1, 5);
  refused(0.5, 0.5, 5, 5);
  EXPECT_NO_THROW(coverage::require_sensible({}));
}

// --- against cross-sections measured one by one --------------------------------------------------

bool open_at(const testing::Drive& drive, Point p) {
  if (!drive.field.empty() && !contains(drive.field, p)) return false;
  return std::none_of(drive.steps.begin(), drive.steps.end(), [&](const WorkedStep& step) {
    return std::any_of(step.quads.begin(), step.quads.end(), [&](const coverage::Quad& quad) {
      return contains(Ring(quad.begin(), quad.end()), p);
    });
  });
}

void add_crossings(const Ring& ring, Point from, Point to, std::vector<double>& out) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const double side_a = cross(to - from, a - from), side_b = cross(to - from, b - from);
    if ((side_a > 0) == (side_b > 0)) continue;
    const Point p = a + side_a / (side_a - side_b) * (b - a);
    const double t = dot(p - from, to - from) / dot(to - from, to - from);
    if (t > 0 && t < 1) out.push_back(t);
  }
}

/// Share of the line between two points that lies over open ground.
double open_share(const testing::Drive& drive, Point from, Point to) {
  std::vector<double> places{0, 1};
  for (const Ring& ring : rings_of(drive.field)) add_crossings(ring, from, to, places);
  for (const WorkedStep& step : drive.steps)
    for (const coverage::Quad& quad : step.quads)
      add_crossings(Ring(quad.begin(), quad.end()), from, to, places);
  std::sort(places.begin(), places.end());
  double share = 0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    if (open_at(drive, from + 0.5 * (places[i] + places[i + 1]) * (to - from)))
      share += places[i + 1] - places[i];
  return share;
}

struct Scene {
  testing::Drive drive;
  Motion motion;
  Boom boom;
  SwitchRule rule;
};

Scene random_scene(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Scene out{testing::random_drive(random, 30, 50), {}, {}, {}};
  const auto step = std::uniform_int_distribution<std::size_t>(0, out.drive.steps.size() - 1)(random);
  const std::vector<coverage::Quad>& quads = out.drive.steps[step].quads;
  const Point near = quads.empty() ? Point{} : quads.front()[0];
  out.motion = {near + Point{uniform(-10, 10), uniform(-10, 10)},
                Heading::clockwise_from_north(Angle::degrees(uniform(0, 360))), uniform(0.5, 6)};
  out.boom = boom_of(std::uniform_int_distribution<int>(1, 9)(random), uniform(1, 24));
  out.rule.on_from = uniform(0.02, 1);
  out.rule.off_below = uniform(0.01, out.rule.on_from);
  out.rule.on_latency_s = uniform(0, 1);
  out.rule.off_latency_s = uniform(0, 1);
  out.rule.horizon_s = uniform(1.1, 4);
  return out;
}

template <class Check>
void for_random_scenes(int standard, Check check) {
  testing::for_each_seed(standard, [&](std::mt19937_64& random, int) {
    const Scene scene = random_scene(random);
    if (scene.drive.steps.empty()) return;
    TileCoverage engine(scene.drive.field, {});
    for (const WorkedStep& step : scene.drive.steps) engine.add(step);
    check(scene, engine, random);
  });
}

/// Of a section, at a distance ahead.
double measured(const Scene& scene, const Section& section, double ahead_m) {
  const Point ahead = scene.motion.heading.unit(), left{-ahead.y, ahead.x};
  const Point middle = scene.motion.position + ahead_m * ahead;
  return open_share(scene.drive, middle + section.right_m * left, middle + section.left_m * left);
}

// Where edges lie across the way the share jumps: two places a hundredth of a millimetre apart enclose it.
constexpr double kAside_m = 1e-5;

TEST(LookAheadProperties, NeedIsWhatEveryCrossSectionMeasures) {
  int partly = 0;
  for_random_scenes(400, [&](const Scene& scene, const TileCoverage& engine, std::mt19937_64& random) {
    const double reach_m = scene.motion.speed_mps * scene.rule.horizon_s;
    const std::vector<Need> needs = coverage::need_ahead(engine, scene.motion, scene.boom, reach_m);
    ASSERT_EQ(needs.size(), scene.boom.size());
    for (std::size_t i = 0; i < needs.size(); ++i) {
      const Need& need = needs[i];
      ASSERT_FALSE(need.empty());
      EXPECT_DOUBLE_EQ(need.front().from_m, 0);
      EXPECT_NEAR(need.back().to_m, reach_m, 1e-8);
      for (std::size_t k = 0; k + 1 < need.size(); ++k) EXPECT_EQ(need[k].to_m, need[k + 1].from_m);
      for (int sample = 0; sample < 8; ++sample) {
        const double ahead_m = std::uniform_real_distribution<double>(0, reach_m)(random);
        const auto stretch =
            std::find_if(need.begin(), need.end(), [&](const auto& s) { return s.to_m > ahead_m; });
        ASSERT_NE(stretch, need.end());
        const double before = measured(scene, scene.boom[i], ahead_m - kAside_m),
                     behind = measured(scene, scene.boom[i], ahead_m + kAside_m);
        EXPECT_GE(stretch->at(ahead_m), std::min(before, behind) - 1e-4) << ahead_m;
        EXPECT_LE(stretch->at(ahead_m), std::max(before, behind) + 1e-4) << ahead_m;
        if (before > 0.01 && before < 0.99) ++partly;
      }
    }
  });
  EXPECT_GT(partly, testing::case_count(400));
}

/// Drives on in steps of 5 mm and switches as the rule says: none sooner, and one where the switch is.
void expect_simulated(const Scene& scene, std::size_t section, const SectionState& state,
                      const std::optional<Switch>& found) {
  constexpr double kStep_m = 5e-3;
  const SwitchRule& rule = scene.rule;
  const bool on = state.commanded();
  const double latency_s = on ? rule.off_latency_s : rule.on_latency_s;
  const double from_m = std::max(coverage::kUnderfoot_m,
                                 scene.motion.speed_mps * std::max(latency_s, state.turning_s.value_or(0)));
  const double reach_m = scene.motion.speed_mps * rule.horizon_s;
  const double until_m = found ? found->ahead_m - kAside_m : reach_m;
  const auto asks = [&](double ahead_m, double margin) {
    const double share = measured(scene, scene.boom[section], ahead_m);
    return on ? share < rule.off_below - margin : share >= rule.on_from + margin;
  };
  for (double ahead_m = from_m; ahead_m < until_m; ahead_m += kStep_m)
    ASSERT_FALSE(asks(ahead_m, 1e-5) && asks(ahead_m + kAside_m, 1e-5) && asks(ahead_m - kAside_m, 1e-5))
        << "section " << section << " asks " << ahead_m << " m ahead already";
  if (!found) return;
  EXPECT_EQ(found->on, !on);
  EXPECT_GE(found->ahead_m, from_m - 1e-9);
  EXPECT_NEAR(found->effect_s, found->ahead_m / scene.motion.speed_mps, 1e-12);
  EXPECT_NEAR(found->command_s, std::max(0.0, found->effect_s - latency_s), 1e-12);
  EXPECT_TRUE(asks(found->ahead_m, -1e-5) || asks(found->ahead_m + kAside_m, -1e-5) ||
              asks(found->ahead_m - kAside_m, -1e-5))
      << "section " << section << " does not ask " << found->ahead_m << " m ahead";
}

TEST(LookAheadProperties, SwitchesAreThoseOfASimulatedDrive) {
  int switched = 0, kept = 0;
  for_random_scenes(300, [&](const Scene& scene, const TileCoverage& engine, std::mt19937_64& random) {
    std::vector<SectionState> states;
    for (std::size_t i = 0; i < scene.boom.size(); ++i) {
      states.push_back({std::bernoulli_distribution(0.5)(random), {}});
      if (std::bernoulli_distribution(0.3)(random))
        states.back().turning_s = std::uniform_real_distribution<double>(0, 1)(random);
    }
    const auto ahead = look_ahead(engine, scene.drive.field, scene.motion, scene.boom, states, scene.rule);
    ASSERT_EQ(ahead.size(), scene.boom.size());
    for (std::size_t i = 0; i < ahead.size(); ++i) {
      expect_simulated(scene, i, states[i], ahead[i].next);
      ++(ahead[i].next ? switched : kept);
    }
  });
  EXPECT_GT(switched, testing::case_count(300) / 4);
  EXPECT_GT(kept, testing::case_count(300) / 4);
}

}  // namespace tramline::look_ahead_test
