// Files of routes: what cannot be written is refused in a sentence, before anything is written.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "io/mission/small_route.h"
#include "support/temporary_folder.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/io/export/export_plan.h"
#include "tramline/io/machine/read_flight.h"
#include "tramline/io/mission/route_texts.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline::io::route_files_test {

using testing_mission::plan_with_route;
using testing_support::mentions;
using testing_support::refusal_of;

class RouteFiles : public testing::Test {
 protected:
  std::string machine(const std::string& rows) const {
    const std::filesystem::path file = folder_ / "machine.toml";
    std::ofstream(file) << "width_m = 3\n" << rows;
    return file.string();
  }
  /// What a plan in this file is refused with.
  std::string refusal(const Plan& plan, const char* file, const std::string& machine = "",
                      double tolerance_m = 0.02) {
    write_plan(plan, folder_ / "plan.gpkg");
    const RouteRequest request{
        folder_ / "plan.gpkg", folder_ / file, *route_format_of(file), machine, tolerance_m, ""};
    const std::string out = refusal_of([&] { export_route(request); });
    EXPECT_FALSE(std::filesystem::exists(folder_ / file));
    return out;
  }
  testing_support::TemporaryFolder folder_;
};

TEST_F(RouteFiles, APlanWithoutARouteIsRefused) {
  for (const char* file : {"a.gpx", "a.plan", "a.waypoints", "a.yaml", "a.json"})
    EXPECT_TRUE(mentions(refusal(testing_support::small_plan(), file), "no route")) << file;
}

TEST_F(RouteFiles, ARepairPlanHasGapsAndPassesInGpxOnly) {
  Plan plan = testing_support::small_plan();
  plan.kind = PlanKind::kRepair;
  plan.field.outer = {{0, -6}, {100, -6}, {100, 6}, {0, 6}};
  plan.worked = {{{{0, -6}, {100, -6}, {100, 0}, {0, 0}}, {}}};
  EXPECT_TRUE(mentions(refusal(plan, "a.plan"), "a repair plan"));
  const RouteReport report = export_route({folder_ / "plan.gpkg", folder_ / "a.gpx", RouteFormat::kGpx});
  EXPECT_EQ(report.gaps, 1U);
  EXPECT_EQ(report.points, 0U);
  pugi::xml_document gpx;
  ASSERT_TRUE(gpx.load_file((folder_ / "a.gpx").c_str()));
  const pugi::xml_node place = gpx.child("gpx").child("wpt");
  EXPECT_STREQ(place.child("name").text().get(), "Gap 1");
  EXPECT_STREQ(place.child("desc").text().get(), "600.0 m²") << "100 m by 6 m";
  const FrameProjection projection(plan.field.frame);
  const auto at = [&](const pugi::xml_node& point) {
    return projection.from_lonlat({point.attribute("lon").as_double(), point.attribute("lat").as_double()})
        .value();
  };
  EXPECT_TRUE(contains(plan.body.front(), at(place)));
  std::vector<std::string> names;
  std::vector<std::size_t> points;
  for (const pugi::xml_node track : gpx.child("gpx").children("trk")) {
    names.emplace_back(track.child("name").text().get());
    const auto range = track.child("trkseg").children("trkpt");
    points.push_back(static_cast<std::size_t>(std::distance(range.begin(), range.end())));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"Gap 1", "Pass 1", "Pass 2"}));
  EXPECT_EQ(points, (std::vector<std::size_t>{5, 2, 2}));
  const pugi::xml_node last = gpx.child("gpx").last_child().child("trkseg").first_child();
  EXPECT_LT(distance(at(last), {100, 4.5}), 0.001);
}

TEST_F(RouteFiles, NamesHaveNoControlCharactersInXml) {
  Plan plan = plan_with_route();
  plan.field.id = "a\x01<b>\n\tö";
  write_plan(plan, folder_ / "plan.gpkg");
  export_route({folder_ / "plan.gpkg", folder_ / "a.gpx", RouteFormat::kGpx});
  std::ifstream file(folder_ / "a.gpx");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  EXPECT_NE(text.find("<name>a_&lt;b&gt;__ö</name>"), std::string::npos) << text.substr(0, 300);
}

