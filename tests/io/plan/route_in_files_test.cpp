// Routes in plan files: they come back to the bit, and a plan without one has neither layer nor keys.

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "support/refusals.h"
#include "support/small_plan.h"
#include "support/temporary_folder.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/plan_styles.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/io/plan/write_plans.h"

namespace tramline {
namespace {

using testing_support::mentions;
using testing_support::TemporaryFolder;

namespace fs = std::filesystem;

SteeredStretch straight(Point at, double heading_deg, double length_m, Gear gear = Gear::kForward) {
  return arc_from({at, Heading::clockwise_from_north(Angle::degrees(heading_deg))}, length_m, 0, gear);
}

RouteLeg leg(LegKind kind, bool work, SteeredPath path, double time_s) {
  RouteLeg out{kind, path.empty() ? Gear::kForward : path.front().gear, work, std::move(path)};
  out.time_s = time_s;
  return out;
}

/// From the western end of the first track to its eastern one, half a circle of 1.5 m to the left, back along
/// the second, and 7/3 m out of it in reverse. The pass belongs to no track: numbers only have to come back.
Plan plan_with_route() {
  Plan plan = testing_support::small_plan();
  plan.settings.turns = TurnPlanning::kRoute;
  plan.headland.passes.push_back({straight_path({0, 0.5}, {100, 0.5}), 1, true, {}});
  const double half_circle_m = 1.5 * std::numbers::pi;
  auto& legs = plan.route.legs;
  legs.push_back(leg(LegKind::kWork, true, {straight({0, 1.5}, 90, 100)}, 100.0 / 3));
  legs.back().piece = 0;
  const SteeredStretch turn =
      arc_from(end_of(legs.back().path.back()), half_circle_m, 1 / 1.5, Gear::kForward);
  legs.push_back(leg(LegKind::kTurn, false, {turn}, 1.7));
  legs.back().missing_m = 1.0 / 7;
  legs.back().lateral_error_m = 0.01;
  legs.push_back(leg(LegKind::kWork, true, {straight({100, 4.5}, 270, 100)}, 100.0 / 3));
  legs.back().piece = 1;
  legs.push_back(leg(LegKind::kBackOut, false, {straight({0, 4.5}, 270, 7.0 / 3, Gear::kReverse)}, 3));
  legs.push_back(leg(LegKind::kTransit, false, {}, 0));
  legs.push_back(leg(LegKind::kHeadland, true, {straight({0, 0.5}, 90, 100)}, 100.0 / 3));
  legs.back().pass = 0;
  plan.route.proof = {98.7 + 1.0 / 3, 12.3 + 1.0 / 3, {-0.1, 1.0 / 3, 0, 2e-17}};
  plan.route.over_worked_m = 1.0 / 3;
  plan.route.over_unworked_m = 2.0 / 3;
  plan.route.over_tracks_m = 0.1;
  return plan;
}

class RouteInFiles : public testing::Test {
 protected:
  fs::path file() const { return folder_ / "plan.gpkg"; }

  void change(const char* sql) const {
    io::write_plan(plan_with_route(), file());
    const GDALDatasetUniquePtr data(GDALDataset::Open(file().c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    ASSERT_NE(data, nullptr);
    data->ReleaseResultSet(data->ExecuteSQL(sql, nullptr, nullptr));
  }

  /// What reading says after the change; "" when it says nothing.
  std::string after(const char* sql) const {
    change(sql);
    try {
      io::read_plan_file(file());
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
      return error.what();
    }
    return "";
  }

  std::string metadata(const Plan& plan, const std::string& key) const {
    io::write_plan(plan, file());
    const GDALDatasetUniquePtr data(GDALDataset::Open(file().c_str(), GDAL_OF_VECTOR));
    OGRLayer* const table = data->GetLayerByName("metadata");
    table->SetAttributeFilter(("key = '" + key + "'").c_str());
    const OGRFeatureUniquePtr row(table->GetNextFeature());
    return row == nullptr ? "(none)" : row->GetFieldAsString("value");
  }

  TemporaryFolder folder_;
};

void expect_equal(const SteeredPath& read, const SteeredPath& written) {
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].start.at, written[i].start.at);
    EXPECT_EQ(read[i].start.heading.angle().radians(), written[i].start.heading.angle().radians());
    EXPECT_EQ(read[i].length_m, written[i].length_m);
    EXPECT_EQ(read[i].curvature_at_start, written[i].curvature_at_start);
    EXPECT_EQ(read[i].curvature_at_end, written[i].curvature_at_end);
    EXPECT_EQ(read[i].gear, written[i].gear);
  }
}

TEST_F(RouteInFiles, LegsComeBackToTheBit) {
  const Route written = plan_with_route().route;
  io::write_plan(plan_with_route(), file());
  const io::PlanFile whole = io::read_plan_file(file());
  const Route& read = whole.plan.route;
  ASSERT_EQ(read.legs.size(), written.legs.size());
  for (std::size_t i = 0; i < read.legs.size(); ++i) {
    SCOPED_TRACE(i);
    const RouteLeg &a = read.legs[i], &b = written.legs[i];
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.gear, b.gear);
    EXPECT_EQ(a.work, b.work);
    EXPECT_EQ(a.piece, b.piece);
    EXPECT_EQ(a.pass, b.pass);
    EXPECT_EQ(a.time_s, b.time_s);
    EXPECT_EQ(a.missing_m, b.missing_m);
    EXPECT_EQ(a.lateral_error_m, b.lateral_error_m);
    expect_equal(a.path, b.path);
  }
  EXPECT_EQ(read.proof.bound_s, written.proof.bound_s);
  EXPECT_EQ(read.proof.stop_s, written.proof.stop_s);
  EXPECT_EQ(read.proof.node_prices_s, written.proof.node_prices_s);
  EXPECT_EQ(read.over_worked_m, written.over_worked_m);
  EXPECT_EQ(read.over_unworked_m, written.over_unworked_m);
  EXPECT_EQ(read.over_tracks_m, written.over_tracks_m);
  EXPECT_EQ(whole.plan.settings.turns, TurnPlanning::kRoute);
  for (const io::DerivedNumber& number : whole.derived)
    EXPECT_NEAR(number.stored, number.from_shape, 1e-9) << number.where;
}

