// Files of routes: what cannot be written is refused in a sentence, before anything is written.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "io/mission/small_route.h"
#include "support/temporary_folder.h"
#include "tramline/io/export/export_plan.h"
#include "tramline/io/machine/read_flight.h"
#include "tramline/io/mission/route_texts.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline::io {
namespace {

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

}  // namespace
}  // namespace tramline::io
