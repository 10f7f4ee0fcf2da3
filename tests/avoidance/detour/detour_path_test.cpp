// Paths round discs against their closed forms, and what holds for every path round many discs.

#include "tramline/avoidance/detour/detour_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/avoidance/obstacles/hazards.h"

namespace tramline::detour_path_test {

constexpr double kPi = std::numbers::pi;

/// Points all along a path, by turning round the centres of its arcs.
std::vector<Point> samples(const Path& path) {
  constexpr int kEach = 400;
  std::vector<Point> out;
  for (const PathSegment& segment : path)
    for (int i = 0; i <= kEach; ++i) {
      const double share = static_cast<double>(i) / kEach;
      if (segment.straight()) {
        out.push_back(segment.from + share * (segment.to - segment.from));
        continue;
      }
      const double angle = share * turning(segment), c = std::cos(angle), s = std::sin(angle);
      const Point spoke = segment.from - centre(segment);
      out.push_back(centre(segment) + Point{c * spoke.x - s * spoke.y, s * spoke.x + c * spoke.y});
    }
  return out;
}

double peak(const Path& path) {
  double highest = 0;
  for (const Point p : samples(path)) highest = std::max(highest, p.y);
  // The highest point of an arc over its centre, which samples miss.
  for (const PathSegment& segment : path)
    if (segment.curvature < 0 && direction_at_start(segment).y >= 0 && direction_at_end(segment).y <= 0)
      highest = std::max(highest, centre(segment).y + radius(segment));
  return highest;
}

/// How far the heading jumps between two segments, rad.
double jump(const PathSegment& a, const PathSegment& b) {
  const Point before = direction_at_end(a), after = direction_at_start(b);
  return std::abs(std::atan2(cross(before, after), dot(before, after)));
}

/// Leaves and rejoins y = 0 along +x, in one go, without kinks, nowhere tighter than r and never backwards.
void expect_drivable(const Path& path, double least_radius) {
  ASSERT_FALSE(path.empty());
  EXPECT_EQ(path.front().from.y, 0);
  EXPECT_EQ(path.back().to.y, 0);
  EXPECT_GT(direction_at_start(path.front()).x, 0);
  EXPECT_NEAR(direction_at_start(path.front()).y, 0, 1e-6);
  EXPECT_GT(direction_at_end(path.back()).x, 0);
  EXPECT_NEAR(direction_at_end(path.back()).y, 0, 1e-6);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    EXPECT_EQ(path[i].to, path[i + 1].from);
    EXPECT_LT(jump(path[i], path[i + 1]), 1e-6) << "after segment " << i << " of " << path.size();
  }
  EXPECT_GE(smallest_radius(path), least_radius * (1 - 1e-12));
  const std::vector<Point> points = samples(path);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) ASSERT_GE(points[i + 1].x, points[i].x - 1e-9);
}

void expect_clear_of(const Path& path, const std::vector<KeepOut>& discs) {
  const std::vector<Point> points = samples(path);
  for (const KeepOut& disc : discs)
    for (const Point p : points) ASSERT_GE(distance(p, disc.centre), disc.radius - 1e-9);
}

double highest_reach(const std::vector<KeepOut>& discs) {
  double highest = discs.front().centre.y + discs.front().radius;
  for (const KeepOut& disc : discs) highest = std::max(highest, disc.centre.y + disc.radius);
  return highest;
}

/// Round one disc of radius ρ that reaches h over the track. With c = h − ρ, both forms of the header are
/// √(h (2ρ + 2r − h)) and √(h (4r − h)): so written they keep their digits where h is small.
double half_length(double h, double rho, double r) {
  return std::sqrt(h * (2 * std::max(rho, r) + 2 * r - h));
}

struct OneDisc {
  double rho, c, r;
};