TEST_F(RouteInFiles, SettingsAreThereOnlyWhereTheyAreOthers) {
  Plan plan = plan_with_route();
  EXPECT_EQ(metadata(plan, "settings.route.order"), "(none)");
  EXPECT_EQ(metadata(plan, "settings.route.start"), "(none)");
  EXPECT_EQ(metadata(plan, "format_version"), "10");
  plan.settings.route = {TrackOrder::kBySpacing, PassTime::kFirst,    PassSequence::kOutwards,
                         Point{0.25, 1.5},       Point{100, 1.0 / 3}, PassCorners::kRound};
  EXPECT_EQ(metadata(plan, "settings.route.passes"), "first");
  EXPECT_EQ(metadata(plan, "settings.route.start"), "0.25 1.5");
  const RouteSettings read = io::read_plan(file()).settings.route;
  EXPECT_EQ(read.order, TrackOrder::kBySpacing);
  EXPECT_EQ(read.passes, PassTime::kFirst);
  EXPECT_EQ(read.sequence, PassSequence::kOutwards);
  EXPECT_EQ(read.corners, PassCorners::kRound);
  EXPECT_EQ(read.start, plan.settings.route.start);
  EXPECT_EQ(read.end, plan.settings.route.end);
}

// The plane of the file begins 1000 m west and 2000 m south of the field's own.
TEST_F(RouteInFiles, GatesAndLegsLieInThePlaneOfTheFile) {
  Plan plan = plan_with_route();
  plan.field.frame = {false, 0, 0, 1000, 2000};
  plan.settings.route.start = Point{0.25, 1.5};
  EXPECT_EQ(metadata(plan, "settings.route.start"), "1000.25 2001.5");
  const Plan read = io::read_plan(file());
  EXPECT_EQ(read.settings.route.start, plan.settings.route.start);
  EXPECT_EQ(read.route.legs[0].path[0].start.at, (Point{0, 1.5}));
}

// Half a circle of 1.5 m about (100, 3), and chords within 1 cm of it.
TEST_F(RouteInFiles, LegsAreDrawnWithinACentimetre) {
  io::write_plan(plan_with_route(), file());
  const GDALDatasetUniquePtr data(GDALDataset::Open(file().c_str(), GDAL_OF_VECTOR));
  OGRLayer* const layer = data->GetLayerByName("route_legs");
  ASSERT_NE(layer, nullptr);
  EXPECT_EQ(layer->GetFeatureCount(), 6);
  layer->SetAttributeFilter("seq = 2");
  const OGRFeatureUniquePtr turn(layer->GetNextFeature());
  ASSERT_NE(turn, nullptr);
  EXPECT_STREQ(turn->GetFieldAsString("kind"), "turn");
  EXPECT_FALSE(turn->IsFieldSetAndNotNull(turn->GetFieldIndex("piece")));
  EXPECT_NEAR(turn->GetFieldAsDouble("length_m"), 1.5 * std::numbers::pi, 1e-12);
  const OGRLineString& line = *turn->GetGeometryRef()->toLineString();
  ASSERT_GT(line.getNumPoints(), 3);
  for (int i = 1; i < line.getNumPoints(); ++i) {
    EXPECT_NEAR(std::hypot(line.getX(i) - 100, line.getY(i) - 3), 1.5, 1e-9);
    const double x = (line.getX(i) + line.getX(i - 1)) / 2, y = (line.getY(i) + line.getY(i - 1)) / 2;
    EXPECT_GE(std::hypot(x - 100, y - 3), 1.5 - 0.01);
  }
}

TEST_F(RouteInFiles, LegsTooShortForAChordAreDrawnToo) {
  Plan plan = plan_with_route();
  plan.route.legs[4].path = {straight({7.0 / 3, 4.5}, 270, 1e-9)};
  io::write_plan(plan, file());
  expect_equal(io::read_plan(file()).route.legs[4].path, plan.route.legs[4].path);
}

