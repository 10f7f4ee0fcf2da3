// DJI missions of a route that is known by hand, against DJI's description of the format (WPML 1.0.2): what
// has to be there, and what it may be.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "io/mission/small_route.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/io/mission/route_texts.h"

namespace tramline::io::dji_mission_test {

using testing_mission::plan_with_route;

constexpr Flight kFlight{3.5, 6, Landing::kEnd, std::nullopt};

class DjiMission : public testing::Test {
 protected:
  void read(const Plan& plan, const Flight& flight) {
    plan_ = plan;
    route_ = way_points(plan, 0.02);
    const std::vector<NamedFile> files = wpml_files(plan, route_, flight);
    ASSERT_EQ(files.size(), 2U);
    ASSERT_EQ(files[0].name, "wpmz/template.kml");
    ASSERT_EQ(files[1].name, "wpmz/waylines.wpml");
    ASSERT_TRUE(template_.load_string(files[0].content.c_str()));
    ASSERT_TRUE(waylines_.load_string(files[1].content.c_str()));
  }
  void SetUp() override { read(plan_with_route(), kFlight); }
  std::vector<pugi::xml_node> documents() const {
    return {template_.child("kml").child("Document"), waylines_.child("kml").child("Document")};
  }
  static std::vector<pugi::xml_node> points_of(const pugi::xml_node& document) {
    std::vector<pugi::xml_node> out;
    for (const pugi::xml_node point : document.child("Folder").children("Placemark")) out.push_back(point);
    return out;
  }
  static void expect_children(const pugi::xml_node& node, const std::vector<const char*>& names) {
    for (const char* const name : names)
      EXPECT_TRUE(node.child(name)) << node.name() << " lacks " << name << ", which it has to have";
  }