/// Discs that reach over the track, low enough that three arcs go round (ρ + c ≤ r + max(ρ, r)).
std::vector<OneDisc> single_discs() {
  std::vector<OneDisc> out;
  for (const double rho : {0.75, 1.5, 2.0, 3.25, 6.0, 11.0})
    for (const double share : {-0.999, -0.6, -0.25, 0.0, 0.1, 0.5, 0.9})
      for (const double r : {0.5, 1.5, 3.0, 6.0, 12.0})
        if (const double c = share * rho; rho + c < r + std::max(rho, r)) out.push_back({rho, c, r});
  return out;
}

TEST(DetourPath, RoundOneDiscHasThePeakAndTheHalfLengthOfTheClosedForm) {
  for (const auto& [rho, c, r] : single_discs()) {
    SCOPED_TRACE(::testing::Message() << "rho " << rho << " c " << c << " r " << r);
    const auto path = detour_path({{{40, c}, rho}}, r);
    ASSERT_TRUE(path);
    const double h = rho + c;
    const double half = rho >= r ? std::sqrt((rho + r) * (rho + r) - (r - c) * (r - c))  // Versleijen fig. 18
                                 : std::sqrt(4 * r * h - h * h);
    EXPECT_NEAR(peak(*path), h, 1e-6);
    EXPECT_NEAR(path->front().from.x, 40 - half, 1e-6);
    EXPECT_NEAR(path->back().to.x, 40 + half, 1e-6);
    expect_drivable(*path, r);
    expect_clear_of(*path, {{{40, c}, rho}});
  }
}

// The outer arcs turn by θ out and back, the middle one by 2θ; the triangle of their centres and the track's
// normal gives cos θ = (r − y)/(r + ϱ) for a middle arc of radius ϱ = max(ρ, r) round (0, y), y = h − ϱ.
TEST(DetourPath, RoundOneDiscIsThreeArcsAsLongAsAnglesTimesRadii) {
  for (const auto& [rho, c, r] : single_discs()) {
    SCOPED_TRACE(::testing::Message() << "rho " << rho << " c " << c << " r " << r);
    const auto path = detour_path({{{0, c}, rho}}, r);
    ASSERT_TRUE(path);
    const double middle = std::max(rho, r), theta = std::acos((r - (rho + c - middle)) / (r + middle));
    // A middle arc near half a circle comes in two halves.
    ASSERT_EQ(path->size(), std::cos(2 * theta) < -0.6 ? 4u : 3u);
    EXPECT_NEAR(length(*path), 2 * theta * (r + middle), 1e-6);
    EXPECT_NEAR(radius(path->front()), r, 1e-9);
    for (std::size_t i = 1; i + 1 < path->size(); ++i) EXPECT_NEAR(radius((*path)[i]), middle, 1e-9);
    EXPECT_NEAR(radius(path->back()), r, 1e-9);
  }
}

// Versleijen fig. 18, drivable: a pass radius of max(R_o + w/2, r) and a half-length of √((ρ + r)² − (r ±
// |c|)²), with
// + where the centre lies on the other side of the track.
TEST(UnroundedDetourPath, RoundOnePassRadiusIsS1s) {
  for (const double obstacle : {0.3, 1.0, 4.0})
    for (const double width : {1.5, 3.0, 12.0})
      for (const double r : {3.0, 6.0, 12.0})
        for (const double off : {-1.0, -0.4, 0.0, 0.3, 0.9}) {
          const double c = off * obstacle, rho = std::max(obstacle + width / 2, r);
          if (c > r) continue;  // the paper's arcs would turn by more than a right angle
          const auto path = detour_path({{{-7, c}, rho}}, r, HullCorners::kAsTheyAre);
          ASSERT_TRUE(path);
          const double arm = c < 0 ? r + std::abs(c) : r - std::abs(c);
          const double half = std::sqrt((rho + r) * (rho + r) - arm * arm);
          EXPECT_NEAR(path->front().from.x, -7 - half, 1e-6);
          EXPECT_NEAR(path->back().to.x, -7 + half, 1e-6);
          EXPECT_NEAR(peak(*path), rho + c, 1e-6);
          expect_drivable(*path, r);
        }
}

