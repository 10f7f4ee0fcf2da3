// Obstacles of other files. The field is 100 m x 50 m, its local frame centred on (50, 25).

#include <gtest/gtest.h>

#include "admission/feature.h"
#include "support/refusals.h"
#include "tramline/admission/read_obstacles.h"
#include "tramline/geometry/error.h"

namespace tramline::testing_features {
namespace {

RawDataset dataset(std::vector<RawFeature> features, const std::string& crs = "") {
  RawDataset out;
  out.file = "somewhere/pylons.geojson";
  out.layers.push_back({"pylons", "Unknown (any)", crs, std::move(features), 0});
  return out;
}

RawFeature point(double x, double y) {
  RawFeature out;
  out.fid = 12;
  out.geometry_type = "Point";
  out.points = {{x, y}};
  return out;
}

RawFeature line(std::vector<Point> points) {
  RawFeature out;
  out.fid = 13;
  out.geometry_type = "Line String";
  out.lines = {std::move(points)};
  return out;
}

class Obstacles : public testing::Test {
 protected:
  Field field_ = admit_one({"0 0, 100 0, 100 50, 0 50, 0 0", "10 10, 10 20, 20 20, 20 10, 10 10"});
  std::vector<char> met_;

  void place(std::vector<RawFeature> obstacles, ObstacleKind kind = ObstacleKind::kObstacle,
             double size_m = 7) {
    const auto loose = read_obstacles(dataset(std::move(obstacles)), kind, "");
    met_.assign(loose.size(), 0);
    place_obstacles(field_, loose, size_m, met_);
    expect_admissible(field_);
  }
};

TEST_F(Obstacles, APointBecomesASquareAlongTheAxes) {
  place({point(60, 30)});
  ASSERT_EQ(field_.obstacles.size(), 2u);
  EXPECT_EQ(field_.obstacles[1].origin, "pylons.geojson feature 12");
  EXPECT_NEAR(area(field_.obstacles[1].shape), 49, 1e-6);
  const Box box = bounds(field_.obstacles[1].shape);
  EXPECT_NEAR(box.min_x, 60 - 50 - 3.5, 1e-6);
  EXPECT_NEAR(box.max_y, 30 - 25 + 3.5, 1e-6);
}

TEST_F(Obstacles, ALineIsWidenedWithFlatEndsAndCutAtTheBoundary) {
  // From 30 m inside to 20 m outside the east edge, 2 m wide: 60 m² inside.
  place({line({{70, 30}, {120, 30}})}, ObstacleKind::kObstacle, 2);
  ASSERT_EQ(field_.obstacles.size(), 2u);
  EXPECT_NEAR(area(field_.obstacles[1].shape), 60, 1e-3);
}

TEST_F(Obstacles, OneThatOverlapsAHoleIsUnitedWithIt) {
  // A 10 m square over the right half of the hole: 100 + 100 − 50.
  place({feature({{"15 10, 25 10, 25 20, 15 20, 15 10"}})});
  ASSERT_EQ(field_.obstacles.size(), 1u);
  EXPECT_EQ(field_.obstacles[0].origin, "hole 1 + pylons.geojson feature 7");
  EXPECT_NEAR(workable_m2(field_), 4850, 1e-3);
  // The user asked for it: nothing had to be repaired.
  EXPECT_TRUE(field_.repairs.empty());
}

TEST_F(Obstacles, OneElsewhereIsIgnoredAndNotMarkedAsMet) {
  place({point(500, 500), point(60, 30)});
  EXPECT_EQ(field_.obstacles.size(), 2u);
  EXPECT_EQ(met_, (std::vector<char>{0, 1}));
}

TEST_F(Obstacles, APointJustOutsideReachesIn) {
  // Centre 2 m outside the east edge: 1.5 m of the 7 m square are inside.
  place({point(102, 30)});
  ASSERT_EQ(field_.obstacles.size(), 2u);
  EXPECT_NEAR(area(field_.obstacles[1].shape), 1.5 * 7, 1e-3);
}

TEST_F(Obstacles, PassableStripsStayPassableAndGiveWayToObstacles) {
  // A strip 4 m wide from south to north, through the hole: 4 x 50 less 4 x 10.
  place({feature({{"12 -5, 16 -5, 16 60, 12 60, 12 -5"}})}, ObstacleKind::kPassable);
  double passable_m2 = 0;
  for (const Obstacle& obstacle : field_.obstacles)
    if (obstacle.kind == ObstacleKind::kPassable) passable_m2 += area(obstacle.shape);
  EXPECT_NEAR(passable_m2, 160, 1e-3);
  EXPECT_EQ(field_.obstacles.size(), 3u);
  EXPECT_NEAR(workable_m2(field_), 4900, 1e-3);
}

TEST_F(Obstacles, AnObstaclePolygonKeepsTheLandInItsHole) {
  // A hedge round a garden: 20 x 20 with a hole of 10 x 10.
  place({feature({{"40 20, 60 20, 60 40, 40 40, 40 20", "45 25, 45 35, 55 35, 55 25, 45 25"}})});
  ASSERT_EQ(field_.obstacles.size(), 2u);
  EXPECT_NEAR(area(field_.obstacles[1].shape), 300, 1e-3);
}

TEST_F(Obstacles, CoveringTheWholeFieldIsRefused) {
  EXPECT_REFUSED(place({feature({{"-1 -1, 101 -1, 101 51, -1 51, -1 -1"}})}));
}

TEST(ObstacleFiles, AnyCrsIsBroughtIntoTheFieldsFrame) {
  const Crs utm("EPSG:25832");
  const RawFeature raw =
      feature({{"499950 5500000, 500050 5500000, 500050 5500100, 499950 5500100, 499950 5500000"}});
  Field field = admit(raw, {"farm.gpkg", "parcels", &utm}).fields.front();
  // The middle of the field in degrees: on the 9th meridian.
  const Point centre = utm.to_lonlat({500000, 5500050}).value();
  const auto loose =
      read_obstacles(dataset({point(centre.x, centre.y)}, "EPSG:4326"), ObstacleKind::kObstacle, "EPSG:4326");
  std::vector<char> met(1, 0);
  place_obstacles(field, loose, 7, met);
  ASSERT_EQ(field.obstacles.size(), 1u);
  EXPECT_NEAR(area(field.obstacles[0].shape), 49, 1e-3);
  EXPECT_NEAR(bounds(field.obstacles[0].shape).centre().x, 0, 0.02);
}

TEST(ObstacleFiles, FaultsAreRefusedRatherThanDropped) {
  EXPECT_REFUSED(read_obstacles(dataset({point(10, 95)}, "EPSG:4326"), ObstacleKind::kObstacle, "EPSG:4326"));
  EXPECT_REFUSED(read_obstacles(dataset({RawFeature{}}), ObstacleKind::kObstacle, ""));
  // Degrees cannot be placed in a field of plain metres.
  EXPECT_REFUSED(read_obstacles(dataset({point(10, 50)}, "EPSG:4326"), ObstacleKind::kObstacle, ""));
}

}  // namespace
}  // namespace tramline::testing_features
