#include "tramline/render/coverage/gap_labels.h"

#include <gtest/gtest.h>

#include <random>

#include "tramline/geometry/path/simplified_line.h"
#include "tramline/model/palette.h"

namespace tramline::render {
namespace {

constexpr Box kPaper{0, 0, 1000, 800};
const MapView kMetresAsPixels{{0, 0}, {500, 400}, 1};  // a pixel is a metre

Gap gap_at(int number, Point centre, double widest_m) { return {number, {}, 1, centre, widest_m}; }

TEST(GapLabels, AreInsideWhereThereIsRoom) {
  const auto labels =
      place_gap_labels({gap_at(1, {10, 20}, 40), gap_at(2, {-200, 0}, 10)}, kMetresAsPixels, 1, kPaper);
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_EQ(labels[0].badge, (Point{510, 380}));
  EXPECT_EQ(labels[0].gap, labels[0].badge);
  EXPECT_EQ(labels[1].gap, (Point{300, 400}));
  EXPECT_GT(distance(labels[1].gap, labels[1].badge), 2 * kGapBadgeRadius);
}

TEST(GapLabels, OnlyTheLargestAndWhatTheMapShows) {
  std::vector<Gap> gaps;
  for (int i = 0; i < 40; ++i) gaps.push_back(gap_at(i + 1, {-400.0 + 20 * i, 0}, 0.1));
  gaps[3].centre = {5000, 0};
  const auto labels = place_gap_labels(gaps, kMetresAsPixels, 1, kPaper);
  EXPECT_EQ(labels.size(), static_cast<std::size_t>(kGapsNumbered) - 1);
  for (const GapLabel& label : labels) EXPECT_LE(label.number, kGapsNumbered);
}

/// Twelve gaps anywhere on the map, also in its corners: all rules hold.
TEST(GapLabels, KeepOffOneAnother) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(-499, 499), y(-399, 399);
    std::vector<Gap> gaps;
    for (int i = 0; i < 12; ++i) gaps.push_back(gap_at(i + 1, {x(random), y(random)}, 0.5));
    const auto labels = place_gap_labels(gaps, kMetresAsPixels, 1, kPaper);
    ASSERT_EQ(labels.size(), 12u);
    for (const GapLabel& a : labels) {
      EXPECT_GE(a.badge.x, kPaper.min_x + kGapBadgeRadius);
      EXPECT_LE(a.badge.x, kPaper.max_x - kGapBadgeRadius);
      EXPECT_GE(a.badge.y, kPaper.min_y + kGapBadgeRadius);
      EXPECT_LE(a.badge.y, kPaper.max_y - kGapBadgeRadius);
      for (const GapLabel& b : labels) {
        if (a.number == b.number) continue;
        EXPECT_GE(distance(a.badge, b.badge), 2 * kGapBadgeRadius);
        EXPECT_GE(distance(a.badge, b.gap), kGapBadgeRadius);
        EXPECT_GE(distance_to_segment(a.badge, b.gap, b.badge), kGapBadgeRadius);
      }
    }
  }
}

/// All in one place: more than there is room for, and still every badge on the map.
TEST(GapLabels, ACrowdKeepsItsNumbers) {
  std::vector<Gap> gaps;
  for (int i = 0; i < 12; ++i) gaps.push_back(gap_at(i + 1, {490 + 0.5 * i, 395}, 0.1));
  const auto labels = place_gap_labels(gaps, kMetresAsPixels, 1, kPaper);
  ASSERT_EQ(labels.size(), 12u);
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GT(distance(labels[i].badge, labels[k].badge), kGapBadgeRadius) << i << " " << k;
}

}  // namespace
}  // namespace tramline::render
