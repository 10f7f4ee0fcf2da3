// Where exported shapes lie: held against GDAL's own way from the plan file to the same coordinates.

#include <cmath>
#include <memory>

#include "io/export/export_fixture.h"
#include "support/refusals.h"

namespace tramline::io {
namespace {

using testing_support::bytes_of;

/// Every vertex of the plan's layer has to be among those of the exported one within `most`; the ring may
/// begin elsewhere. What is more has to lie on the plan's lines, as far as kMostAside_m goes.
void expect_same_places(OGRLayer& plan, OGRLayer& file, double most) {
  ASSERT_EQ(plan.GetFeatureCount(), file.GetFeatureCount());
  OGRSpatialReference from(*plan.GetSpatialRef()), to(*file.GetSpatialRef());
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> way(OGRCreateCoordinateTransformation(&from, &to));
  ASSERT_NE(way, nullptr);
  for (const auto& feature : plan) {
    const OGRFeatureUniquePtr found(file.GetNextFeature());
    ASSERT_NE(found, nullptr);
    const auto expected = feature->StealGeometry();
    const std::unique_ptr<OGRGeometry> planned(expected);
    ASSERT_EQ(planned->transform(way.get()), OGRERR_NONE);
    const OGRSimpleCurve* a = curve_of(planned.get());
    const OGRSimpleCurve* b = curve_of(found->GetGeometryRef());
    ASSERT_GE(b->getNumPoints(), a->getNumPoints());
    for (int i = 0; i < a->getNumPoints(); ++i) {
      double nearest_x = HUGE_VAL, nearest_y = HUGE_VAL;
      for (int j = 0; j < b->getNumPoints(); ++j) {
        const double x = std::abs(a->getX(i) - b->getX(j)), y = std::abs(a->getY(i) - b->getY(j));
        if (std::max(x, y) < std::max(nearest_x, nearest_y)) nearest_x = x, nearest_y = y;
      }
      EXPECT_LT(nearest_x, most);
      EXPECT_LT(nearest_y, most);
    }
  }
}

TEST_F(ExportTest, GeoJsonHasTheTracksInDegrees) {
  const ExportReport report = exported("tracks.geojson", "", {"tracks"});
  ASSERT_EQ(report.layers.size(), 1u);
  EXPECT_EQ(report.layers[0].name, "tracks");
  EXPECT_EQ(report.layers[0].features, 3);
  EXPECT_EQ(report.field_id, "Große Breite");
  const auto plan = open(plan_file()), file = open(folder_ / "tracks.geojson");
  ASSERT_EQ(file->GetLayerCount(), 1);
  expect_same_places(*plan->GetLayerByName("tracks"), *file->GetLayer(0), 1e-8);
  EXPECT_EQ(bytes_of(folder_ / "tracks.geojson").find("\"crs\""), std::string::npos) << "RFC 7946 has none";
}

TEST_F(ExportTest, KmlHasTheTracksInDegrees) {
  exported("tracks.kml");
  const auto plan = open(plan_file()), file = open(folder_ / "tracks.kml");
  expect_same_places(*plan->GetLayerByName("tracks"), *file->GetLayerByName("tracks"), 1e-8);
  EXPECT_NE(bytes_of(folder_ / "tracks.kml").find("<name>Track 2</name>"), std::string::npos);
}

TEST_F(ExportTest, FlatGeobufIsInTheCrsOfTheFieldsFile) {
  EXPECT_EQ(exported("tracks.fgb", "", {"tracks"}).crs, "ETRS89 / UTM zone 33N (EPSG:25833)");
  const auto plan = open(plan_file()), file = open(folder_ / "tracks.fgb");
  EXPECT_STREQ(file->GetLayer(0)->GetSpatialRef()->GetAuthorityCode(nullptr), "25833");
  expect_same_places(*plan->GetLayerByName("tracks"), *file->GetLayer(0), 1e-4);
}

TEST_F(ExportTest, ShapefilesHaveEveryLayerWithShapes) {
  for (const char* crs : {"source", "wgs84", "EPSG:3035", "EPSG:3857"}) {
    SCOPED_TRACE(crs);
    const ExportReport report = exported("plan.zip", crs);
    EXPECT_EQ(report.layers.size(), 14u);
    const auto plan = open(plan_file()), file = open("/vsizip/" + (folder_ / "plan.zip").string());
    EXPECT_EQ(file->GetLayerCount(), 14);
    const double most = std::string(crs) == "wgs84" ? 1e-9 : 1e-3;
    for (const char* layer : {"field", "obstacles", "body", "headland", "subfields", "headland_passes",
                              "tracks", "swaths", "uncovered", "dropped"})
      expect_same_places(*plan->GetLayerByName(layer), *file->GetLayerByName(layer), most);
  }
}

// A straight line of the field's plane is none in degrees.
TEST_F(ExportTest, LongLinesStayWhereTheyWerePlanned) {
  exported("tracks.geojson");
  const auto plan = open(plan_file()), file = open(folder_ / "tracks.geojson");
  OGRSpatialReference local(*plan->GetLayerByName("tracks")->GetSpatialRef()), degrees;
  degrees.SetWellKnownGeogCS("WGS84");
  local.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> back(
      OGRCreateCoordinateTransformation(&degrees, &local));
  const OGRFeatureUniquePtr track(file->GetLayer(0)->GetNextFeature());
  const OGRLineString* line = track->GetGeometryRef()->toLineString();
  ASSERT_GT(line->getNumPoints(), 2);
  for (int i = 0; i + 1 < line->getNumPoints(); ++i)
    for (const double share : {0.0, 0.25, 0.5, 0.75}) {
      double x = line->getX(i) + share * (line->getX(i + 1) - line->getX(i));
      double y = line->getY(i) + share * (line->getY(i + 1) - line->getY(i));
      ASSERT_TRUE(back->Transform(1, &x, &y));
      EXPECT_NEAR(y, 200.5 + 0.75 * (x + 1500.123) / 3000, 0.0101);
    }
  const OGRFeatureUniquePtr second(file->GetLayer(0)->GetNextFeature());
  OGRLayer* planned = plan->GetLayerByName("tracks");
  const OGRFeatureUniquePtr second_planned(planned->GetFeature(2));
  EXPECT_EQ(second->GetGeometryRef()->toLineString()->getNumPoints(),
            second_planned->GetGeometryRef()->toLineString()->getNumPoints())
      << "short lines need no more points";
}

/// How far the vertices of one line lie from the edges of another, m.
double off_line(const OGRSimpleCurve& points, const OGRSimpleCurve& line) {
  double out = 0;
  for (int i = 0; i < points.getNumPoints(); ++i) {
    OGRPoint p;
    points.getPoint(i, &p);
    out = std::max(out, p.Distance(&line));
  }
  return out;
}

// GDAL measures. The bound holds both ways: for vertices left out, and for those that stayed.
TEST_F(ExportTest, ShapesStayWithinTheTolerance) {
  for (const double tolerance_m : {0.02, 0.2}) {
    SCOPED_TRACE(tolerance_m);
    exported("plan.zip", "EPSG:25833", {}, 0);
    const auto all = open("/vsizip/" + (folder_ / "plan.zip").string());
    exported("few.zip", "EPSG:25833", {}, tolerance_m);
    const auto few = open("/vsizip/" + (folder_ / "few.zip").string());
    for (const char* layer : {"tracks", "headland_passes", "swaths", "body"}) {
      SCOPED_TRACE(layer);
      OGRLayer *from = all->GetLayerByName(layer), *to = few->GetLayerByName(layer);
      int points_before = 0, points_after = 0;
      for (const auto& feature : *from) {
        const OGRFeatureUniquePtr thin(to->GetNextFeature());
        const OGRSimpleCurve *a = curve_of(feature->GetGeometryRef()), *b = curve_of(thin->GetGeometryRef());
        EXPECT_LE(off_line(*a, *b), tolerance_m);
        EXPECT_LE(off_line(*b, *a), tolerance_m);
        points_before += a->getNumPoints();
        points_after += b->getNumPoints();
      }
      EXPECT_LE(points_after, points_before);
      if (std::string(layer) == "headland_passes") {
        EXPECT_GT(points_before, 1000);
        EXPECT_LT(points_after, 150);
      }
    }
  }
}

TEST_F(ExportTest, FieldAndObstaclesKeepTheirVertices) {
  Plan plan = sample_plan();
  plan.field.outer.insert(plan.field.outer.begin() + 1, {0, -290});  // on the line from corner to corner
  write_plan(plan, plan_file());
  exported("plan.zip", "source", {}, 5);
  const auto file = open("/vsizip/" + (folder_ / "plan.zip").string());
  const OGRFeatureUniquePtr field(file->GetLayerByName("field")->GetNextFeature());
  EXPECT_GE(curve_of(field->GetGeometryRef())->getNumPoints(), 6);
  const OGRFeatureUniquePtr obstacle(file->GetLayerByName("obstacles")->GetNextFeature());
  EXPECT_EQ(curve_of(obstacle->GetGeometryRef())->getNumPoints(), 5);
}

// What is narrower than the tolerance must not become a line.
TEST_F(ExportTest, SliversKeepTheirVertices) {
  Plan plan = sample_plan();
  plan.uncovered = {{{{0, 100}, {50, 100.001}, {100, 100}, {50, 99.999}}, {}}};
  write_plan(plan, plan_file());
  exported("u.fgb", "source", {"uncovered"}, 0.02);
  const auto file = open(folder_ / "u.fgb");
  const OGRFeatureUniquePtr sliver(file->GetLayer(0)->GetNextFeature());
  EXPECT_EQ(curve_of(sliver->GetGeometryRef())->getNumPoints(), 5);
  EXPECT_TRUE(sliver->GetGeometryRef()->IsValid());
}

TEST_F(ExportTest, AToleranceThatIsNoneIsRefused) {
  for (const double tolerance_m : {-0.01, 10.5, std::nan("")})
    EXPECT_REFUSED(exported("t.fgb", "", {}, tolerance_m));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "t.fgb"));
}