// It keeps the disc's own radius where that is below r, which detour_path() does not.
TEST(UnroundedDetourPath, MayBeTooTightInTheMiddle) {
  const std::vector<KeepOut> discs{{{0, -0.5}, 2}};
  EXPECT_NEAR(smallest_radius(detour_path(discs, 6, HullCorners::kAsTheyAre).value()), 2, 1e-9);
  EXPECT_NEAR(smallest_radius(detour_path(discs, 6).value()), 6, 1e-9);
}

TEST(DetourPath, RoundADiscThatBarelyReachesOver) {
  for (const double h : {1e-9, 1e-4})
    for (const auto& [rho, r] : {std::pair{5.0, 6.0}, std::pair{9.0, 6.0}}) {
      const std::vector<KeepOut> discs{{{0, h - rho}, rho}};
      const auto path = detour_path(discs, r);
      ASSERT_TRUE(path) << h;
      EXPECT_NEAR(path->back().to.x, half_length(h, rho, r), 1e-6 * half_length(h, rho, r));
      EXPECT_NEAR(path->front().from.x, -half_length(h, rho, r), 1e-6 * half_length(h, rho, r));
      EXPECT_NEAR(peak(*path), h, 1e-14);
      expect_drivable(*path, r);
      expect_clear_of(*path, discs);
    }
}

TEST(DetourPath, IsNotNeededWhereNothingReachesOverTheTrack) {
  EXPECT_FALSE(detour_path({{{0, -5.1}, 5}}, 6));
  EXPECT_FALSE(detour_path({{{0, -5}, 5}}, 6)) << "it touches";
  EXPECT_FALSE(detour_path({{{0, -5.1}, 5}, {{3, -2}, 1}, {{9, -40}, 20}}, 6));
  EXPECT_FALSE(detour_path({{{0, -5.1}, 5}, {{3, -2}, 1}}, 6, HullCorners::kAsTheyAre));
  EXPECT_TRUE(detour_path({{{0, -5.1}, 5}, {{3, -0.9}, 1}}, 6)) << "one of them does";
}

// A centre above r would ask for arcs of more than a quarter turn. A line at 75° leads up instead, tangent to
// the disc (0, c), ϱ and to the arc (a, r), r on its other side: with n = (sin 75°, cos 75°),
// n·(a, r) = n·(0, c) + ϱ + r. The line is as long as the centres lie apart along it.
TEST(DetourPath, ClimbsATallStackByALineOf75Degrees) {
  const double steep = 75 * kPi / 180, s = std::sin(steep), k = std::cos(steep);
  for (const double c : {3.01, 8.0, 30.0})
    for (const double rho : {1.5, 5.0}) {
      SCOPED_TRACE(::testing::Message() << "c " << c << " rho " << rho);
      const double r = 3, middle = std::max(rho, r), y = c + rho - middle;
      if (y <= r) continue;  // three arcs do
      const std::vector<KeepOut> discs{{{0, c}, rho}};
      const auto path = detour_path(discs, r);
      ASSERT_TRUE(path);
      const double half = (k * (y - r) + middle + r) / s;
      EXPECT_NEAR(path->back().to.x, half, 1e-9);
      EXPECT_NEAR(path->front().from.x, -half, 1e-9);
      const double line = k * half + s * (y - r);
      EXPECT_NEAR(length(*path), 2 * steep * (r + middle) + 2 * line, 1e-9);
      EXPECT_NEAR(peak(*path), c + rho, 1e-9);
      expect_drivable(*path, r);
      expect_clear_of(*path, discs);
    }
}