TEST_F(RouteFiles, PlainMetresAreForRobotsOnly) {
  Plan plan = plan_with_route();
  plan.field.frame = {};
  EXPECT_TRUE(mentions(refusal(plan, "a.gpx"), "plain metres"));
  write_plan(plan, folder_ / "plan.gpkg");
  export_route({folder_ / "plan.gpkg", folder_ / "a.json", RouteFormat::kRobot});
  std::ifstream text(folder_ / "a.json");
  EXPECT_TRUE(nlohmann::json::parse(text).at("datum").contains("x_m"));
}

TEST_F(RouteFiles, LimitsOfADjiMissionAreCheckedBeforeItIsWritten) {
  Plan plan = plan_with_route();
  EXPECT_TRUE(mentions(refusal(plan, "a.kmz"), "flight_altitude_m"));
  EXPECT_TRUE(mentions(refusal(plan, "a.kmz", machine("")), "flight_altitude_m"));
  EXPECT_TRUE(mentions(refusal(plan, "a.kmz", machine("flight_altitude_m = 1\n")), "takeoff_altitude_m"));
  plan.machine.turning.working_speed_mps = 16;
  EXPECT_TRUE(mentions(refusal(plan, "a.kmz", machine("flight_altitude_m = 3\n")), "15 m/s"));
  plan.machine.turning.working_speed_mps = 5;
  plan.machine.turning.reverse_speed_mps = 0.5;
  EXPECT_TRUE(mentions(refusal(plan, "a.kmz", machine("flight_altitude_m = 3\n")), "0.5 m/s"));
}

TEST_F(RouteFiles, ATractorIsNoDrone) {
  EXPECT_TRUE(mentions(refusal(plan_with_route(), "a.plan", machine("")), "flight_altitude_m"));
  EXPECT_TRUE(mentions(refusal(plan_with_route(), "a.gpx", "", 0), "--tolerance"));
  EXPECT_TRUE(mentions(refusal(plan_with_route(), "a.gpx", "", 11), "--tolerance"));
}

TEST_F(RouteFiles, FlightIsReadFromTheMachineFile) {
  const auto flight = read_flight(machine("flight_altitude_m = 3.5\nlanding = \"end\"\nspray_servo = 9\n"));
  ASSERT_TRUE(flight);
  EXPECT_EQ(flight->altitude_m, 3.5);
  EXPECT_EQ(flight->takeoff_altitude_m, 3.5);
  EXPECT_EQ(flight->landing, Landing::kEnd);
  EXPECT_EQ(flight->spray_servo, 9);
  EXPECT_FALSE(read_flight(machine("takeoff_altitude_m = 4\n")));
  for (const char* wrong : {"flight_altitude_m = 0\n", "flight_altitude_m = \"low\"\n", "landing = \"sea\"\n",
                            "spray_servo = 1.5\n", "spray_servo = 0\n", "takeoff_altitude_m = nan\n"})
    EXPECT_TRUE(mentions(refusal_of([&] { read_flight(machine(wrong)); }), "line 2")) << wrong;
}

TEST(YamlText, NumbersHaveAPointAndTextsQuotes) {
  const nlohmann::ordered_json json = {{"small", 1e-5},   {"whole", 2.0},
                                       {"count", 3},      {"text", "no"},
                                       {"none", nullptr}, {"empty", nlohmann::ordered_json::array()},
                                       {"list", {1, 2}}};
  EXPECT_EQ(
      yaml_text(json),
      "small: 1.0e-05\nwhole: 2.0\ncount: 3\ntext: \"no\"\nnone: null\nempty: []\nlist:\n  - 1\n  - 2\n");
}

}  // namespace tramline::io::route_files_test
