#include "tramline/coverage/mesh/mesh_coverage.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "coverage/mesh/mesh_oracle.h"
#include "coverage/pentagon_routes.h"
#include "tramline/coverage/mesh/connected_rings.h"
#include "tramline/coverage/mesh/mesh_boolean.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::coverage {
namespace {

using testing_meshes::corners_of;
using testing_meshes::CornerSet;
using testing_meshes::together;
using testing_routes::pentagon;
using testing_routes::PentagonRoute;

Quad quad_box(double min_x, double min_y, double max_x, double max_y) {
  return {Point{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}};
}
Ring ring(const Quad& quad) { return {quad.begin(), quad.end()}; }
WorkedStep step(std::vector<Quad> quads) { return {std::move(quads), 0, 0, 0, 0}; }

/// To the parts of a mesh of 1 m in which lines are computed.
Point rounded(Point p) {
  constexpr double kParts = kFinePerMesh;
  return {std::round(p.x * kParts) / kParts, std::round(p.y * kParts) / kParts};
}

/// The bar of a machine across its heading.
struct Bar {
  Point left, right;
};
Bar bar(Point at, double heading_rad, double width_m) {
  const Point left = 0.5 * width_m * Point{-std::cos(heading_rad), std::sin(heading_rad)};
  return {at + left, at - left};
}
Quad between(const Bar& rear, const Bar& front) { return {rear.left, rear.right, front.right, front.left}; }

TEST(MeshCoverage, TwoRowsByHand) {
  const Region field{{ring(quad_box(0, 0, 10, 10)), {}}};
  MeshCoverage engine(field, 0.5);
  EXPECT_DOUBLE_EQ(engine.areas().missed_m2, 100);
  engine.add(step({quad_box(-2, 0, 4, 12)}));
  engine.add(step({quad_box(3, 5, 7, 10), quad_box(7, 5, 8, 10)}));
  const CoverageAreas areas = engine.areas();
  EXPECT_DOUBLE_EQ(areas.gross_m2, 72 + 25);
  EXPECT_DOUBLE_EQ(areas.covered_m2, 72 + 20);
  EXPECT_DOUBLE_EQ(areas.covered_inside_m2, 40 + 20);
  EXPECT_DOUBLE_EQ(areas.outside_m2, 32);
  EXPECT_DOUBLE_EQ(areas.repeated_m2, 5);
  EXPECT_DOUBLE_EQ(areas.sliver_m2, 0);
  EXPECT_DOUBLE_EQ(areas.missed_m2, 40);
  EXPECT_DOUBLE_EQ(areas.worked_times_m2[0], 40);
  EXPECT_DOUBLE_EQ(areas.worked_times_m2[1], 87);
  EXPECT_TRUE(std::isnan(areas.worked_times_m2[2]) && std::isnan(areas.worked_times_m2[3]));
  const double half = 0.25;  // centres of meshes lie half a mesh beyond lines of the grid
  EXPECT_EQ(engine.region(LandClass::kRepeated),
            (Region{{ring(quad_box(3 + half, 5 + half, 4 + half, 10 + half)), {}}}));
  EXPECT_DOUBLE_EQ(area(engine.region(LandClass::kOutside)), 32);
  EXPECT_DOUBLE_EQ(area(engine.region(LandClass::kMissed)), 40);
  EXPECT_DOUBLE_EQ(area(engine.region(LandClass::kOnce)), 87);
  EXPECT_TRUE(engine.region(LandClass::kSliver).empty());
}

// The way through the meshes of a boundary goes from centre to centre, a side of a mesh at a time: there are
// as many as sides of a mesh in the perimeter.
TEST(MeshCoverage, MeshesAreCountedAlongAllBoundaries) {
  const Region field{{ring(quad_box(0, 0, 10, 10)), {}}};
  MeshCoverage engine(field, 0.5);
  EXPECT_EQ(engine.meshes().missed.now, 80U);  // 40 m
  EXPECT_EQ(engine.meshes().covered.now, 0U);
  engine.add(step({quad_box(-2, 0, 4, 12)}));
  EXPECT_EQ(engine.meshes().covered.now, 72U);  // 36 m
  EXPECT_EQ(engine.meshes().missed.now, 64U);   // what is left, 6 m by 10 m
  engine.add(step({quad_box(6, 4, 8, 6)}));     // a piece of its own, and a hole in what is missed
  EXPECT_EQ(engine.meshes().covered.now, 72U + 16U);
  EXPECT_EQ(engine.meshes().missed.now, 64U + 16U);
  engine.add(step({quad_box(4, 0, 10, 12)}));  // all is one rectangle of 12 m by 12 m
  EXPECT_EQ(engine.meshes().covered.now, 96U);
  EXPECT_EQ(engine.meshes().covered.most, 96U);
  EXPECT_EQ(engine.meshes().missed.now, 0U);
  EXPECT_EQ(engine.meshes().missed.most, 80U);
  EXPECT_EQ(engine.meshes().side_m, 0.5);
}

// A strip that may have been worked is neither missed nor covered, until it is worked.
TEST(MeshCoverage, WhatWasNotRecordedByHand) {
  const Region field{{ring(quad_box(0, 0, 10, 10)), {}}};
  MeshCoverage engine(field, 0.5);
  engine.add(step({quad_box(0, 0, 2, 10)}));
  engine.add_unrecorded({quad_box(-2, 4, 12, 6)});  // 8 m of it in the field and open
  EXPECT_EQ(engine.areas().not_recorded_m2, 8 * 2);
  EXPECT_EQ(engine.areas().missed_m2, 100 - 20 - 16);
  EXPECT_EQ(engine.areas().worked_times_m2[0], 80);
  engine.add(step({quad_box(4, 0, 6, 10)}));
  EXPECT_EQ(engine.areas().not_recorded_m2, 6 * 2);
  EXPECT_EQ(engine.areas().missed_m2, 100 - 40 - 12);
  EXPECT_EQ(engine.areas().covered_inside_m2, 40);
  EXPECT_EQ(area(engine.region(LandClass::kUnrecorded)), 12);
  EXPECT_EQ(area(engine.region(LandClass::kMissed)), 48);
  MeshCoverage anywhere({}, 0.5);
  anywhere.add(step({quad_box(0, 0, 2, 10)}));
  anywhere.add_unrecorded({quad_box(-2, 4, 12, 6)});
  EXPECT_EQ(anywhere.areas().not_recorded_m2, 12 * 2);
  EXPECT_EQ(anywhere.areas().missed_m2, 0);
}

TEST(MeshCoverage, WithoutAFieldAllIsOutsideAndNothingMissed) {
  MeshCoverage engine({}, 0.5);
  engine.add(step({quad_box(1, 1, 3, 5)}));
  const CoverageAreas areas = engine.areas();
  EXPECT_DOUBLE_EQ(areas.covered_m2, 8);
  EXPECT_DOUBLE_EQ(areas.outside_m2, 8);
  EXPECT_DOUBLE_EQ(areas.covered_inside_m2, 0);
  EXPECT_DOUBLE_EQ(areas.missed_m2, 0);
}

TEST(MeshCoverage, WhatItCannotDoIsRefusedAndChangesNothing) {
  EXPECT_REFUSED(MeshCoverage({}, 0));
  EXPECT_REFUSED(MeshCoverage({}, std::nan("")));
  MeshCoverage engine({}, 0.05);
  EXPECT_REFUSED(engine.region(LandClass::kTwice));
  EXPECT_REFUSED(engine.region(LandClass::kOften));
  EXPECT_REFUSED(engine.add(step({quad_box(0, 0, 1, 1), quad_box(1e7, 0, 1e7 + 1, 1)})));
  EXPECT_EQ(engine.areas().gross_m2, 0);
}

TEST(MeshCoverage, RandomQuadsCornerByCorner) {
  constexpr int kBottom = -24, kTop = 24;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const std::vector<Ring> field = testing_meshes::random_rings(random, 17, 0.25);
    Region region{{field[0], {}}};
    MeshCoverage engine(region, 1);
    const CornerSet wanted = corners_of({field[0]}, kBottom, kTop);
    CornerSet covered(kBottom, kTop), repeated(kBottom, kTop);
    std::int64_t gross = 0;
    std::uniform_real_distribution<double> place(-15, 15), off(-7, 7);
    for (int i = 0; i < 25; ++i) {
      const Point at{place(random), place(random)};  // any four corners: bow-ties, concave ones, either sense
      Quad quad;
      for (Point& corner : quad) corner = rounded(at + Point{off(random), off(random)});
      if (i % 5 == 4)
        quad = quad_box(std::round(at.x), std::round(at.y), std::round(at.x) + 5, std::round(at.y) + 3);
      engine.add(step({quad}));
      const CornerSet ground = corners_of({ring(quad)}, kBottom, kTop);
      gross += ground.count();
      const CornerSet again = together(ground, covered, [](bool a, bool b) { return a && b; });
      repeated = together(repeated, again, [](bool a, bool b) { return a || b; });
      covered = together(covered, ground, [](bool a, bool b) { return a || b; });
    }
    const CornerSet inside = together(covered, wanted, [](bool a, bool b) { return a && b; });
    const CoverageAreas areas = engine.areas();
    EXPECT_EQ(areas.gross_m2, static_cast<double>(gross));
    EXPECT_EQ(areas.covered_m2, static_cast<double>(covered.count()));
    EXPECT_EQ(areas.repeated_m2, static_cast<double>(repeated.count()));
    EXPECT_EQ(areas.covered_inside_m2, static_cast<double>(inside.count()));
    EXPECT_EQ(areas.missed_m2, static_cast<double>(wanted.count() - inside.count()));
    EXPECT_EQ(areas.outside_m2, static_cast<double>(covered.count() - inside.count()));
    EXPECT_NEAR(area(engine.region(LandClass::kRepeated)), areas.repeated_m2, 1e-9);
    EXPECT_NEAR(area(engine.region(LandClass::kMissed)), areas.missed_m2, 1e-9);
    // What is kept up to date quad by quad is what comes out anew.
    const MeshRegion anew = combined(mesh_region({field[0]}, 1), engine.covered(), MeshOperation::kResidual);
    EXPECT_EQ(engine.missed().meshes(), anew.meshes());
    EXPECT_EQ(engine.region(LandClass::kMissed), region_of(anew, 1));
  }
}

