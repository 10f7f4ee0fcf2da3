// Boundaries with more corners than their shape has, and rings that are one tangle.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "admission/feature.h"
#include "tramline/admission/ring_crossings.h"
#include "tramline/admission/thin_rings.h"

namespace tramline::testing_features {
namespace {

RawFeature feature_of(std::vector<Point> outer) {
  RawFeature raw = feature({{"0 0, 1 0, 1 1, 0 0"}});
  raw.polygons[0].rings[0] = {std::move(outer), true};
  return raw;
}

/// n corners on a circle of 100 m, every second one `in_m` nearer to its middle.
std::vector<Point> toothed_circle(std::size_t n, double in_m) {
  std::vector<Point> out;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double radius = i % 2 == 0 ? 100 : 100 - in_m;
    out.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return out;
}

TEST(ManyCorners, AreAllKeptUpToTheNumberThatIsStated) {
  const Field field = admit_plain(feature_of(toothed_circle(kManyCorners, 0.001))).fields.front();
  EXPECT_EQ(field.outer.size(), kManyCorners);
  EXPECT_TRUE(field.repairs.empty());
}

TEST(ManyCorners, BeyondItTheBoundaryIsThinnedAndSaidSo) {
  // Teeth of 5 mm on a circle of 100 m: a chord that stays within 1 cm of the circle spans 1.6 degrees, so
  // some 200 corners are enough; no fewer than 1 in 512 is kept. The land is π·100² less half the teeth.
  const RawFeature raw = feature_of(toothed_circle(100000, 0.005));
  const Field field = admit_plain(raw).fields.front();
  expect_admissible(field);
  EXPECT_LT(field.outer.size(), 1000u);
  EXPECT_GT(field.outer.size(), 195u);
  ASSERT_EQ(field.repairs.size(), 1u);
  EXPECT_NE(field.repairs[0].what.find("had 100000 corners"), std::string::npos) << field.repairs[0].what;
  EXPECT_NE(field.repairs[0].what.find("within 1 cm"), std::string::npos) << field.repairs[0].what;
  EXPECT_NEAR(workable_m2(field), 10000 * std::numbers::pi, 0.01 * 200 * std::numbers::pi);
  EXPECT_NEAR(drawn_m2(raw) + changes_m2(field), workable_m2(field), 1e-6);
}

TEST(ManyCorners, TheLeastToleranceThatDoesIsTaken) {
  // Teeth of 3 cm stay within 1 and 2 cm, and go within 5.
  const Field field = admit_plain(feature_of(toothed_circle(20000, 0.03))).fields.front();
  expect_admissible(field);
  ASSERT_EQ(field.repairs.size(), 1u);
  EXPECT_NE(field.repairs[0].what.find("within 5 cm"), std::string::npos) << field.repairs[0].what;
}

TEST(ManyCorners, WhatCannotBeThinnedIsRefusedWithTheNumbers) {
  const Crs plain;
  const std::string sentence =
      refusal(feature_of(toothed_circle(20000, 0.5)), {"farm.gpkg", "parcels", &plain});
  EXPECT_NE(sentence.find("the boundary has 20000 corners, and still 19"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("10000 corners or fewer"), std::string::npos) << sentence;
}

TEST(ManyCorners, AMillionInOnePlaceAreNoCorners) {
  std::vector<Point> corners{{0, 0}, {100, 0}, {100, 50}, {0, 50}};
  corners.insert(corners.end(), 1000000, Point{0, 25});
  const Field field = admit_plain(feature_of(std::move(corners))).fields.front();
  expect_admissible(field);
  EXPECT_LE(field.outer.size(), 5u);
  EXPECT_LT(field.repairs.size(), 2100u);
}

/// One ring: `lines` lines to and fro, and as many up and down across all of them.
std::vector<Point> lattice(int lines) {
  std::vector<Point> out;
  for (int i = 0; i < lines; ++i) {
    const double y = i + 1, far = lines + 1;
    out.push_back({i % 2 == 0 ? 0 : far, y});
    out.push_back({i % 2 == 0 ? far : 0, y});
  }
  for (int i = 0; i < lines; ++i) {
    const double x = i + 0.5, far = lines + 2;
    out.push_back({x, i % 2 == 0 ? far : 0});
    out.push_back({x, i % 2 == 0 ? 0 : far});
  }
  return out;
}

TEST(RingCrossings, AreCounted) {
  EXPECT_EQ(ring_crossings({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 9), 0u);
  EXPECT_EQ(ring_crossings({{0, 0}, {4, 4}, {4, 0}, {0, 4}}, 9), 1u);
  Ring pentagram;
  for (int i = 0; i < 5; ++i)
    pentagram.push_back({std::cos(4 * std::numbers::pi * i / 5), std::sin(4 * std::numbers::pi * i / 5)});
  EXPECT_EQ(ring_crossings(pentagram, 9), 5u);
  EXPECT_EQ(ring_crossings(pentagram, 3), 4u) << "counting ends above the most";
  // 10 lines across 10 lines; the way from the last of these to the first of those crosses nothing else.
  EXPECT_GE(ring_crossings(lattice(10), 1000), 100u);
  EXPECT_LE(ring_crossings(lattice(10), 1000), 140u);
}

TEST(RingCrossings, ATangleIsRefusedBeforeItIsSortedOut) {
  std::string text;
  for (const Point p : lattice(50)) text += std::to_string(p.x) + " " + std::to_string(p.y) + ", ";
  const std::string sentence = refusal_plain({text + "0 1"});
  EXPECT_NE(sentence.find("the outer ring crosses itself more than 2000 times"), std::string::npos)
      << sentence;
}

}  // namespace
}  // namespace tramline::testing_features
