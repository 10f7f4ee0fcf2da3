#include "tramline/geometry/profile/section_parts.h"

#include <gtest/gtest.h>

#include "geometry/profile/section_cases.h"

namespace tramline::section_parts_test {

using testing::Meeting;
using testing::RandomCase;

constexpr double kPi = std::numbers::pi;

struct Parts {
  SegmentProfile profile;
  RightEnds right;
};

Parts parts_of(const Region& region, const PathSegment& segment, double width) {
  const SegmentFrame frame(segment, 0.5 * width);
  Parts out{testing::shape_of(frame), {}};
  std::vector<std::size_t> scratch;
  out.right = add_section_parts(EdgeIndex(region), frame, width, scratch, out.profile);
  return out;
}

// North along x = 0, 4 m wide: the land west of a line from (3, 0) to (−3, 60) is left at the right end, x =
// 2, at y = 10, and at the left end, x = −2, at y = 50.
const Region kSlope{{{{-30, -20}, {3, -20}, {3, 0}, {-3, 60}, {-30, 60}}, {}}};

TEST(SectionParts, FollowAnEdgeFromEndToEnd) {
  const Parts found = parts_of(kSlope, {{0, -5}, {0, 55}, 0}, 4);
  ASSERT_EQ(found.profile.parts.size(), 1U);
  const SectionPart& part = found.profile.parts[0];
  EXPECT_NEAR(part.from, 15, 1e-9);
  EXPECT_NEAR(part.to, 55, 1e-9);
  EXPECT_NEAR(part.across_from, 4, 1e-9);
  EXPECT_NEAR(part.across_to, 0, 1e-9);
  EXPECT_EQ(part.sign, 1) << "the land is on its left";
  ASSERT_EQ(found.right.crossings.size(), 1U);
  EXPECT_NEAR(found.right.crossings[0].along, 15, 1e-9);
  EXPECT_EQ(found.right.crossings[0].change, -1) << "from there on the right end is outside";
  EXPECT_NEAR(across_at(found.profile, 2, part, 35), 2, 1e-9);
  EXPECT_NEAR(across_at(found.profile, 2, part, 25), 3, 1e-9);
  EXPECT_EQ(across_at(found.profile, 2, part, 5), part.across_from) << "before it, as at its beginning";
  EXPECT_EQ(across_at(found.profile, 2, part, 60), part.across_to);
}

TEST(SectionParts, SeeTheLandOnTheOtherSideOnTheWayBack) {
  const Parts found = parts_of(kSlope, {{0, 55}, {0, -5}, 0}, 4);
  ASSERT_EQ(found.profile.parts.size(), 1U);
  const SectionPart& part = found.profile.parts[0];
  EXPECT_EQ(part.sign, -1);
  EXPECT_NEAR(part.from, 5, 1e-9);
  EXPECT_NEAR(part.to, 45, 1e-9);
  EXPECT_NEAR(part.across_from, 4, 1e-9);
  EXPECT_NEAR(part.across_to, 0, 1e-9);
  ASSERT_EQ(found.right.crossings.size(), 1U);
  EXPECT_NEAR(found.right.crossings[0].along, 5, 1e-9);
  EXPECT_EQ(found.right.crossings[0].change, 1);
}

TEST(SectionParts, AreCutAtTheEndsOfTheSegment) {
  const Parts found = parts_of(kSlope, {{0, 20}, {0, 40}, 0}, 4);
  ASSERT_EQ(found.profile.parts.size(), 1U);
  const SectionPart& part = found.profile.parts[0];
  EXPECT_EQ(part.from, 0);
  EXPECT_EQ(part.to, 20);
  EXPECT_NEAR(part.across_from, 3, 1e-9);
  EXPECT_NEAR(part.across_to, 1, 1e-9);
  EXPECT_TRUE(found.right.crossings.empty());
}

// Half a circle of radius 10 from (10, 0) over (0, 10), 4 m wide, and the land beyond y = 9: about the centre
// its edge is 9 / sin φ away, nearest at the top, where the part is cut in two.
TEST(SectionParts, FollowAnEdgeRoundAnArc) {
  const Parts found = parts_of({{{{-50, 9}, {50, 9}, {50, 50}, {-50, 50}}, {}}}, {{10, 0}, {-10, 0}, 0.1}, 4);
  ASSERT_EQ(found.profile.parts.size(), 2U);
  const double in = std::asin(9 / 12.);
  for (double angle = in + 0.01; angle < kPi - in; angle += 0.05) {
    int seen = 0;
    for (const SectionPart& part : found.profile.parts) {
      if (part.from > 10 * angle || part.to < 10 * angle) continue;
      EXPECT_NEAR(across_at(found.profile, 2, part, 10 * angle), 9 / std::sin(angle) - 8, 1e-9) << angle;
      EXPECT_EQ(part.sign, -1) << "driven against the edge";
      ++seen;
    }
    EXPECT_EQ(seen, 1) << angle;
  }
  std::vector<RightCrossing> crossings = found.right.crossings;
  ASSERT_EQ(crossings.size(), 2U);
  if (crossings[0].along > crossings[1].along) std::swap(crossings[0], crossings[1]);
  EXPECT_NEAR(crossings[0].along, 10 * in, 1e-9);
  EXPECT_EQ(crossings[0].change, 1);
  EXPECT_NEAR(crossings[1].along, 10 * (kPi - in), 1e-9);
  EXPECT_EQ(crossings[1].change, -1);
}

TEST(SectionParts, SayWhereAnEdgeMeetsTheRightEndsOfTheFirstOrLastCrossSection) {
  const auto right_of = [](double from, double to) {
    return parts_of(kSlope, {{0, from}, {0, to}, 0}, 4).right;
  };
  EXPECT_FALSE(right_of(-5, 55).near_start);
  EXPECT_FALSE(right_of(-5, 55).near_end);
  EXPECT_TRUE(right_of(10, 55).near_start) << "x = 2 at y = 10";
  EXPECT_FALSE(right_of(10, 55).near_end);
  EXPECT_FALSE(right_of(-5, 10).near_start);
  EXPECT_TRUE(right_of(-5, 10).near_end);
}

TEST(SectionParts, AreTheEdgesThatEachCrossSectionMeets) {
  int met = 0, beside = 0;
  for (int number = 0; number < 1000; ++number) {
    RandomCase random(number);
    const auto [region, segment, width, frame] = testing::RandomSection(random);
    const Parts found = parts_of(region, segment, width);
    for (int i = 0; i < 20; ++i) {
      const double along = random.between(0, frame.length());
      const std::vector<Meeting> expected = testing::meetings_with(EdgeIndex(region), frame, width, along);
      std::vector<Meeting> seen;
      for (const SectionPart& part : found.profile.parts)
        if (part.from <= along && along <= part.to)
          seen.push_back({across_at(found.profile, 0.5 * width, part, along), part.sign});
      std::sort(seen.begin(), seen.end(),
                [](const Meeting& a, const Meeting& b) { return a.across < b.across; });
      ASSERT_EQ(seen.size(), expected.size()) << along;
      for (std::size_t k = 0; k < seen.size(); ++k) {
        EXPECT_NEAR(seen[k].across, expected[k].across, 1e-7) << along;
        EXPECT_EQ(seen[k].sign, expected[k].sign) << along;
      }
      ++(expected.empty() ? beside : met);
    }
  }
  EXPECT_GT(met, 500);
  EXPECT_GT(beside, 500);
}

TEST(RightEnds, CrossTheBoundaryWhereTheyEnterAndLeave) {
  int crossed = 0;
  for (int number = 0; number < 1000; ++number) {
    RandomCase random(number);
    const auto [region, segment, width, frame] = testing::RandomSection(random);
    const Parts found = parts_of(region, segment, width);
    const int at_start = contains(region, frame.point_at(0, width)) ? 1 : 0;
    for (int i = 0; i < 20; ++i) {
      const double along = random.between(0, frame.length());
      int state = at_start;
      for (const RightCrossing& crossing : found.right.crossings)
        if (crossing.along <= along) state += crossing.change;
      EXPECT_EQ(state, contains(region, frame.point_at(along, width)) ? 1 : 0) << along;
      crossed += state != at_start;
    }
  }
  EXPECT_GT(crossed, 300);
}

}  // namespace tramline::section_parts_test
