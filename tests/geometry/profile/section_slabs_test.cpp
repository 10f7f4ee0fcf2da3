#include "tramline/geometry/profile/section_slabs.h"

#include <gtest/gtest.h>

#include "geometry/profile/section_cases.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::section_slabs_test {

using testing::Meeting;
using testing::RandomCase;

struct Slabs {
  SegmentProfile profile;
  SectionBefore before;
};

Slabs slabs_of(const Region& region, const PathSegment& segment, double width, SectionBefore before = {}) {
  const EdgeIndex index(region);
  const SegmentFrame frame(segment, 0.5 * width);
  Slabs out{testing::shape_of(frame), before};
  std::vector<std::size_t> scratch;
  RightEnds right = add_section_parts(index, frame, width, scratch, out.profile);
  add_section_slabs(index, frame, width, std::move(right), out.before, out.profile);
  return out;
}

Region box(double x0, double y0, double x1, double y1) {
  return {{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}}};
}

// North along x = 0 for 30 m, 4 m wide. The land begins at y = 10 and covers the right end only.
TEST(SectionSlabs, AreCutWhereTheRegionBeginsAndEnds) {
  const Slabs found = slabs_of(box(1, 10, 20, 25), {{0, 0}, {0, 30}, 0}, 4);
  const std::vector<SectionSlab>& slabs = found.profile.slabs;
  ASSERT_EQ(slabs.size(), 3U);
  EXPECT_NEAR(slabs[0].to, 10, 1e-9);
  EXPECT_NEAR(slabs[1].to, 25, 1e-9);
  EXPECT_EQ(slabs[0].right_inside, 0);
  EXPECT_EQ(slabs[1].right_inside, 1);
  EXPECT_EQ(slabs[2].right_inside, 0);
  EXPECT_TRUE(slabs[0].parts.empty());
  EXPECT_EQ(slabs[1].parts.size(), 1U) << "the side at x = 1";
  EXPECT_TRUE(slabs[2].parts.empty());
  EXPECT_EQ(found.before.right_inside, 0);
  EXPECT_NEAR(found.before.inside_m, 0, 1e-9);
}

TEST(SectionSlabs, TellInsideFromOutsideWhereNoEdgeIsNear) {
  const Slabs inside = slabs_of(box(-50, -50, 50, 50), {{0, 0}, {0, 30}, 0}, 4);
  ASSERT_EQ(inside.profile.slabs.size(), 1U);
  EXPECT_EQ(inside.profile.slabs[0].from, 0);
  EXPECT_EQ(inside.profile.slabs[0].to, 30);
  EXPECT_EQ(inside.profile.slabs[0].right_inside, 1);
  EXPECT_EQ(inside.before.right_inside, 1);
  EXPECT_NEAR(inside.before.inside_m, 4, 1e-12);
  const Slabs outside = slabs_of(box(-50, -50, 50, -40), {{0, 0}, {0, 30}, 0}, 4);
  ASSERT_EQ(outside.profile.slabs.size(), 1U);
  EXPECT_EQ(outside.profile.slabs[0].right_inside, 0);
  EXPECT_EQ(outside.before.right_inside, 0);
}

// Across an edge that lies along the first cross-section, the length inside jumps: what was there before does
// not go on.
TEST(SectionSlabs, AskTheRegionWhereTheLengthInsideJumps) {
  const Slabs found = slabs_of(box(-50, 0, 50, 50), {{0, 0}, {0, 30}, 0}, 4, {0, 2});
  ASSERT_FALSE(found.profile.slabs.empty());
  EXPECT_EQ(found.profile.slabs.back().right_inside, 1);
  EXPECT_NEAR(found.before.inside_m, 4, 1e-9);
}

// In open land the state and the length inside handed on from before contradict one another.
TEST(SectionSlabs, AskTheRegionWhereTheStateBeforeDoesNotFitTheLengthInside) {
  const Slabs found = slabs_of(box(-50, -50, 50, -40), {{0, 0}, {0, 30}, 0}, 4, {1, 0});
  ASSERT_EQ(found.profile.slabs.size(), 1U);
  EXPECT_EQ(found.profile.slabs[0].right_inside, 0);
  EXPECT_EQ(found.before.right_inside, 0);
}

