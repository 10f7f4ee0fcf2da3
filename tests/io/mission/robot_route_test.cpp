// The file for robots of a route that is known by hand: every value of every segment and of the path.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "io/mission/small_route.h"
#include "tramline/io/mission/route_texts.h"

namespace tramline::io::robot_route_test {

using nlohmann::ordered_json;
using testing_mission::plan_with_route;

constexpr double kPi = std::numbers::pi;

ordered_json robot_file(const Plan& plan) { return ros_route(plan, way_points(plan, 0.02)); }

double angle_off(double yaw, double wanted) { return std::abs(std::remainder(yaw - wanted, 2 * kPi)); }

struct Wanted {
  const char* type;
  const char* leg;
  const char* gear;
  bool work;
  double speed_mps, length_m, curvature;
  double x, y, yaw;  ///< at the start
  double end_x, end_y, end_yaw;
};

// 100 m to the east at 2.5 m/s, half a circle of 1.5 m to the left at 1.5 m/s, 100 m to the west, and 5 m
// back in reverse at 1 m/s, the machine pointing to the west.
TEST(RobotRoute, SegmentsSayHowEachStretchIsDriven) {
  const ordered_json file = robot_file(plan_with_route());
  const std::vector<Wanted> wanted = {
      {"line", "work", "forward", true, 2.5, 100, 0, 0, 1.5, 0, 100, 1.5, 0},
      {"arc", "turn", "forward", false, 1.5, 1.5 * kPi, 1 / 1.5, 100, 1.5, 0, 100, 4.5, kPi},
      {"line", "work", "forward", true, 2.5, 100, 0, 100, 4.5, kPi, 0, 4.5, kPi},
      {"line", "back_out", "reverse", false, 1, 5, 0, 0, 4.5, kPi, 5, 4.5, kPi}};
  ASSERT_EQ(file.at("segments").size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const ordered_json& read = file["segments"][i];
    const Wanted& w = wanted[i];
    EXPECT_EQ(read.at("type"), w.type) << i;
    EXPECT_EQ(read.at("leg"), w.leg) << i;
    EXPECT_EQ(read.at("gear"), w.gear) << i;
    EXPECT_EQ(read.at("work"), w.work) << i;
    EXPECT_EQ(read.at("speed_mps"), w.speed_mps) << i;
    EXPECT_NEAR(read.at("length_m"), w.length_m, 1e-9) << i;
    EXPECT_NEAR(read.at("curvature_at_start"), w.curvature, 1e-12) << i;
    EXPECT_NEAR(read.at("curvature_at_end"), w.curvature, 1e-12) << i;
    EXPECT_NEAR(read.at("start").at("x"), w.x, 1e-9) << i;
    EXPECT_NEAR(read.at("start").at("y"), w.y, 1e-9) << i;
    EXPECT_LT(angle_off(read.at("start").at("yaw"), w.yaw), 1e-9) << i;
    EXPECT_NEAR(read.at("end").at("x"), w.end_x, 1e-9) << i;
    EXPECT_NEAR(read.at("end").at("y"), w.end_y, 1e-9) << i;
    EXPECT_LT(angle_off(read.at("end").at("yaw"), w.end_yaw), 1e-9) << i;
  }
}

TEST(RobotRoute, AStretchWhoseCurvatureChangesIsAClothoid) {
  Plan plan = plan_with_route();
  plan.route.legs.resize(1);
  plan.route.legs[0].path = {
      {{{0, 0}, Heading::clockwise_from_north(Angle::degrees(90))}, 10, 0, -0.1, Gear::kForward}};
  const ordered_json segment = robot_file(plan).at("segments").at(0);
  EXPECT_EQ(segment.at("type"), "clothoid");
  EXPECT_EQ(segment.at("curvature_at_start"), 0);
  EXPECT_EQ(segment.at("curvature_at_end"), -0.1);
  // The heading turns by the mean curvature times the length, to the right.
  EXPECT_NEAR(segment.at("end").at("yaw"), -0.5, 1e-9);
}

TEST(RobotRoute, StretchesWithoutLengthAreNoSegments) {
  Plan plan = plan_with_route();
  SteeredStretch nothing = plan.route.legs[0].path[0];
  nothing.length_m = 0;
  plan.route.legs[0].path.insert(plan.route.legs[0].path.begin(), nothing);
  EXPECT_EQ(robot_file(plan).at("segments").size(), 4U);
}

TEST(RobotRoute, PathIsANavMsgsPath) {
  const ordered_json file = robot_file(plan_with_route());
  EXPECT_EQ(file.at("field"), "small");
  EXPECT_EQ(file.at("frame_id"), "field");
  EXPECT_EQ(file.at("datum").at("latitude_deg"), 52);
  EXPECT_EQ(file.at("datum").at("longitude_deg"), 13);
  const ordered_json& path = file.at("path");
  EXPECT_EQ(path.at("header").at("frame_id"), "field");
  EXPECT_EQ(path.at("header").at("stamp").at("sec"), 0);
  const ordered_json& poses = path.at("poses");
  ASSERT_GT(poses.size(), 6U);
  for (const ordered_json& stamped : poses) {
    EXPECT_EQ(stamped.at("header"), path.at("header"));
    const ordered_json& q = stamped.at("pose").at("orientation");
    EXPECT_EQ(q.at("x"), 0);
    EXPECT_EQ(q.at("y"), 0);
    EXPECT_EQ(stamped["pose"].at("position").at("z"), 0);
    EXPECT_NEAR(std::hypot(q.at("z").get<double>(), q.at("w").get<double>()), 1, 1e-12);
  }
  const auto is_at = [&](const ordered_json& stamped, double x, double y, double yaw) {
    const ordered_json &position = stamped.at("pose").at("position"), &q = stamped["pose"].at("orientation");
    EXPECT_NEAR(position.at("x"), x, 1e-9);
    EXPECT_NEAR(position.at("y"), y, 1e-9);
    EXPECT_LT(angle_off(2 * std::atan2(q.at("z").get<double>(), q.at("w").get<double>()), yaw), 1e-9);
  };
  is_at(poses.front(), 0, 1.5, 0);
  is_at(poses[1], 100, 1.5, 0);
  is_at(poses[poses.size() - 2], 0, 4.5, kPi);
  is_at(poses.back(), 5, 4.5, kPi);
}

TEST(RobotRoute, YamlHasTheSameInBlocks) {
  const std::string text = yaml_text(robot_file(plan_with_route()));
  EXPECT_TRUE(text.starts_with(
      "field: \"small\"\nframe_id: \"field\"\ndatum:\n  latitude_deg: 52.0\n  longitude_deg: 13.0\n"))
      << text.substr(0, 200);
  const std::size_t segments = text.find(
      "\nsegments:\n  -\n    type: \"line\"\n    leg: \"work\"\n    gear: \"forward\"\n    work: true\n    "
      "speed_mps: 2.5\n    length_m: 100.0\n");
  EXPECT_NE(segments, std::string::npos);
  EXPECT_NE(text.find("gear: \"reverse\"\n    work: false\n    speed_mps: 1.0\n    length_m: 5.0\n"),
            std::string::npos);
}

}  // namespace tramline::io::robot_route_test