// Two equal discs side by side: the path round one, with a line between as long as they are apart.
TEST(DetourPath, RunsStraightAlongDiscsInARow) {
  const double rho = 2, c = -0.5, r = 6, h = 1.5, half = half_length(h, rho, r);
  const Path one = detour_path({{{0, c}, rho}}, r).value();
  for (const std::vector<KeepOut>& discs :
       {std::vector<KeepOut>{{{0, c}, rho}, {{4, c}, rho}},
        std::vector<KeepOut>{{{4, c}, rho}, {{0, c}, rho}, {{2, c}, rho}, {{1, c}, rho}, {{0, c}, rho}}}) {
    const auto path = detour_path(discs, r);
    ASSERT_TRUE(path);
    EXPECT_NEAR(path->front().from.x, -half, 1e-6);
    EXPECT_NEAR(path->back().to.x, 4 + half, 1e-6);
    EXPECT_NEAR(length(*path), length(one) + 4, 1e-6);
    EXPECT_NEAR(peak(*path), h, 1e-6);
    expect_drivable(*path, r);
    expect_clear_of(*path, discs);
  }
}

TEST(DetourPath, IsTheSameRoundADiscAndItsDuplicates) {
  const KeepOut disc{{3, 0.7}, 2};
  const Path one = detour_path({disc}, 6).value();
  EXPECT_EQ(detour_path({disc, disc, disc}, 6).value(), one);
  EXPECT_EQ(detour_path({disc, {{3, 0.2}, 1}, {{3.1, 0.1}, 0.5}}, 6).value(), one)
      << "smaller ones under its arc";
}

struct Discs {
  std::vector<KeepOut> all;
  double r = 0;
};

