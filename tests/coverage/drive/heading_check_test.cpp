// Headings of logs against the way driven.

#include "tramline/coverage/drive/heading_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "coverage/logs.h"
#include "tramline/coverage/evaluate.h"

namespace tramline::coverage {
namespace {

using namespace testing_logs;

Heading compass(double degrees) { return Heading::clockwise_from_north(Angle::degrees(degrees)); }

/// Fixes joined to one another, but for the first.
std::optional<HeadingContradiction> found_in(const std::vector<Fix>& fixes,
                                             HeadingReading reading = HeadingReading::kCompass) {
  HeadingCheck check;
  for (std::size_t i = 0; i < fixes.size(); ++i)
    check.add(fixes[i], i == 0 ? Continuity::kBroken : Continuity::kJoined);
  return check.contradiction(reading);
}

/// Round a square of 20 m, from its south-western corner to the east first, 1 m and 1 s to a fix; `heading`
/// makes the heading logged from the compass heading of the side driven. 81 fixes.
template <class Logged>
std::vector<Fix> round_a_square(Logged heading) {
  std::vector<Fix> out;
  Point at{0, 0};
  const auto add = [&](double compass_deg) {
    Fix next = fix(static_cast<double>(out.size()), at, heading(compass_deg));
    next.record = out.size() + 1;
    out.push_back(next);
  };
  add(90);
  for (const auto& [way, compass_deg] :
       {std::pair{Point{1, 0}, 90.0}, {Point{0, 1}, 0.0}, {Point{-1, 0}, 270.0}, {Point{0, -1}, 180.0}})
    for (int i = 0; i < 20; ++i) {
      at = at + way;
      add(compass_deg);
    }
  return out;
}

TEST(HeadingCheck, MathematicalAngles) {
  Fix one;
  const auto as_compass = [&](double logged_deg) {
    one.heading = compass(logged_deg);
    return heading_read_as(HeadingReading::kMath, one);
  };
  const auto same = [](Heading a, Heading b) { return distance(a.unit(), b.unit()) < 1e-12; };
  EXPECT_TRUE(same(as_compass(0), compass(90)));     // east
  EXPECT_TRUE(same(as_compass(90), compass(0)));     // north
  EXPECT_TRUE(same(as_compass(180), compass(270)));  // west
  EXPECT_TRUE(same(as_compass(210), compass(240)));
  EXPECT_TRUE(std::isnan(heading_read_as(HeadingReading::kFromTrack, one).degrees()));
  one.heading = Heading{};
  EXPECT_TRUE(std::isnan(heading_read_as(HeadingReading::kMath, one).degrees()));
}

TEST(HeadingCheck, AQuarterTurnContradictsAndBackingDoesNot) {
  for (const double off_deg : {0.0, 44.0, 136.0, 180.0, 224.0, 316.0})
    EXPECT_FALSE(contradicts(compass(30), compass(30 + off_deg))) << off_deg;
  for (const double off_deg : {46.0, 90.0, 134.0, 226.0, 270.0, 314.0})
    EXPECT_TRUE(contradicts(compass(30), compass(30 + off_deg))) << off_deg;
}

// Along the axes the two readings are a quarter turn apart to the east and the west, and to the north and the
// south: all 80 steps are off.
TEST(HeadingCheck, MathematicalAnglesAreFound) {
  const std::vector<Fix> fixes = round_a_square([](double compass_deg) { return 90 - compass_deg; });
  const auto found = found_in(fixes);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->read_as, "compass");
  EXPECT_EQ(found->steps, 80U);
  EXPECT_EQ(found->off, 80U);
  EXPECT_EQ(found->better, "math");
  EXPECT_EQ(found->better_off, 0U);
  EXPECT_EQ(found->record, 2U);
  EXPECT_EQ(found->time_s, 1);
  EXPECT_EQ(found->at, (Point{1, 0}));
  EXPECT_FALSE(found_in(fixes, HeadingReading::kMath));
  EXPECT_FALSE(found_in(fixes, HeadingReading::kFromTrack));
  EXPECT_EQ(warning_on(*found, Clock::kUtc),
            "the headings of the log contradict the way driven: 80 of 80 steps (100 %) are more than 45° "
            "off, first at record 2 at 00:00:01; read as angles anticlockwise from east, 80 of 80 agree: "
            "give --headings math");
}

TEST(HeadingCheck, AndSoAreCompassAnglesReadAsMathematicalOnes) {
  const std::vector<Fix> fixes = round_a_square([](double compass_deg) { return compass_deg; });
  EXPECT_FALSE(found_in(fixes));
  const auto found = found_in(fixes, HeadingReading::kMath);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->better, "compass");
  EXPECT_EQ(found->off, 80U);
}

