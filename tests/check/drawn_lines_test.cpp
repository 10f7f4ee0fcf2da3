// The lines that a plan file draws against the exact paths, and lines that somebody has edited.

#include <gtest/gtest.h>

#include <cmath>

#include "check/plans.h"
#include "tramline/check/file/compare_layers.h"

namespace tramline {
namespace {

using namespace testing_plans;
using Lines = std::vector<std::vector<Point>>;

Lines drawn(const Plan& plan) {
  Lines out;
  for (const TrackPiece& piece : plan.pieces) out.push_back(chords(centre_line(piece)));
  return out;
}

/// The rules violated once the line of the piece with the detour on its left is changed.
template <class Change>
Names after(Change change) {
  const Plan plan = poles_plan();
  Lines lines = drawn(plan);
  change(lines[4]);
  Names out;
  for (const check::Violation& v : check::compare_lines(plan, lines)) out.emplace(name(v.rule));
  return out;
}

/// The vertex of a line that is nearest to x.
std::size_t vertex_near(const std::vector<Point>& line, double x) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (std::abs(line[i].x - x) < std::abs(line[best].x - x)) best = i;
  return best;
}

TEST(DrawnLines, AgreeWithTheirPaths) {
  for (const Plan& plan : {poles_plan(), turned(poles_plan(), Angle::degrees(217), {1e4, -1e4}),
                           obstacle_plan(), crossing_plan()})
    EXPECT_TRUE(check::compare_lines(plan, drawn(plan)).empty());
  // Chords of another fineness, and vertices on them, show the same path.
  const Plan plan = poles_plan();
  Lines lines = drawn(plan);
  lines[4] = chords(centre_line(plan.pieces[4]), 3e-7);
  for (std::size_t i = lines[7].size() - 1; i > 0; --i)
    lines[7].insert(lines[7].begin() + static_cast<std::ptrdiff_t>(i),
                    midpoint(lines[7][i - 1], lines[7][i]));
  EXPECT_TRUE(check::compare_lines(plan, lines).empty());
}

TEST(DrawnLines, OffByMoreThanChordsAre) {
  EXPECT_EQ(after([](auto& line) { line[line.size() / 2].y += 1e-5; }), Names{});
  EXPECT_EQ(after([](auto& line) { line[line.size() / 2].y += 1e-4; }), Names{"layers"});
  EXPECT_EQ(after([](auto& line) { line.front().x -= 1e-4; }), Names{"layers"});
  EXPECT_EQ(after([](auto& line) { line.back().x += 1e-4; }), Names{"layers"});
  EXPECT_EQ(after([](auto& line) { line.pop_back(); }), Names{"layers"});
  EXPECT_EQ(after([](auto& line) { line.erase(line.begin() + 20, line.begin() + 23); }), Names{"layers"});
  EXPECT_EQ(after([](auto& line) { line = {line.front()}; }), Names{"layers"});
  EXPECT_EQ(after([](auto& line) { line.clear(); }), Names{"layers"});
  EXPECT_EQ(after([](auto& line) { std::swap(line[20], line[22]); }), (Names{"layers", "drivable"}));
  const Plan plan = poles_plan();
  Lines lines = drawn(plan);
  lines.pop_back();
  EXPECT_EQ(check::compare_lines(plan, lines).size(), 1u);
}

TEST(DrawnLines, PushedIntoAnObstacle) {
  EXPECT_EQ(after([](auto& line) {
              for (Point& p : line)
                if (std::abs(p.x - 50) < 20) p.y -= 0.05 * (0.5 + 0.5 * std::cos((p.x - 50) / 20 * 3.14159));
            }),
            (Names{"layers", "clearance"}));
  // Straight through.
  EXPECT_EQ(after([](auto& line) { line = {line.front(), line.back()}; }), (Names{"layers", "clearance"}));
}

TEST(DrawnLines, WithKinksAndArcsTooTight) {
  // Five centimetres outwards at one vertex.
  EXPECT_EQ(after([](auto& line) { line[vertex_near(line, 50)].y += 0.05; }), (Names{"layers", "drivable"}));
  // Somebody else's bulge: every single chord turns by little, all together by too much.
  EXPECT_EQ(after([](auto& line) {
              TrackPiece other = poles_plan().pieces[4];
              other.detours = {bulge(other, 50, 1.9, 5.2, Passing::kLeft, {0})};
              line = chords(centre_line(other), 1e-4);
            }),
            (Names{"layers", "drivable"}));
  EXPECT_EQ(after([](auto& line) {
              TrackPiece other = poles_plan().pieces[4];
              other.detours = {bulge(other, 50, 1.9, 6, Passing::kLeft, {0})};
              line = chords(centre_line(other), 1e-4);
            }),
            Names{"layers"});
}

TEST(DrawnLines, LeavingTheField) {
  const Plan plan = poles_plan();
  Lines lines = drawn(plan);
  TrackPiece other = plan.pieces[9];
  other.detours = {bulge(other, 50, 1.9, 6, Passing::kRight, {})};
  lines[9] = chords(centre_line(other));
  Names names;
  for (const check::Violation& v : check::compare_lines(plan, lines)) names.emplace(name(v.rule));
  EXPECT_EQ(names, (Names{"layers", "swaths"}));
}

TEST(DrawnLines, SwathsWithArcsMayHaveOtherChords) {
  const Plan plan = poles_plan();
  std::vector<int> order;
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) order.push_back(static_cast<int>(i) + 1);
  Region stored = swaths(plan);
  EXPECT_TRUE(check::compare_swaths(plan, order, stored, order).empty());
  stored[4].outer = band(centre_line(plan.pieces[4]), 3, 0.7e-5);
  EXPECT_NE(stored[4].outer.size(), swaths(plan)[4].outer.size());
  EXPECT_TRUE(check::compare_swaths(plan, order, stored, order).empty());
  stored[4].outer = band(centre_line(plan.pieces[4]), 3.0001, 0.7e-5);
  EXPECT_EQ(check::compare_swaths(plan, order, stored, order).size(), 1u);
  stored[4].outer = band(straight_path(plan.pieces[4].start, plan.pieces[4].end), 3);
  EXPECT_EQ(check::compare_swaths(plan, order, stored, order).size(), 1u);
}

TEST(DrawnLines, WordsFollowFromPaths) {
  std::vector<check::Violation> out;
  check::compare_text("layer tracks, feature 1, sides", "left", "left", {}, out);
  EXPECT_TRUE(out.empty());
  check::compare_text("layer tracks, feature 1, sides", "left", "right", {}, out);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].rule, check::Rule::kLayers);
}

}  // namespace
}  // namespace tramline