/// A handful of discs near the track, some of one size, some collinear, some twice, some out of the way.
Discs random_discs(std::mt19937_64& random) {
  const auto uniform = [&random](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const auto whole = [&random](int a, int b) { return std::uniform_int_distribution<int>(a, b)(random); };
  Discs out;
  out.r = uniform(0.5, 15);
  const double common = uniform(0.2, 8), slope = uniform(-2, 2), spread = std::exp(uniform(0, 4));
  const bool one_size = whole(0, 1) == 0, one_line = whole(0, 3) == 0;
  for (int i = whole(1, 12); i > 0; --i) {
    const double x = uniform(0, spread), rho = one_size ? common : uniform(0.1, 8);
    const double y = one_line ? slope * x : uniform(-rho, whole(0, 3) == 0 ? 60 : 4);
    out.all.push_back({{x, y}, rho});
    if (whole(0, 4) == 0) out.all.push_back(out.all.back());
  }
  return out;
}

/// Where a path round this disc alone would come back to the track, pressed against the common radius: none
/// can be back earlier. Nothing is known from discs below the track, nor from those that only a line goes up
/// to.
double earliest_return(const KeepOut& disc, double common, double r) {
  const double h = disc.centre.y + disc.radius;
  if (h <= 0 || h - common > r) return -std::numeric_limits<double>::infinity();
  return disc.centre.x + std::sqrt(h * (2 * common + 2 * r - h));
}

TEST(DetourPathProperties, RoundRandomDiscsIsDrivableClearAndNoHigherThanItHasToBe) {
  int touched = 0;
  for (int i = 0; i < testing::case_count(600); ++i) {
    testing::SeededRandom random(i);
    const Discs discs = random_discs(random);
    const auto path = detour_path(discs.all, discs.r);
    const double h = highest_reach(discs.all);
    ASSERT_EQ(path.has_value(), h > 0);
    if (!path) continue;
    EXPECT_NEAR(peak(*path), h, 1e-6);
    expect_drivable(*path, discs.r);
    expect_clear_of(*path, discs.all);
    // What it ends with are arcs of the machine's radius. It is back when the last disc lets it.
    EXPECT_NEAR(radius(path->front()), discs.r, 1e-9);
    EXPECT_NEAR(radius(path->back()), discs.r, 1e-9);
    double common = discs.r;
    for (const KeepOut& disc : discs.all) common = std::max(common, disc.radius);
    double earliest = -std::numeric_limits<double>::infinity();
    for (const KeepOut& disc : discs.all)
      earliest = std::max(earliest, earliest_return(disc, common, discs.r));
    EXPECT_GE(path->back().to.x, earliest - 1e-6);
    const PathSegment& before = (*path)[path->size() - 2];
    if (!before.straight()) {
      ++touched;
      EXPECT_NEAR(path->back().to.x, earliest, 1e-6);
    }
    if (HasFailure()) return;
  }
  if (testing::case_count(600) >= 100) {
    EXPECT_GT(5 * touched, testing::case_count(600)) << "too few come straight off a disc";
  }
}

// A mirrored scene has the mirrored path, and a moved one the moved path.
TEST(DetourPathProperties, FollowsItsDiscsWhenTheyAreMirroredOrMoved) {
  for (int i = 0; i < testing::case_count(300); ++i) {
    testing::SeededRandom random(i);
    const Discs discs = random_discs(random);
    const auto path = detour_path(discs.all, discs.r);
    Discs moved = discs, mirrored = discs;
    for (KeepOut& disc : moved.all) disc.centre.x += 1e5;
    for (KeepOut& disc : mirrored.all) disc.centre.x = -disc.centre.x;
    const auto there = detour_path(moved.all, discs.r), back = detour_path(mirrored.all, discs.r);
    ASSERT_EQ(there.has_value(), path.has_value());
    ASSERT_EQ(back.has_value(), path.has_value());
    if (!path) continue;
    EXPECT_NEAR(back->front().from.x, -path->back().to.x, 1e-9);
    EXPECT_NEAR(back->back().to.x, -path->front().from.x, 1e-9);
    EXPECT_NEAR(length(*back), length(*path), 1e-9 * (1 + length(*path)));
    EXPECT_NEAR(there->front().from.x - 1e5, path->front().from.x, 1e-6);
    EXPECT_NEAR(there->back().to.x - 1e5, path->back().to.x, 1e-6);
    EXPECT_NEAR(length(*there), length(*path), 1e-6);
    if (HasFailure()) return;
  }
}

Ring polygon(int corners, double radius, Point at) {
  Ring ring;
  for (int i = 0; i < corners; ++i)
    ring.push_back(
        at + radius * Point{std::cos(0.3 + 2 * kPi * i / corners), std::sin(0.3 + 2 * kPi * i / corners)});
  return ring;
}

TEST(CircleOf, RegularPolygonsStandForTheirCircumcircle) {
  for (const int corners : {8, 9, 16, 33, 128})
    for (const Point at : {Point{0, 0}, Point{4000, -2500}}) {
      const auto circle = circle_of(polygon(corners, 2.5, at));
      ASSERT_TRUE(circle) << corners;
      EXPECT_NEAR(circle->radius, 2.5, 1e-9);
      EXPECT_NEAR(distance(circle->centre, at), 0, 1e-9);
    }
}

// 0.9 % off the circle is within the share of 1 %, though the centre of gravity moves with the vertex.
TEST(CircleOf, VerticesMayBeOffByLessThanAHundredth) {
  Ring ring = polygon(24, 1, {});
  ring[5] = 0.994 * ring[5];
  EXPECT_TRUE(circle_of(ring));
  ring[5] = (0.97 / 0.994) * ring[5];
  EXPECT_FALSE(circle_of(ring));
}

TEST(CircleOf, FewCornersCornersAndHalvesAreNoCircles) {
  EXPECT_FALSE(circle_of(polygon(3, 2, {})));
  EXPECT_FALSE(circle_of(polygon(4, 2, {}))) << "a square's corners lie on a circle, too";
  EXPECT_FALSE(circle_of(polygon(6, 2, {})));
  EXPECT_FALSE(circle_of(polygon(7, 2, {})));
  EXPECT_FALSE(circle_of({{0, 0}, {6, 0}, {6, 2}, {0, 2}}));
  // With points on the sides.
  EXPECT_FALSE(circle_of({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}));
  Ring half;
  for (int i = 0; i <= 16; ++i) half.push_back({std::cos(kPi * i / 16), std::sin(kPi * i / 16)});
  EXPECT_FALSE(circle_of(half));
  // All vertices on one circle but one chord of 90°: a disc with a piece cut off.
  Ring cut = polygon(32, 1, {});
  cut.erase(cut.begin(), cut.begin() + 7);
  EXPECT_FALSE(circle_of(cut));
}

}  // namespace tramline::detour_path_test