// 4 of 80 are 5 %, no more: nothing is said. 5 are.
TEST(HeadingCheck, AFewAreNoContradiction) {
  for (const int wrong : {4, 5}) {
    std::vector<Fix> fixes = round_a_square([](double compass_deg) { return compass_deg; });
    for (int i = 0; i < wrong; ++i) fixes[static_cast<std::size_t>(5 + i)].heading = compass(0);
    const auto found = found_in(fixes);
    ASSERT_EQ(found.has_value(), wrong == 5);
    if (!found) continue;
    EXPECT_EQ(found->off, 5U);
    EXPECT_EQ(found->record, 6U);
    EXPECT_EQ(found->better, "from-track") << "mathematical angles fit even less";
    EXPECT_NE(warning_on(*found, Clock::kNone).find("give --headings from-track"), std::string::npos);
  }
}

TEST(HeadingCheck, NineStepsAreTooFew) {
  for (const int steps : {9, 10}) {
    std::vector<Fix> fixes;
    for (int i = 0; i <= steps; ++i) fixes.push_back(fix(i, {1.0 * i, 0}, 0));
    EXPECT_EQ(found_in(fixes).has_value(), steps == 10);
  }
}

TEST(HeadingCheck, BackingIsNoContradiction) {
  EXPECT_FALSE(found_in(round_a_square([](double compass_deg) { return compass_deg + 180; })));
}

TEST(HeadingCheck, StandingAndCreepingTellNothing) {
  const std::uint64_t seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<> angle(0, 360), noise(-0.1, 0.1);
  std::vector<Fix> standing, creeping;
  for (int i = 0; i < 500; ++i) {
    standing.push_back(fix(i, {noise(random), noise(random)}, angle(random)));
    creeping.push_back(fix(i, {0.3 * i, 0}, angle(random)));  // 0.3 m/s
  }
  EXPECT_FALSE(found_in(standing));
  EXPECT_FALSE(found_in(creeping));
  for (Fix& one : creeping) one.time_s /= 2;  // 0.6 m/s
  EXPECT_TRUE(found_in(creeping));
}

// At 10 Hz a step of the log is 10 cm: ten of them are one here.
TEST(HeadingCheck, ShortStepsAreTakenTogether) {
  std::vector<Fix> fixes;
  for (int i = 0; i <= 200; ++i) fixes.push_back(fix(0.1 * i, {0.125 * i, 0}, 0));
  const auto found = found_in(fixes);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->steps, 25U);  // 25 m in steps of 1 m
  EXPECT_EQ(found->off, 25U);
}

TEST(HeadingCheck, NothingIsComparedAcrossABreak) {
  HeadingCheck check;
  for (int i = 0; i < 100; ++i) check.add(fix(i, {2.0 * i, 0}, 0), Continuity::kBroken);
  EXPECT_FALSE(check.contradiction(HeadingReading::kCompass));
}

/// In curves over the plane, 1 to 3 m to a step; headings clockwise from north.
WorkLog curves(std::mt19937_64& random) {
  std::uniform_real_distribution<> turn(-15, 15), step(1, 3);
  std::vector<Fix> out;
  Point at{0, 0};
  double heading_deg = 10;
  for (int i = 0; i < 200; ++i) {
    out.push_back(fix(i, at, heading_deg));
    out.back().record = static_cast<std::size_t>(i) + 1;
    heading_deg += turn(random);
    at = at + step(random) * compass(heading_deg).unit();
  }
  return log(std::move(out), 4);
}

// Whatever the headings are called, the land is the same; and without them it is what a log without has.
TEST(HeadingCheck, TheReadingGivesTheLand) {
  const std::uint64_t seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  for (int round = 0; round < 10; ++round) {
    const WorkLog right = curves(random);
    WorkLog math = right, none = right;
    for (Fix& one : math.fixes)
      one.heading = Heading::clockwise_from_north(Angle::degrees(90) - one.heading.angle());
    for (Fix& one : none.fixes) one.heading = Heading{};
    EvaluateSettings settings;
    const Coverage wanted = evaluate(right, {}, settings, {}), without = evaluate(none, {}, settings, {}),
                   misread = evaluate(math, {}, settings, {});
    settings.drive.headings = HeadingReading::kMath;
    const Coverage as_math = evaluate(math, {}, settings, {});
    settings.drive.headings = HeadingReading::kFromTrack;
    const Coverage ignored = evaluate(math, {}, settings, {});
    EXPECT_NEAR(as_math.areas.covered_m2, wanted.areas.covered_m2, 1e-6 * wanted.areas.covered_m2);
    EXPECT_EQ(ignored.areas.covered_m2, without.areas.covered_m2);
    EXPECT_EQ(wanted.warnings, without.warnings);
    EXPECT_EQ(as_math.warnings, wanted.warnings);
    EXPECT_FALSE(as_math.headings || ignored.headings || wanted.headings);
    ASSERT_TRUE(misread.headings) << "the curves go everywhere";
    EXPECT_EQ(misread.headings->better, "math");
    EXPECT_EQ(misread.headings->steps, 199U);
    EXPECT_LT(misread.areas.covered_m2, wanted.areas.covered_m2);
  }
}

}  // namespace
}  // namespace tramline::coverage