// A crossing within a touch of the last cross-section may be that of the next segment.
TEST(SectionSlabs, DoNotPassOnWhatACrossingAtTheEndDecides) {
  const Region half = box(-50, -50, 50, 30);
  EXPECT_EQ(slabs_of(half, {{0, 0}, {0, 30}, 0}, 4).before.right_inside, -1);
  EXPECT_EQ(slabs_of(half, {{0, 0}, {0, 29}, 0}, 4).before.right_inside, 1);
  EXPECT_EQ(slabs_of(half, {{0, 0}, {0, 31}, 0}, 4).before.right_inside, 0);
}

TEST(SectionSlabs, HoldWhatEachCrossSectionMeets) {
  std::size_t several = 0;
  for (int number = 0; number < 400; ++number) {
    RandomCase random(number);
    const auto [region, segment, width, frame] = testing::RandomSection(random);
    const Slabs found = slabs_of(region, segment, width);
    const SegmentProfile& profile = found.profile;
    ASSERT_FALSE(profile.slabs.empty());
    EXPECT_EQ(profile.slabs.front().from, 0);
    EXPECT_EQ(profile.slabs.back().to, profile.length);
    for (std::size_t i = 0; i < profile.slabs.size(); ++i) {
      const SectionSlab& slab = profile.slabs[i];
      ASSERT_LT(slab.from, slab.to);
      if (i > 0) {
        EXPECT_EQ(slab.from, profile.slabs[i - 1].to);
      }
      if (slab.to - slab.from < 1e-6) continue;
      const double along = slab.from + random.between(0.1, 0.9) * (slab.to - slab.from);
      EXPECT_EQ(slab.right_inside, contains(region, frame.point_at(along, width)) ? 1 : 0) << along;
      const std::vector<Meeting> expected = testing::meetings_with(EdgeIndex(region), frame, width, along);
      std::vector<double> seen;
      double inside = slab.right_inside * width;
      for (const std::size_t p : slab.parts) {
        seen.push_back(across_at(profile, 0.5 * width, profile.parts[p], along));
        inside += profile.parts[p].sign * seen.back();
      }
      std::sort(seen.begin(), seen.end());
      ASSERT_EQ(seen.size(), expected.size()) << along;
      for (std::size_t k = 0; k < seen.size(); ++k) EXPECT_NEAR(seen[k], expected[k].across, 1e-7);
      EXPECT_NEAR(inside, length_inside(region, frame.point_at(along, 0), frame.point_at(along, width)), 1e-6)
          << along;
    }
    several += profile.slabs.size() > 2;
    const Point left = frame.point_at(profile.length, 0), right = frame.point_at(profile.length, width);
    EXPECT_NEAR(found.before.inside_m, length_inside(region, left, right), 1e-6);
    EXPECT_EQ(found.before.right_inside, contains(region, right) ? 1 : 0);
  }
  EXPECT_GT(several, 50U);
}

// The second half of a line begins with what was inside at the end of the first: it says what the whole says.
TEST(SectionSlabs, GoOnFromTheSegmentBefore) {
  for (int number = 0; number < 100; ++number) {
    RandomCase random(number);
    const Region region = testing::random_region(random);
    const PathSegment whole{random.point_in({-50, -50, 0, 50}), random.point_in({50, -50, 130, 50}), 0};
    const Point middle = midpoint(whole.from, whole.to);
    const SectionBefore first = slabs_of(region, {whole.from, middle, 0}, 3).before;
    const SectionBefore second = slabs_of(region, {middle, whole.to, 0}, 3, first).before;
    const SectionBefore once = slabs_of(region, whole, 3).before;
    EXPECT_EQ(second.right_inside, once.right_inside);
    EXPECT_NEAR(second.inside_m, once.inside_m, 1e-7);
  }
}

}  // namespace tramline::section_slabs_test