  Plan plan_;
  std::vector<WayPoint> route_;
  pugi::xml_document template_, waylines_;
};

std::string text(const pugi::xml_node& node, const char* name) { return node.child(name).text().get(); }
double number(const pugi::xml_node& node, const char* name) { return node.child(name).text().as_double(-1); }

TEST_F(DjiMission, WhatTheDescriptionRequiresIsThere) {
  for (const pugi::xml_node document : documents()) {
    const pugi::xml_node mission = document.child("wpml:missionConfig");
    expect_children(mission, {"wpml:flyToWaylineMode", "wpml:finishAction", "wpml:exitOnRCLost",
                              "wpml:executeRCLostAction", "wpml:takeOffSecurityHeight",
                              "wpml:globalTransitionalSpeed", "wpml:globalRTHHeight"});
    expect_children(document.child("Folder"), {"wpml:templateId", "wpml:autoFlightSpeed", "Placemark"});
    for (const pugi::xml_node point : points_of(document)) {
      expect_children(point, {"Point", "wpml:index", "wpml:waypointSpeed", "wpml:waypointTurnParam",
                              "wpml:useStraightLine"});
      expect_children(point.child("wpml:waypointTurnParam"),
                      {"wpml:waypointTurnMode", "wpml:waypointTurnDampingDist"});
    }
  }
  const pugi::xml_node folder = documents()[0].child("Folder");
  expect_children(folder,
                  {"wpml:templateType", "wpml:waylineCoordinateSysParam", "wpml:globalWaypointTurnMode",
                   "wpml:globalUseStraightLine", "wpml:gimbalPitchMode", "wpml:globalHeight"});
  expect_children(folder.child("wpml:globalWaypointHeadingParam"),
                  {"wpml:waypointHeadingMode", "wpml:waypointHeadingPathMode"});
  for (const pugi::xml_node point : points_of(documents()[0]))
    expect_children(point, {"wpml:useGlobalHeight", "wpml:useGlobalSpeed", "wpml:useGlobalHeadingParam",
                            "wpml:useGlobalTurnParam"});
  expect_children(documents()[1].child("Folder"), {"wpml:executeHeightMode", "wpml:waylineId"});
  for (const pugi::xml_node point : points_of(documents()[1])) {
    expect_children(point, {"wpml:executeHeight", "wpml:waypointHeadingParam"});
    expect_children(point.child("wpml:waypointHeadingParam"),
                    {"wpml:waypointHeadingMode", "wpml:waypointHeadingPathMode"});
  }
}

TEST_F(DjiMission, HeightsAreThoseOfTheMachineFile) {
  for (const pugi::xml_node document : documents()) {
    const pugi::xml_node mission = document.child("wpml:missionConfig");
    EXPECT_EQ(text(mission, "wpml:takeOffSecurityHeight"), "6.00");
    EXPECT_EQ(text(mission, "wpml:globalRTHHeight"), "6.00") << "the higher of the two";
    EXPECT_EQ(text(mission, "wpml:finishAction"), "autoLand");
  }
  for (const pugi::xml_node point : points_of(documents()[0])) EXPECT_EQ(text(point, "wpml:height"), "3.50");
  for (const pugi::xml_node point : points_of(documents()[1]))
    EXPECT_EQ(text(point, "wpml:executeHeight"), "3.50");
  read(plan_with_route(), {1.5, 1.5, Landing::kHome, std::nullopt});
  const pugi::xml_node mission = documents()[1].child("wpml:missionConfig");
  EXPECT_EQ(text(mission, "wpml:globalRTHHeight"), "2.00") << "the least that the format allows";
  EXPECT_EQ(text(mission, "wpml:finishAction"), "goHome");
}

// A point's speed is that of the way from it: 2.5 m/s along the first track, 1.5 m/s round the turn, 2.5 m/s
// back, and 1 m/s out of the track.
TEST_F(DjiMission, SpeedsAreThoseOfTheWayFromEachPoint) {
  for (const pugi::xml_node document : documents()) {
    const std::vector<pugi::xml_node> points = points_of(document);
    ASSERT_EQ(points.size(), route_.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point at = route_[i].at;
      const bool back_out = i + 2 >= points.size();
      const bool turning = at.x >= 100 - 1e-9 && at.y < 4.5 - 1e-9;
      const char* const wanted = back_out ? "1.00" : turning ? "1.50" : "2.50";
      EXPECT_EQ(text(points[i], "wpml:waypointSpeed"), wanted) << i;
      if (points[i].child("wpml:useGlobalSpeed")) {
        EXPECT_EQ(text(points[i], "wpml:useGlobalSpeed"), "0");
      }
    }
  }
  // (100 + 100) m at 2.5 m/s, the turn at 1.5 m/s, 5 m at 1 m/s.
  const pugi::xml_node folder = documents()[1].child("Folder");
  EXPECT_NEAR(number(folder, "wpml:distance"), 205 + 1.5 * std::numbers::pi, 0.1);
  EXPECT_NEAR(number(folder, "wpml:duration"), 80 + std::numbers::pi + 5, 0.1);
}

TEST_F(DjiMission, PlacesAreThoseOfTheRouteInBothFiles) {
  const FrameProjection projection(plan_.field.frame);
  for (const pugi::xml_node document : documents()) {
    const std::vector<pugi::xml_node> points = points_of(document);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(text(points[i], "wpml:index"), std::to_string(i));
      double lon = 0, lat = 0;
      ASSERT_EQ(
          std::sscanf(points[i].child("Point").child("coordinates").text().get(), "%lf,%lf", &lon, &lat), 2);
      EXPECT_LT(distance(projection.from_lonlat({lon, lat}).value(), route_[i].at), 0.001);
    }
  }
}

// Damping distances lie in (0, length of the way beside the point], and those of two points do not meet.
TEST_F(DjiMission, WaysBetweenPointsAreLongerThanTheDampingAtTheirEnds) {
  for (const pugi::xml_node document : documents()) {
    const std::vector<pugi::xml_node> points = points_of(document);
    const auto damping = [&](std::size_t i) {
      return number(points[i].child("wpml:waypointTurnParam"), "wpml:waypointTurnDampingDist");
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_GT(damping(i), 0);
      EXPECT_LE(damping(i), 0.2);
      if (i + 1 < points.size()) {
        EXPECT_LT(damping(i) + damping(i + 1), distance(route_[i].at, route_[i + 1].at));
      }
    }
  }
}

}  // namespace tramline::io::dji_mission_test