TEST_F(ExportTest, PlainMetresStayPlain) {
  Plan plan = sample_plan();
  plan.field.frame = {false, 0, 0, 1000, 2000};
  plan.field.source.input_crs = "none";
  write_plan(plan, plan_file());
  EXPECT_EQ(exported("plan.zip").crs, "plain metres");
  exported("tracks.fgb", "source");
  for (const std::string& name : {std::string("/vsizip/") + (folder_ / "plan.zip").string() + "/tracks.shp",
                                  (folder_ / "tracks.fgb").string()}) {
    const auto file = open(name);
    const OGRFeatureUniquePtr track(file->GetLayer(0)->GetNextFeature());
    const OGRLineString* line = track->GetGeometryRef()->toLineString();
    ASSERT_EQ(line->getNumPoints(), 2);
    EXPECT_NEAR(line->getX(0), 1000 - 1500.123, 1e-9);
    EXPECT_NEAR(line->getY(1), 2000 + 201.25, 1e-9);
  }
  EXPECT_NE(refusal("tracks.geojson").value_or("").find("plain metres"), std::string::npos);
  EXPECT_NE(refusal("tracks.kml", "source").value_or("").find("plain metres"), std::string::npos);
  EXPECT_NE(refusal("t.fgb", "EPSG:25833").value_or("").find("plain metres"), std::string::npos);
}

}  // namespace
}  // namespace tramline::io
