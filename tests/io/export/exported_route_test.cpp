// The route in exports: a feature for each leg, in driving order, with its kind.

#include <cmath>
#include <numbers>

#include "io/export/export_fixture.h"

namespace tramline::io {
namespace {

using testing_support::bytes_of;

RouteLeg leg(LegKind kind, SteeredPath path, double time_s) {
  RouteLeg out{kind, path.front().gear, kind == LegKind::kWork, std::move(path)};
  out.time_s = time_s;
  return out;
}

Pose start() { return {{10, 10}, Heading::clockwise_from_north(Angle::degrees(90))}; }

/// 100 m of a track, half a circle of 6 m, 5 m in reverse and a leg without length.
Plan plan_with_route() {
  Plan plan = sample_plan();
  auto& legs = plan.route.legs;
  legs.push_back(leg(LegKind::kWork, {arc_from(start(), 100, 0, Gear::kForward)}, 40));
  legs.back().piece = 2;
  legs.push_back(leg(LegKind::kTurn,
                     {arc_from(end_of(legs[0].path.back()), 6 * std::numbers::pi, 1 / 6.0, Gear::kForward)},
                     12.5));
  legs.back().missing_m = 0.25;
  legs.push_back(leg(LegKind::kBackOut, {arc_from(end_of(legs[1].path.back()), 5, 0, Gear::kReverse)}, 8));
  legs.push_back(leg(LegKind::kTransit, {arc_from(end_of(legs[2].path.back()), 0, 0, Gear::kForward)}, 0));
  return plan;
}

class ExportedRoute : public ExportTest {
 protected:
  void SetUp() override {
    ExportTest::SetUp();
    write_plan(plan_with_route(), plan_file());
  }
};

/// `error`: that of the column with the lateral error.
void expect_legs(OGRLayer& layer, const char* error) {
  ASSERT_EQ(layer.GetFeatureCount(), 4);
  std::vector<OGRFeatureUniquePtr> legs;
  while (OGRFeatureUniquePtr feature{layer.GetNextFeature()}) legs.push_back(std::move(feature));
  const char* const kinds[] = {"work", "turn", "back_out", "transit"};
  const char* const gears[] = {"forward", "forward", "reverse", "forward"};
  const double lengths_m[] = {100, 6 * std::numbers::pi, 5, 0}, times_s[] = {40, 12.5, 8, 0};
  for (int i = 0; i < 4; ++i) {
    SCOPED_TRACE(i);
    const OGRFeature& leg = *legs[static_cast<std::size_t>(i)];
    EXPECT_EQ(leg.GetFieldAsInteger("seq"), i + 1);
    EXPECT_STREQ(leg.GetFieldAsString("kind"), kinds[i]);
    EXPECT_STREQ(leg.GetFieldAsString("gear"), gears[i]);
    EXPECT_EQ(leg.GetFieldAsInteger("work"), i == 0 ? 1 : 0);
    EXPECT_NEAR(leg.GetFieldAsDouble("length_m"), lengths_m[i], 1e-6);
    EXPECT_NEAR(leg.GetFieldAsDouble("time_s"), times_s[i], 1e-6);
    EXPECT_EQ(leg.GetFieldIndex("stretches"), -1);
    EXPECT_GE(leg.GetFieldIndex(error), 0);
  }
  EXPECT_EQ(legs[0]->GetFieldAsInteger("piece"), 3);
  EXPECT_DOUBLE_EQ(legs[1]->GetFieldAsDouble("missing_m"), 0.25);
  EXPECT_GT(legs[1]->GetGeometryRef()->toLineString()->getNumPoints(), 4);
}

TEST_F(ExportedRoute, ASingleLayerIsAskedForByName) {
  for (const char* name : {"legs.geojson", "legs.fgb"}) {
    SCOPED_TRACE(name);
    const ExportReport report = exported(name, "", {"route"});
    ASSERT_EQ(report.layers.size(), 1u);
    EXPECT_EQ(report.layers[0].name, "route");
    EXPECT_EQ(report.layers[0].features, 4);
    const auto file = open(folder_ / name);
    EXPECT_STREQ(file->GetLayer(0)->GetName(), "route");
    expect_legs(*file->GetLayer(0), "lateral_error_m");
    const ExportReport lines = exported(name);
    EXPECT_EQ(lines.layers[0].name, "tracks") << "what is exported unasked stays the same";
  }
}

TEST_F(ExportedRoute, ShapefilesHaveIt) {
  exported("all.zip");
  const auto file = open("/vsizip/" + (folder_ / "all.zip").string());
  OGRLayer* const layer = file->GetLayerByName("route");
  ASSERT_NE(layer, nullptr);
  expect_legs(*layer, "lat_err_m");
}

TEST_F(ExportedRoute, KmlColoursLegsByTheirKind) {
  exported("plan.kml");
  const std::string kml = bytes_of(folder_ / "plan.kml");
  EXPECT_NE(kml.find("<name>route</name>"), std::string::npos);
  EXPECT_NE(kml.find("<name>Leg 3</name>"), std::string::npos);
  EXPECT_NE(kml.find("FF2828C6"), std::string::npos) << "leaves the land";
  EXPECT_NE(kml.find("FF9E298C"), std::string::npos) << "transit";
  EXPECT_NE(kml.find("FF291F1F"), std::string::npos) << "backing out";
}

TEST_F(ExportedRoute, LegsLieWhereThePlanHasThem) {
  exported("legs.geojson", "", {"route"});
  const auto plan = open(plan_file()), file = open(folder_ / "legs.geojson");
  OGRLayer &planned = *plan->GetLayerByName("route_legs"), &layer = *file->GetLayer(0);
  OGRSpatialReference local(*planned.GetSpatialRef()), degrees;
  degrees.SetWellKnownGeogCS("WGS84");
  for (OGRSpatialReference* each : {&local, &degrees})
    each->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> back(
      OGRCreateCoordinateTransformation(&degrees, &local));
  const OGRFeatureUniquePtr work(layer.GetNextFeature());
  const std::unique_ptr<OGRGeometry> line(work->GetGeometryRef()->clone());
  ASSERT_EQ(line->transform(back.get()), OGRERR_NONE);
  const OGRLineString& points = *line->toLineString();
  EXPECT_NEAR(points.getX(0), 10, 1e-4);
  EXPECT_NEAR(points.getY(0), 10, 1e-4);
  EXPECT_NEAR(points.getX(points.getNumPoints() - 1), 110, 1e-4);
}

TEST_F(ExportTest, WithoutARouteThereIsNoneToExport) {
  const auto why = refusal("legs.geojson", "", {"route"});
  ASSERT_TRUE(why);
  EXPECT_NE(why->find("no layer 'route'"), std::string::npos) << *why;
}

}  // namespace
}  // namespace tramline::io