TEST(MeshCoverage, AStraightDriveRepeatsNothing) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    const double heading = seed % 5 == 0 ? 0.25 * std::numbers::pi * static_cast<double>(seed % 8)
                                         : 2 * std::numbers::pi * share(random);
    const Point forward{std::sin(heading), std::cos(heading)};
    Point at{100 * share(random), 100 * share(random)};
    MeshCoverage engine({}, kMesh_m);
    double travel_m = 0;
    for (int i = 0; i < 60; ++i) {
      const double step_m = share(random);
      const Point to = at + step_m * forward;
      engine.add(step({between(bar(at, heading, 4), bar(to, heading, 4))}));
      travel_m += step_m;
      at = to;
    }
    EXPECT_EQ(engine.areas().repeated_m2, 0);
    EXPECT_EQ(engine.areas().covered_m2, engine.areas().gross_m2);
    // Half a mesh along an end and a side at most, both along the grid.
    EXPECT_NEAR(engine.areas().covered_m2, 4 * travel_m, kMesh_m * (4 + travel_m));
    EXPECT_EQ(engine.region(LandClass::kCovered).size(), 1U);
  }
}

TEST(MeshCoverage, ASpiralRepeatsWhatItsQuadsHaveInCommon) {
  // Two turns of a spiral whose pitch is less than the width.
  MeshCoverage engine({}, kFineMesh_m);
  Region quads, twice;
  Bar rear = bar({6, 0}, std::numbers::pi, 4);
  for (int i = 1; i <= 60; ++i) {
    const double angle = 4 * std::numbers::pi * i / 60, radius = 6 - 0.05 * i;
    const Bar front = bar({radius * std::cos(angle), -radius * std::sin(angle)}, std::numbers::pi + angle, 4);
    const Region quad{oriented({ring(between(rear, front)), {}})};
    ASSERT_FALSE(find_invalidity(quad.front()));
    engine.add(step({between(rear, front)}));
    for (Polygon& part : intersection(quad, unite(quads))) twice.push_back(std::move(part));
    quads.push_back(quad.front());
    rear = front;
  }
  const double covered_m2 = area(unite(quads)), repeated_m2 = area(unite(twice));
  EXPECT_GT(repeated_m2, 20);
  EXPECT_NEAR(engine.areas().covered_m2, covered_m2, 1e-3 * covered_m2);
  EXPECT_NEAR(engine.areas().repeated_m2, repeated_m2, 7e-3 * repeated_m2);
  const Region covered = engine.region(LandClass::kCovered);
  EXPECT_LT(area(symmetric_difference(covered, unite(quads))),
            kFineMesh_m * perimeter(covered.front().outer));
}

TEST(MeshCoverage, TheRoutesOverThePentagonAreWithinSevenParts) {
  for (const PentagonRoute& route : testing_routes::routes()) {
    SCOPED_TRACE(route.name);
    MeshCoverage engine(pentagon(), kMesh_m);
    for (const WorkedStep& worked : route.steps) engine.add(worked);
    const CoverageAreas areas = engine.areas();
    EXPECT_NEAR(areas.covered_m2, route.covered_m2, 7e-3 * route.covered_m2);
    EXPECT_NEAR(areas.repeated_m2, route.repeated_m2, route.repeated_m2 > 0 ? 7e-3 * route.repeated_m2 : 0.5);
    EXPECT_NEAR(areas.missed_m2, route.missed_m2, 0.5);
  }
}

}  // namespace
}  // namespace tramline::coverage
