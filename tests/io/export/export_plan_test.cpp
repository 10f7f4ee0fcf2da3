// What is exported is read back through GDAL, and held against GDAL's own way from the plan file to the
// same coordinates.

#include "tramline/io/export/export_plan.h"
#include "support/refusals.h"
#include "support/temporary_folder.h"

#include <cpl_conv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <set>

#include "tramline/geometry/error.h"
#include "tramline/io/export/column_names.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline::io {
namespace {

using testing_support::TemporaryFolder;

namespace fs = std::filesystem;

/// A field near Neubrandenburg with a track of 3 km across degrees, one with a detour, and layers with
/// nothing in them.
Plan sample_plan() {
  Plan plan;
  plan.field.id = "Große Breite";
  plan.field.outer = {{-1600, -300}, {1600, -280}, {1580, 310}, {-1590, 300}};
  plan.field.obstacles = {
      {{{{10, 10}, {14, 10}, {14, 13}, {10, 13}}, {}}, ObstacleKind::kObstacle, "hole 1"}};
  plan.field.frame = {true, 13.2612345, 53.5512345, 0, 0};
  plan.field.source = {"fields.gpkg", "parcels", 7, 0};
  plan.field.source.input_crs = "EPSG:25833";
  plan.machine = {"sprayer", 6, 5, 2};
  plan.body = {{plan.field.outer, {{{10, 10}, {10, 13}, {14, 13}, {14, 10}}}}};
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(90))}};
  TrackPiece straight{{-1500.123, 200.5}, {1499.877, 201.25}, 0, 0, false, true, false};
  TrackPiece round{{-200, 5}, {200, 5}, 0, 1, true, false, false};
  round.detours = {{{{{-30, 5}, {-24, 4}, -2 / 37.0}, {{-24, 4}, {-12, 4}, 0}, {{-12, 4}, {0, 5}, 2 / 145.0}},
                    Passing::kLeft,
                    {0}}};
  TrackPiece bend{{-100, 40}, {-60, 50}, 0, 2};
  bend.curve = {{{-100, 40}, {-80, 40}, 0}, {{-80, 40}, {-60, 50}, 1 / 25.0}};
  plan.pieces = {straight, round, bend};
  plan.headland.ground = {{{{-1600, -300}, {1600, -280}, {1590, -270}, {-1590, -290}}, {}}};
  plan.headland.passes = {{{{{10, 100}, {50, 100}, 0},
                            {{50, 100}, {50, 120}, 0.1},
                            {{50, 120}, {10, 120}, 0},
                            {{10, 120}, {10, 100}, 0.1}},
                           1,
                           true,
                           {}}};
  plan.uncovered = {{{{7, 5}, {8, 5}, {8, 6}}, {}}, {{{7, 15}, {8, 15}, {8, 16}}, {}}};
  plan.tally.pieces = 3;
  return plan;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class ExportTest : public testing::Test {
 protected:
  void SetUp() override {
    GDALAllRegister();
    unsetenv("SOURCE_DATE_EPOCH");
    write_plan(sample_plan(), plan_file());
  }
  void TearDown() override { unsetenv("SOURCE_DATE_EPOCH"); }
  fs::path plan_file() const { return folder_ / "plan.gpkg"; }
  /// Every vertex as it is, where no tolerance is given.
  ExportReport exported(const char* name, const char* crs = "", const std::vector<std::string>& layers = {},
                        double tolerance_m = 0) const {
    return export_plan({plan_file(), folder_ / name, crs, layers, tolerance_m});
  }
  std::optional<std::string> refusal(const char* name, const char* crs = "",
                                     const std::vector<std::string>& layers = {}) const {
    try {
      exported(name, crs, layers);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
      EXPECT_FALSE(fs::exists(folder_ / name));
      return error.what();
    }
    return std::nullopt;
  }
  GDALDatasetUniquePtr open(const std::string& path) const {
    GDALDatasetUniquePtr out(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
    EXPECT_NE(out, nullptr) << path;
    return out;
  }
  TemporaryFolder folder_;
};

const OGRSimpleCurve* curve_of(const OGRGeometry* shape) {
  if (wkbFlatten(shape->getGeometryType()) == wkbPolygon) return shape->toPolygon()->getExteriorRing();
  return shape->toSimpleCurve();
}

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
  const ExportReport report = exported("tracks.geojson");
  ASSERT_EQ(report.layers.size(), 1u);
  EXPECT_EQ(report.layers[0].name, "tracks");
  EXPECT_EQ(report.layers[0].features, 3);
  EXPECT_EQ(report.field_id, "Große Breite");
  const auto plan = open(plan_file()), file = open(folder_ / "tracks.geojson");
  ASSERT_EQ(file->GetLayerCount(), 1);
  expect_same_places(*plan->GetLayerByName("tracks"), *file->GetLayer(0), 1e-8);
  EXPECT_EQ(bytes_of(folder_ / "tracks.geojson").find("\"crs\""), std::string::npos) << "RFC 7946 has none";
}

