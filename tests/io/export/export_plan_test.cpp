// What is exported is read back through GDAL: layers, attributes, names, bytes, refusals.

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>

#include "io/export/export_fixture.h"
#include "tramline/io/export/column_names.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;

using testing_support::bytes_of;

TEST_F(ExportTest, PolygonsOfGeoJsonFollowTheRightHand) {
  exported("u.geojson", "", {"body"});
  const auto file = open(folder_ / "u.geojson");
  const OGRFeatureUniquePtr feature(file->GetLayer(0)->GetNextFeature());
  const OGRPolygon* polygon = feature->GetGeometryRef()->toPolygon();
  EXPECT_FALSE(polygon->getExteriorRing()->isClockwise());
  ASSERT_EQ(polygon->getNumInteriorRings(), 1);
  EXPECT_TRUE(polygon->getInteriorRing(0)->isClockwise());
}

TEST_F(ExportTest, KmlTellsHeadlandPassesFromTracks) {
  exported("lines.kml", "", {"headland_passes", "tracks"});
  const std::string kml = bytes_of(folder_ / "lines.kml");
  EXPECT_NE(kml.find("<name>Headland pass 1</name>"), std::string::npos);
  EXPECT_NE(kml.find("FF1D4E7A"), std::string::npos) << "the colour of headland passes, as KML has it";
  EXPECT_NE(kml.find("FF3B463A"), std::string::npos) << "that of tracks";
}

TEST_F(ExportTest, ASingleLayerHoldsTheTracksAndThenThePasses) {
  for (const char* name : {"lines.geojson", "lines.fgb"}) {
    const ExportReport report = exported(name);
    ASSERT_EQ(report.layers.size(), 2u) << name;
    EXPECT_EQ(report.layers[0].name, "tracks");
    EXPECT_EQ(report.layers[0].features, 3);
    EXPECT_EQ(report.layers[1].name, "headland_passes");
    EXPECT_EQ(report.layers[1].features, 1);
    const auto file = open(folder_ / name);
    ASSERT_EQ(file->GetLayerCount(), 1);
    OGRLayer* layer = file->GetLayer(0);
    EXPECT_STREQ(layer->GetName(), "tracks");
    ASSERT_EQ(layer->GetFeatureCount(), 4);
    std::vector<OGRFeatureUniquePtr> features;
    while (OGRFeatureUniquePtr feature{layer->GetNextFeature()}) features.push_back(std::move(feature));
    EXPECT_EQ(features[0]->GetFieldAsInteger("order"), 1);
    const OGRFeature& pass = *features[3];
    EXPECT_STREQ(pass.GetFieldAsString("kind"), "headland");
    EXPECT_EQ(pass.GetFieldAsInteger("number"), 1);
    EXPECT_EQ(pass.GetFieldAsInteger("around_field"), 1);
    EXPECT_NEAR(pass.GetFieldAsDouble("length_m"), 80 + 20 * std::acos(-1.0), 1e-6);
    EXPECT_FALSE(pass.IsFieldSetAndNotNull(pass.GetFieldIndex("order")));
    EXPECT_FALSE(features[0]->IsFieldSetAndNotNull(features[0]->GetFieldIndex("number")));
  }
}

TEST_F(ExportTest, TracksAloneAreThoseAsked) {
  const ExportReport report = exported("tracks.geojson", "", {"tracks"});
  ASSERT_EQ(report.layers.size(), 1u);
  EXPECT_EQ(open(folder_ / "tracks.geojson")->GetLayer(0)->GetFeatureCount(), 3);
}

TEST_F(ExportTest, KmlHasAFolderOfPassesWhereThereAreSome) {
  EXPECT_EQ(exported("all.kml").layers.size(), 2u);
  EXPECT_EQ(open(folder_ / "all.kml")->GetLayerCount(), 2);
}

// By hand: the bend of the sample plan is a line of 20 m and an arc of 25 m radius.
TEST_F(ExportTest, ExactPathsStandBesideChords) {
  for (const char* name : {"paths.geojson", "paths.fgb", "paths.kml"}) {
    exported(name, "", {"tracks"}, 0.05);
    const auto file = open(folder_ / name);
    OGRLayer* layer = file->GetLayer(0);
    OGRFeatureUniquePtr bend;
    while (OGRFeatureUniquePtr feature{layer->GetNextFeature()}) bend = std::move(feature);
    const std::string text = bend->GetFieldAsString("exact_path");
    EXPECT_NE(text.find(" within 0.05: -100 40; -80 40 0; -60 50 0.04"), std::string::npos) << name << text;
    EXPECT_TRUE(text.starts_with("tmerc ")) << text;
    EXPECT_LT(bend->GetFieldIndex("path"), 0);
  }
  exported("paths.zip");
  EXPECT_LT(open("/vsizip/" + (folder_ / "paths.zip").string() + "/tracks.shp")
                ->GetLayer(0)
                ->GetLayerDefn()
                ->GetFieldIndex("exact_path"),
            0);
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
      if (layer->GetGeomType() == wkbNone || stays_in_plan_file(layer->GetName(), column->GetNameRef()))
        continue;
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
  says(refusal("t.geojson"), "not a GeoPackage");
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
