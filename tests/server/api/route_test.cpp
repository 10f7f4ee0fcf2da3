// Whole routes through the API: what a request may say of them, and what comes back.

#include <cmath>
#include <string>

#include "server/served.h"

namespace tramline::server {
namespace {

/// A square of 200 m with its south-western corner at 9° east, 50° north.
std::string square_field(const Served& served) {
  return served.post("/fields", {{"name", "square"}, {"geometry", square()}}).json.value("id", "");
}

double sum_of(const ordered_json& legs, const char* key, const std::string& kind) {
  double out = 0;
  for (const auto& leg : legs)
    if (kind.empty() || leg["kind"] == kind) out += leg[key].get<double>();
  return out;
}

TEST_F(ServerTest, RoutesComeWithTheirSums) {
  const std::string id = served.planned(square_field(served), {{"route", true}, {"headlands", 2}});
  const ordered_json summary = served.get("/plans/" + id).json["summary"];
  ASSERT_TRUE(summary.contains("route"));
  const ordered_json& route = summary["route"];
  const ordered_json& legs = route["legs"];
  int number = 0;
  for (const auto& leg : legs) EXPECT_EQ(leg["seq"], ++number);
  EXPECT_NEAR(route["working_m"].get<double>(), summary["track_length_m"].get<double>(), 1e-6);
  EXPECT_NEAR(route["headland_m"].get<double>(), summary["headland_length_m"].get<double>(), 1e-4);
  EXPECT_NEAR(route["transit_m"].get<double>(), sum_of(legs, "length_m", "transit"), 1e-6);
  EXPECT_NEAR(route["length_m"].get<double>(), sum_of(legs, "length_m", ""), 1e-6);
  const double time_s = route["time_s"], bound_s = route["bound_s"];
  EXPECT_NEAR(time_s, sum_of(legs, "time_s", ""), 1e-6);
  EXPECT_GT(bound_s, 0);
  // The bound counts stops to back out, out of the corners of the headland here.
  const double priced_s = time_s + route["stop_s"].get<double>() * route["back_outs"].get<double>();
  EXPECT_LE(bound_s, priced_s);
  EXPECT_NEAR(route["gap"].get<double>(), (priced_s - bound_s) / priced_s, 1e-12);
}

TEST_F(ServerTest, RoutesAreALayerOfTheMap) {
  const std::string id = served.planned(square_field(served), {{"route", true}});
  const ordered_json legs = served.get("/plans/" + id).json["summary"]["route"]["legs"];
  ordered_json entry;
  for (const auto& layer : served.get("/plans/" + id + "/layers").json)
    if (layer["name"] == "route_legs") entry = layer;
  ASSERT_TRUE(entry.is_object());
  EXPECT_EQ(entry["features"], legs.size());
  EXPECT_NEAR(entry["m"].get<double>(), sum_of(legs, "length_m", ""), 1e-6);
  const Got shapes = served.get("/plans/" + id + "/layers/route_legs");
  ASSERT_EQ(shapes.status, 200) << shapes.text;
  ASSERT_EQ(shapes.json["features"].size(), legs.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const ordered_json& drawn = shapes.json["features"][i];
    EXPECT_EQ(drawn["properties"]["kind"], legs[i]["kind"]) << i;
    EXPECT_EQ(drawn["properties"]["gear"], legs[i]["gear"]) << i;
    EXPECT_NEAR(drawn["geometry"]["coordinates"][0][0], 9.0014, 0.003) << i;
    EXPECT_NEAR(drawn["geometry"]["coordinates"][0][1], 50.0009, 0.003) << i;
  }
}

TEST_F(ServerTest, PlansWithoutARouteSayNothingOfOne) {
  const std::string id = served.planned(square_field(served), {{"route", false}});
  EXPECT_FALSE(served.get("/plans/" + id).json["summary"].contains("route"));
  for (const auto& layer : served.get("/plans/" + id + "/layers").json)
    EXPECT_NE(layer["name"], "route_legs");
  EXPECT_EQ(served.get("/plans/" + id + "/layers/route_legs").status, 400);
}

/// Metres from the place that a leg's line has as its first or its last.
double metres_off(const ordered_json& place, double lon, double lat) {
  constexpr double kPerDegree_m = 111229;  // of a meridian at 50°
  const double east = (place[0].get<double>() - lon) * 71696,
               north = (place[1].get<double>() - lat) * kPerDegree_m;
  return std::hypot(east, north);
}

TEST_F(ServerTest, RoutesLeadFromGateToGate) {
  // In the middle of the field the machine has room wherever it comes from.
  const std::string id = served.planned(
      square_field(served),
      {{"route", true}, {"headlands", 2}, {"start", {9.0005, 50.0005}}, {"end", {9.002, 50.001}}});
  const ordered_json legs = served.get("/plans/" + id + "/layers/route_legs").json["features"];
  ASSERT_GE(legs.size(), 3U);
  EXPECT_LT(metres_off(legs.front()["geometry"]["coordinates"].front(), 9.0005, 50.0005), 0.05);
  EXPECT_LT(metres_off(legs.back()["geometry"]["coordinates"].back(), 9.002, 50.001), 0.05);
  EXPECT_EQ(legs.front()["properties"]["kind"], "transit");
}

TEST_F(ServerTest, GatesOfFieldsInPlainMetresAreWhereTheyAreShown) {
  const std::string field = served.field_of("plain-metres.gpkg");
  const ordered_json box = served.get("/fields/" + field).json["bbox"];
  const double lon = (box[0].get<double>() + box[2].get<double>()) / 2,
               lat = (box[1].get<double>() + box[3].get<double>()) / 2;
  const std::string id =
      served.planned(field, {{"route", true}, {"boundary", "soft"}, {"headlands", 0}, {"start", {lon, lat}}});
  const ordered_json legs = served.get("/plans/" + id + "/layers/route_legs").json["features"];
  ASSERT_FALSE(legs.empty());
  const ordered_json first = legs.front()["geometry"]["coordinates"].front();
  // Near (0°, 0°) a degree is 111 km both ways.
  EXPECT_LT(std::hypot(first[0].get<double>() - lon, first[1].get<double>() - lat) * 111320, 0.05);
}

TEST_F(ServerTest, RefusesWhatIsNoRoute) {
  const std::string field = square_field(served);
  const auto refused = [&](const ordered_json& settings, const char* told) {
    const Got got = served.post("/jobs", {{"kind", "plan"},
                                          {"field", field},
                                          {"machine", {{"width_m", 6}, {"radius_m", 6}}},
                                          {"settings", settings}});
    EXPECT_EQ(got.status, 400) << settings.dump();
    EXPECT_NE(got.message().find(told), std::string::npos) << got.message();
  };
  refused({{"route", "whole"}}, "settings.route");
  refused({{"route", true}, {"order", "random"}}, "the order of tracks");
  refused({{"route", true}, {"headland_time", "never"}}, "first or last");
  refused({{"route", true}, {"pass_sequence", "sideways"}}, "inwards or outwards");
  refused({{"route", true}, {"start", {9.0, "north"}}}, "settings.start");
  refused({{"route", true}, {"start", {9.2, 50.0}}}, "the start of the route");
  refused({{"route", true}, {"end", {9.2, 50.0}}}, "the end of the route");
  refused({{"route", false}, {"start", {9.0005, 50.0005}}}, "settings.start is for a route");
  refused({{"route", false}, {"headland_time", "first"}}, "settings.headland_time is for a route");
}

}  // namespace
}  // namespace tramline::server
