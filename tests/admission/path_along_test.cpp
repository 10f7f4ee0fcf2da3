#include "tramline/admission/lines/path_along.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tramline {
namespace {

constexpr double kWithin_m = 0.02;

/// 40 m east, half a circle to the left of 5 m, and back beside the line, 10 m off it.
const Path kHairpin{{{0, 0}, {40, 0}, 0}, {{40, 0}, {40, 10}, 0.2}, {{40, 10}, {0, 10}, 0}};

/// Chords on the path, 1 cm off it at most.
std::vector<Point> drawn() { return chords(kHairpin, 0.01); }

TEST(PathAlong, IsThePathOfItsChords) { EXPECT_EQ(path_along(kHairpin, drawn(), kWithin_m), kHairpin); }

TEST(PathAlong, RunsAsTheLineDoes) {
  std::vector<Point> line = drawn();
  std::reverse(line.begin(), line.end());
  EXPECT_EQ(path_along(kHairpin, line, kWithin_m), reversed(kHairpin));
}

TEST(PathAlong, VerticesAddedOnTheLineChangeNothing) {
  std::vector<Point> line = drawn();
  line.insert(line.begin() + 1, {{10, 0.01}, {20, -0.01}, {30, 0}});
  EXPECT_TRUE(path_along(kHairpin, line, kWithin_m));
}

TEST(PathAlong, AMovedLineIsAnother) {
  std::vector<Point> line = drawn();
  for (Point& p : line) p.y += 0.03;
  EXPECT_FALSE(path_along(kHairpin, line, kWithin_m));
  EXPECT_TRUE(path_along(kHairpin, line, 0.05));
}

TEST(PathAlong, ACutOrLengthenedLineIsAnother) {
  std::vector<Point> cut = drawn(), longer = drawn();
  cut.back().x += 1;
  longer.back().x -= 1;
  EXPECT_FALSE(path_along(kHairpin, cut, kWithin_m));
  EXPECT_FALSE(path_along(kHairpin, longer, kWithin_m));
  cut.erase(cut.begin() + 1, cut.end());
  EXPECT_FALSE(path_along(kHairpin, cut, kWithin_m));
}

TEST(PathAlong, ABentVertexIsSeen) {
  std::vector<Point> line = drawn();
  line.insert(line.begin() + 1, {20, 0.5});
  EXPECT_FALSE(path_along(kHairpin, line, kWithin_m));
}

TEST(PathAlong, AShortCutThroughTheTurnIsSeen) {
  EXPECT_FALSE(path_along(kHairpin, {{0, 0}, {40, 0}, {40, 10}, {0, 10}}, kWithin_m));
}

// All vertices lie on the path, and all of the path on the line, but for the order.
TEST(PathAlong, TheSameGroundInAnotherOrderIsAnotherLine) {
  const Path two{{{0, 0}, {40, 0}, 0}, {{40, 0}, {40, 30}, 0}};
  EXPECT_TRUE(path_along(two, {{0, 0}, {40, 0}, {40, 30}}, kWithin_m));
  EXPECT_FALSE(path_along(two, {{0, 0}, {40, 0}, {0, 0}, {40, 0}, {40, 30}}, kWithin_m));
  std::vector<Point> line = drawn();
  std::vector<Point> twice = line;
  twice.insert(twice.end(), line.begin() + 1, line.end());
  EXPECT_FALSE(path_along(kHairpin, twice, kWithin_m));
}

TEST(PathAlong, AClosedPassIsItsOwn) {
  const Path ring{{{10, 0}, {0, 10}, 0.1}, {{0, 10}, {-10, 0}, 0.1}, {{-10, 0}, {10, 0}, 0.1}};
  EXPECT_EQ(path_along(ring, chords(ring, 0.01), kWithin_m), ring);
}

}  // namespace
}  // namespace tramline