TEST_F(ExportTest, PolygonsOfGeoJsonFollowTheRightHand) {
  exported("u.geojson", "", {"body"});
  const auto file = open(folder_ / "u.geojson");
  const OGRFeatureUniquePtr feature(file->GetLayer(0)->GetNextFeature());
  const OGRPolygon* polygon = feature->GetGeometryRef()->toPolygon();
  EXPECT_FALSE(polygon->getExteriorRing()->isClockwise());
  ASSERT_EQ(polygon->getNumInteriorRings(), 1);
  EXPECT_TRUE(polygon->getInteriorRing(0)->isClockwise());
}

TEST_F(ExportTest, KmlHasTheTracksInDegrees) {
  exported("tracks.kml");
  const auto plan = open(plan_file()), file = open(folder_ / "tracks.kml");
  expect_same_places(*plan->GetLayerByName("tracks"), *file->GetLayerByName("tracks"), 1e-8);
  EXPECT_NE(bytes_of(folder_ / "tracks.kml").find("<name>Track 2</name>"), std::string::npos);
}

TEST_F(ExportTest, KmlTellsHeadlandPassesFromTracks) {
  exported("lines.kml", "", {"headland_passes", "tracks"});
  const std::string kml = bytes_of(folder_ / "lines.kml");
  EXPECT_NE(kml.find("<name>Headland pass 1</name>"), std::string::npos);
  EXPECT_NE(kml.find("FF1D4E7A"), std::string::npos) << "the colour of headland passes, as KML has it";
  EXPECT_NE(kml.find("FF3B463A"), std::string::npos) << "that of tracks";
}

