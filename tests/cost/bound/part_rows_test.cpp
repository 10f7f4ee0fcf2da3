// Rows of a strip: the parts that pass each by looking at all of them, its length inside by polygon booleans.

#include "tramline/cost/bound/part_rows.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/geometry/interval.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

struct Listed {
  double from, to, inside_from, inside_to;
  std::set<const BoundaryPart*> parts;
};

std::vector<Listed> listed(PartRows& rows, std::span<const BoundaryPart> parts, double width_m,
                           std::span<const double> cuts = {}) {
  std::vector<Listed> out;
  rows.for_each(parts, width_m, cuts, [&out](const PartRow& row) {
    out.push_back({row.from, row.to, row.inside_from, row.inside_to, {row.parts.begin(), row.parts.end()}});
  });
  return out;
}

// The region lies left of a line that runs from x = −1 at y = 0 to x = 5 at y = 6 through a strip of 4 m: at
// y = 1 it enters, at y = 5 it leaves.
TEST(PartRows, EndWhereAPartPassesALineOfTheStrip) {
  PartRows rows;
  const std::vector<BoundaryPart> rising{{{-1, 0}, {5, 6}}};
  const std::vector<Listed> found = listed(rows, rising, 4);
  ASSERT_EQ(found.size(), 3u);
  const double ends[] = {0, 1, 5, 6}, inside[] = {0, 0, 4, 4};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found[i].from, ends[i], 1e-12);
    EXPECT_NEAR(found[i].to, ends[i + 1], 1e-12);
    EXPECT_NEAR(found[i].inside_from, inside[i], 1e-12);
    EXPECT_NEAR(found[i].inside_to, inside[i + 1], 1e-12);
  }
}

// Driven the other way, the region lies on the other side of the same line.
TEST(PartRows, AreInsideOnTheLeftOfAPart) {
  PartRows rows;
  const std::vector<BoundaryPart> falling{{{5, 6}, {-1, 0}}};
  const std::vector<Listed> found = listed(rows, falling, 4);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_NEAR(found[1].inside_from, 4, 1e-12);
  EXPECT_NEAR(found[1].inside_to, 0, 1e-12);
}

TEST(PartRows, EndAtCutsAndAreNoneWhereNoPartPasses) {
  PartRows rows;
  const std::vector<BoundaryPart> apart{{{1, 0}, {1, 2}}, {{3, 9}, {3, 5}}};
  const std::vector<double> cuts{1.5, 3, 7};
  const std::vector<Listed> found = listed(rows, apart, 4, cuts);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].to, 1.5);
  EXPECT_EQ(found[1].to, 2);
  EXPECT_EQ(found[2].from, 5);
  EXPECT_EQ(found[3].from, 7);
  for (const Listed& row : found) EXPECT_NEAR(row.inside_from, 1, 1e-12);
}

TEST(PartRows, KnowTheSenseOfAPartAndWhereItsLinePassesARow) {
  EXPECT_TRUE(rises({{0, 0}, {1, 2}}));
  EXPECT_FALSE(rises({{1, 2}, {0, 0}}));
  EXPECT_NEAR(x_at({{1, 2}, {3, 6}}, 3), 1.5, 1e-12);
  EXPECT_NEAR(x_at({{1, 2}, {3, 6}}, 0), 0, 1e-12) << "beyond its end";
}

TEST(PartRows, OfRandomRegionsAreAsLongInsideAsByBooleans) {
  PartRows rows;
  StripParts cut;
  testing::for_each_seed(60, [&](std::mt19937_64& random, int number) {
    std::uniform_real_distribution<double> width(2, 25), share(0, 0.9), along(-60, 60);
    const Region region = difference({{testing::random_star(random, {3, -5}, 12, 60, 3 + number % 18), {}}},
                                     {{testing::random_star(random, {3, -5}, 2, 9, 3 + number % 5), {}}});
    const StripGrid grid{TrackFrame(), 0.3, width(random)};
    const double margin_m = number % 2 == 0 ? 0 : share(random) * grid.width_m;
    const StripRange range{grid.strip_at(-50), grid.strip_at(50)};
    cut.collect(rings_of(region), grid, range, margin_m);
    const std::vector<double> cuts{along(random), along(random)};
    for (int k = range.first; k <= range.last; ++k) {
      const auto parts = cut.in(static_cast<std::size_t>(k - range.first));
      std::sort(parts.begin(), parts.end(),
                [](const BoundaryPart& a, const BoundaryPart& b) { return a.lowest() < b.lowest(); });
      double before = -1e9, in_rows = 0;
      for (const Listed& row : listed(rows, parts, grid.width_m, cuts)) {
        ASSERT_LT(row.from, row.to);
        ASSERT_GE(row.from, before);
        before = row.to;
        for (const double at : cuts) ASSERT_FALSE(row.from < at && at < row.to);
        // Where ends nearly coincide a row is too thin for a height between them.
        if (row.to - row.from < 1e-9) continue;
        for (const double share_up : {0.25, 0.75}) {
          const double y = row.from + share_up * (row.to - row.from);
          std::set<const BoundaryPart*> passing;
          for (const BoundaryPart& part : parts)
            if (part.lowest() <= y && y < part.highest()) passing.insert(&part);
          ASSERT_EQ(row.parts, passing) << "strip " << k << " row " << y;
          const double inside = length_inside(region, {grid.line(k), y}, {grid.line(k + 1), y});
          ASSERT_NEAR(row.inside_from + share_up * (row.inside_to - row.inside_from), inside, 1e-4)
              << "strip " << k << " row " << y;
        }
        in_rows += row.to - row.from;
      }
      // No row that a part passes is left out.
      Intervals passed;
      for (const BoundaryPart& part : parts)
        if (part.lowest() < part.highest()) append_joining(passed, {part.lowest(), part.highest()});
      double passed_m = 0;
      for (const Interval& one : passed) passed_m += one.length();
      ASSERT_NEAR(in_rows, passed_m, 1e-6) << "strip " << k;
    }
  });
}

}  // namespace
}  // namespace tramline