TEST_F(RouteInFiles, RowsMayStandInAnyOrder) {
  change("UPDATE route_legs SET seq = 7 - seq");
  const Route read = io::read_plan(file()).route;
  ASSERT_EQ(read.legs.size(), 6U);
  EXPECT_EQ(read.legs.front().kind, LegKind::kHeadland);
  EXPECT_EQ(read.legs[4].kind, LegKind::kTurn);
}

TEST_F(RouteInFiles, PlansWithoutARouteHaveNothingOfIt) {
  const Plan plain = testing_support::small_plan();
  EXPECT_EQ(metadata(plain, "format_version"), "6");
  EXPECT_EQ(metadata(plain, "route.bound_s"), "(none)");
  const GDALDatasetUniquePtr data(GDALDataset::Open(file().c_str(), GDAL_OF_VECTOR));
  EXPECT_EQ(data->GetLayerByName("route_legs"), nullptr);
  EXPECT_FALSE(io::read_plan(file()).route.planned());
}

TEST_F(RouteInFiles, AreKeptInAFileOfManyPlans) {
  io::write_plan(plan_with_route(), file());
  Plan other = testing_support::small_plan();
  other.field.id = "other";
  io::write_plan(other, folder_ / "other.gpkg");
  const fs::path both = folder_ / "both.gpkg";
  io::write_plans({{"f:1", folder_ / "other.gpkg"}, {"f:2", file()}}, both);
  EXPECT_FALSE(io::read_plan(both, "f:1").route.planned());
  const Route read = io::read_plan(both, "f:2").route;
  ASSERT_EQ(read.legs.size(), 6U);
  expect_equal(read.legs[1].path, plan_with_route().route.legs[1].path);
}

TEST_F(RouteInFiles, DamageIsNamed) {
  const auto at = [](const char* feature, const char* column) {
    return std::string("layer route_legs, feature ") + feature + ": " + column;
  };
  EXPECT_EQ(after("UPDATE route_legs SET seq = seq"), "");
  EXPECT_TRUE(mentions(after("UPDATE route_legs SET kind = 'hop' WHERE seq = 2"), at("2", "kind is 'hop'")));
  EXPECT_TRUE(mentions(after("UPDATE route_legs SET gear = 'up' WHERE seq = 4"), at("4", "gear is 'up'")));
  EXPECT_TRUE(
      mentions(after("UPDATE route_legs SET stretches = '1 2 3' WHERE seq = 1"), at("1", "stretches")));
  EXPECT_TRUE(mentions(after("UPDATE route_legs SET time_s = NULL WHERE seq = 3"), "time_s"));
  EXPECT_TRUE(mentions(after("DELETE FROM route_legs WHERE seq = 3"), "number 3 is not there"));
  EXPECT_TRUE(mentions(after("UPDATE route_legs SET seq = 2 WHERE seq = 1"), "number 1 is not there"));
  EXPECT_TRUE(
      mentions(after("DELETE FROM metadata WHERE key = 'route.over_tracks_m'"), "route.over_tracks_m"));
  EXPECT_TRUE(mentions(after("UPDATE metadata SET value = '[1, null]' WHERE key = 'route.node_prices_s'"),
                       "route.node_prices_s"));
  EXPECT_TRUE(mentions(after("INSERT INTO metadata (key, value) VALUES ('settings.route.start', '1 2; 3 4')"),
                       "one point"));
  EXPECT_TRUE(mentions(after("INSERT INTO metadata (key, value) VALUES ('settings.route.order', 'worst')"),
                       "'worst'"));
}

// To draw or to follow some of these would take more memory than there is.
TEST_F(RouteInFiles, StretchesThatNobodyDrivesAreRefused) {
  const auto with = [&](const std::string& numbers) {
    const std::string change =
        "UPDATE route_legs SET stretches = '0 1.5 1.5 " + numbers + " forward' WHERE seq = 1";
    return after(change.c_str());
  };
  for (const char* wrong : {"-0.001 0 0", "100001 0 0", "1e300 0 0", "1e9 0.2 0.2", "10 10.1 10.1",
                            "10 0 -10.1", "18 -1e6 1e6", "1 1e308 -1e308"})
    EXPECT_TRUE(mentions(with(wrong), "route_legs, feature 1: stretches has a stretch of less than 0 m"))
        << wrong;
  for (const char* right : {"0 0 0", "100000 0 0", "10 10 10", "10 -10 10", "0 1e9 1e9"})
    EXPECT_EQ(with(right), "") << right;
}

TEST_F(RouteInFiles, OnlyPlansWithARouteHaveItsStyle) {
  const auto has = [](const std::vector<io::LayerStyle>& styles) {
    return std::ranges::any_of(
        styles, [](const io::LayerStyle& style) { return std::string(style.layer) == "route_legs"; });
  };
  EXPECT_TRUE(has(io::styles_of(plan_with_route())));
  EXPECT_FALSE(has(io::styles_of(testing_support::small_plan())));
  EXPECT_TRUE(has(io::styles_of_many(1, io::Routes::kSome)));
  EXPECT_FALSE(has(io::styles_of_many(1, io::Routes::kNone)));
}

}  // namespace
}  // namespace tramline