TEST_F(ExportTest, FlatGeobufIsInTheCrsOfTheFieldsFile) {
  EXPECT_EQ(exported("tracks.fgb").crs, "ETRS89 / UTM zone 33N (EPSG:25833)");
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

TEST_F(ExportTest, ShapefilesSayTheirCrsAndEncoding) {
  exported("plan.zip");
  const std::string zip = "/vsizip/" + (folder_ / "plan.zip").string() + "/";
  for (const char* name : {"tracks.prj", "tracks.cpg", "dropped.shp", "dropped.prj", "encounters.dbf"}) {
    VSIStatBufL status;
    EXPECT_EQ(VSIStatL((zip + name).c_str(), &status), 0) << name;
  }
  const auto file = open(zip + "field.shp");
  const OGRFeatureUniquePtr feature(file->GetLayer(0)->GetNextFeature());
  EXPECT_STREQ(feature->GetFieldAsString("field_id"), "Große Breite");
}

TEST_F(ExportTest, ShapefileNamesAreShortAndNoneIsTakenTwice) {
  const auto plan = open(plan_file());
  int columns = 0;
  for (OGRLayer* layer : plan->GetLayers()) {
    std::set<std::string> taken;
    for (int i = 0; i < layer->GetLayerDefn()->GetFieldCount(); ++i) {
      const OGRFieldDefn* column = layer->GetLayerDefn()->GetFieldDefn(i);
      if (layer->GetGeomType() == wkbNone || stays_in_plan_file(column->GetNameRef())) continue;
      ++columns;
      const std::string name = shapefile_name(column->GetNameRef());
      EXPECT_LE(name.size(), 10u);
      EXPECT_TRUE(taken.insert(name).second) << layer->GetName() << ": " << name;
      // Cut is not shortened: a column that is new has to be given a name.
      EXPECT_TRUE(name.size() < 10 || name == column->GetNameRef() || name == "min_radius" ||
                  name == "stop_start")
          << column->GetNameRef() << " has no short name";
    }
  }
  EXPECT_GT(columns, 30);
}

TEST_F(ExportTest, AttributesAreKept) {
  exported("plan.zip");
  exported("tracks.fgb");
  const auto shapes = open("/vsizip/" + (folder_ / "plan.zip").string()),
             single = open(folder_ / "tracks.fgb");
  struct Names {
    OGRLayer* layer;
    const char *heading, *stop_at_end, *detours;
  };
  for (const Names& names : {Names{shapes->GetLayerByName("tracks"), "heading", "stop_end", "detours"},
                             Names{single->GetLayer(0), "heading_deg", "stop_at_end", "detour_count"}}) {
    const OGRFeatureUniquePtr first(names.layer->GetNextFeature()), second(names.layer->GetNextFeature());
    EXPECT_EQ(first->GetFieldAsInteger("order"), 1);
    EXPECT_EQ(second->GetFieldAsInteger("track"), 2);
    EXPECT_EQ(second->GetFieldAsInteger("subfield"), 1);
    EXPECT_STREQ(second->GetFieldAsString("kind"), "detour");
    EXPECT_STREQ(second->GetFieldAsString("sides"), "left");
    EXPECT_NEAR(first->GetFieldAsDouble("length_m"), std::hypot(3000, 0.75), 1e-5);
    EXPECT_NEAR(first->GetFieldAsDouble(names.heading), 89.98567, 1e-4);
    EXPECT_EQ(first->GetFieldAsInteger(names.stop_at_end), 1);
    EXPECT_EQ(second->GetFieldAsInteger(names.stop_at_end), 0);
    EXPECT_EQ(first->GetFieldAsInteger(names.detours), 0);
    EXPECT_EQ(second->GetFieldAsInteger(names.detours), 1);
    EXPECT_EQ(first->GetFieldIndex("path"), -1);
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
  EXPECT_FALSE(fs::exists(folder_ / "t.fgb"));
}

TEST_F(ExportTest, TheSamePlanGivesTheSameBytes) {
  for (const char* extension : {".geojson", ".fgb", ".kml", ".zip"}) {
    exported((std::string("a") + extension).c_str());
    const std::string a = bytes_of(folder_ / (std::string("a") + extension));
    exported((std::string("other") + extension).c_str());
    EXPECT_EQ(bytes_of(folder_ / (std::string("other") + extension)), a) << extension;
    EXPECT_FALSE(a.empty());
  }
  const std::string zip = bytes_of(folder_ / "a.zip");
  setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  exported("b.zip");
  const std::string later = bytes_of(folder_ / "b.zip");
  EXPECT_NE(later, zip);
  exported("c.zip");
  EXPECT_EQ(bytes_of(folder_ / "c.zip"), later);
  const auto file = open("/vsizip/" + (folder_ / "c.zip").string());
  EXPECT_STREQ(file->GetLayerByName("tracks")->GetMetadataItem("DBF_DATE_LAST_UPDATE"), "2023-11-14");
}

TEST_F(ExportTest, LongTextsAreCutInShapefilesAndNamed) {
  Plan plan = sample_plan();
  plan.field.obstacles[0].origin = "ü" + std::string(300, 'x');
  write_plan(plan, plan_file());
  const ExportReport report = exported("plan.zip");
  ASSERT_EQ(report.shortened.size(), 1u);
  EXPECT_EQ(report.shortened[0].what, "origin");
  EXPECT_EQ(report.shortened[0].where, "layer obstacles, feature 1");
  EXPECT_TRUE(exported("o.geojson", "", {"obstacles"}).shortened.empty());
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

TEST_F(ExportTest, RefusesWhatCannotBeWithOneSentence) {
  const auto says = [&](const std::optional<std::string>& sentence, const char* words) {
    EXPECT_NE(sentence.value_or("nothing was refused").find(words), std::string::npos) << *sentence;
  };
  says(refusal("tracks.shp"), ".geojson, .fgb (FlatGeobuf), .kml or .zip (Shapefiles)");
  says(refusal("t.geojson", "EPSG:25833"), "GeoJSON is always in WGS 84");
  says(refusal("t.geojson", "source"), "GeoJSON is always in WGS 84");
  says(refusal("t.kml", "EPSG:3857"), "KML is always in WGS 84");
  says(refusal("t.fgb", "EPSG:999999"), "EPSG:999999");
  says(refusal("t.fgb", "none"), "--crs none");
  says(refusal("t.fgb", "EPSG:2193"), "outside the area of");  // New Zealand
  says(refusal("t.fgb", "", {"lanes"}), "'lanes'");
  says(refusal("t.zip", "", {"metadata"}), "'metadata'");
  says(refusal("t.fgb", "", {"tracks", "swaths"}), "one layer");
  says(refusal("t.fgb", "", {"dropped"}), "layer dropped");
  says(refusal("t.zip", "", {"dropped", "overlap"}), "dropped, overlap");
  Plan plan = sample_plan();
  plan.field.source.input_crs = "";
  write_plan(plan, plan_file());
  says(refusal("t.fgb"), "name one with --crs");
  EXPECT_EQ(exported("t.fgb", "wgs84").crs, "WGS 84 (EPSG:4326)");
  std::ofstream(plan_file()) << "no plan";
  says(refusal("t.geojson"), "no GeoPackage");
}

TEST_F(ExportTest, Wgs84ByAnyNameIsFineForGeoJson) {
  for (const char* crs : {"wgs84", "WGS84", "EPSG:4326", "OGC:CRS84"}) {
    exported("t.geojson", crs);
    const std::string bytes = bytes_of(folder_ / "t.geojson");
    exported("u.geojson");
    EXPECT_EQ(bytes_of(folder_ / "u.geojson"), bytes) << crs;
  }
}

}  // namespace
}  // namespace tramline::io
