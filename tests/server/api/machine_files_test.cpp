// Files for the machine, as the program exports them, and the addresses of the page.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "report/line_card_pages.h"
#include "server/served.h"
#include "tramline/io/export/export_plan.h"

namespace tramline::server {
namespace {

TEST_F(ServerTest, WritesTheFilesThatTheProgramExports) {
  const std::string field = served.field_of("terrace.kml");
  const std::string plan = served.planned(field, {{"headlands", 1}});
  const auto file = [&](const std::string& words) {
    return served.get("/plans/" + plan + "/files/" + words);
  };
  const std::filesystem::path kept = folder.path() / "plans" / (plan + ".gpkg");
  const testing_support::TemporaryFolder own;
  const auto own_file = [&](const char* name) { return own.path() / name; };

  for (const auto& [word, name] : {std::pair{"gpx", "a.gpx"},
                                   {"mission", "a.plan"},
                                   {"waypoints", "a.waypoints"},
                                   {"ros-yaml", "a.yaml"},
                                   {"ros-json", "a.json"}}) {
    const Got got = file(word);
    ASSERT_EQ(got.status, 200) << word << got.text;
    io::export_route({kept, own_file(name), io::route_format_of(name).value()});
    EXPECT_EQ(got.text, testing_support::bytes_of(own_file(name))) << word;
  }
  for (const char* word : {"isoxml4", "isoxml3", "agopengps", "dji?flight_altitude_m=3",
                           "isoxml4?lines=all&obstacles=polygons"}) {
    const Got got = file(word);
    ASSERT_EQ(got.status, 200) << word << got.text;
    EXPECT_TRUE(got.text.starts_with("PK")) << word;
  }
  EXPECT_GT(file("isoxml4?lines=all").text.size(), file("isoxml4").text.size()) << "more lines";
  EXPECT_NE(file("mission?flight_altitude_m=3").text.find("\"command\": 22"), std::string::npos)
      << "a drone takes off";
  EXPECT_TRUE(file("card").text.starts_with("%PDF-"));

  EXPECT_EQ(file("dji").status, 400) << "how high, nobody has said";
  EXPECT_EQ(file("isoxml4?lines=some").status, 400);
  for (const char* word : {"mission?flight_altitude_m=-1", "mission?flight_altitude_m=2000"}) {
    EXPECT_EQ(file(word).status, 400);
    EXPECT_NE(file(word).message().find("between 0.5 and 1500 m"), std::string::npos) << file(word).message();
    EXPECT_EQ(file(word).message().find('/'), std::string::npos) << "no path of the server";
  }
  EXPECT_EQ(file("isoxml5").status, 404);
  EXPECT_NE(file("isoxml5").message().find("agopengps"), std::string::npos);
}

TEST_F(ServerTest, SaysWhyThereIsNoRouteOrCard) {
  const std::string field = served.field_of("plain-metres.gpkg");
  const std::string plan = served.planned(field, {{"route", false}});
  const Got route = served.get("/plans/" + plan + "/files/ros-yaml");  // which takes plain metres
  EXPECT_EQ(route.status, 400);
  EXPECT_NE(route.message().find("no route; plan the whole job"), std::string::npos) << route.message();
  EXPECT_EQ(route.message().find(folder.path().string()), std::string::npos) << route.message();
  EXPECT_EQ(served.get("/plans/" + plan + "/files/card").status, 400);
}

TEST_F(ServerTest, LayersOfItsOwnAreAsFineAsTheyAreAskedFor) {
  const std::string field = served.field_of("riverside.geojson");
  const std::string plan = served.planned(field, {{"route", false},
                                                  {"headlands", 0},
                                                  {"obstacle_headlands", 0},
                                                  {"boundary", "soft"},
                                                  {"end_rule", "cover"}});
  for (const char* layer : {"outside", "detours"}) {
    const auto corners = [&](const char* detail) {
      std::size_t out = 0;
      const Got got = served.get("/plans/" + plan + "/layers/" + layer + detail);
      EXPECT_EQ(got.status, 200) << got.text;
      for (std::size_t at = got.text.find(','); at != std::string::npos; at = got.text.find(',', at + 1))
        ++out;
      EXPECT_GT(got.json["features"].size(), 0U) << layer;
      return out;
    };
    EXPECT_LT(corners("?detail_m=2"), corners("")) << layer;
    EXPECT_EQ(corners("?detail_m=0"), corners("")) << layer;
    EXPECT_EQ(served.get("/plans/" + plan + "/layers/" + layer + "?detail_m=-1").status, 400);
  }
}

using Place = std::pair<double, double>;

void places_in(const ordered_json& coordinates, std::vector<Place>& out) {
  if (coordinates.empty()) return;
  if (coordinates.front().is_number()) {
    out.emplace_back(coordinates.at(0).get<double>(), coordinates.at(1).get<double>());
    return;
  }
  for (const ordered_json& part : coordinates) places_in(part, out);
}

std::vector<Place> places_of(const Got& layer) {
  std::vector<Place> out;
  for (const ordered_json& feature : layer.json["features"])
    places_in(feature["geometry"]["coordinates"], out);
  return out;
}

TEST_F(ServerTest, DigitsThatAreLeftOutMoveLandByATenthOfTheDetailAndLinesByAMillimetre) {
  constexpr double kDegree_m = 111'320, kDetail_m = 0.3;
  const std::string field = served.field_of("terrace.kml");
  const std::string plan = served.planned(field, {{"headlands", 1}, {"route", false}});
  for (const auto& [layer, most_m] : {std::pair{"headland", 0.1 * kDetail_m}, {"tracks", 0.001}}) {
    const Got fine = served.get("/plans/" + plan + "/layers/" + layer);
    const Got coarse = served.get(fmt::format("/plans/{}/layers/{}?detail_m={}", plan, layer, kDetail_m));
    const std::vector<Place> before = places_of(fine), after = places_of(coarse);
    ASSERT_GT(after.size(), 4U) << layer;
    // Corners that stay are corners of the whole shape.
    double farthest_m = 0;
    for (const auto& [x, y] : after) {
      double nearest_m = 1e9;
      for (const auto& [u, v] : before)
        nearest_m = std::min(nearest_m, kDegree_m * std::max(std::abs(x - u), std::abs(y - v)));
      farthest_m = std::max(farthest_m, nearest_m);
    }
    EXPECT_LE(farthest_m, most_m) << layer;
    EXPECT_GT(farthest_m, most_m / 100) << layer << ": no digits are left out";
    EXPECT_LT(coarse.text.size(), fine.text.size()) << layer;
  }
}

TEST_F(ServerTest, TellsNoAddressesWhereOnlyThisComputerIsServed) {
  EXPECT_EQ(served.get("/session").json["addresses"].size(), 0U);
}

TEST(SessionTest, TellsThoseWithTheTokenHowToOpenThePageElsewhere) {
  const testing_support::TemporaryFolder folder;
  ServerSettings settings;
  settings.host = "0.0.0.0";
  settings.token = "a-secret-of-ours";
  Served served(folder.path(), settings);
  const Got refused = served.get("/session");
  EXPECT_EQ(refused.status, 403);
  EXPECT_EQ(refused.text.find("a-secret"), std::string::npos);
  served.headers = {{"Authorization", "Bearer a-secret-of-ours"}};
  const Got got = served.get("/session");
  EXPECT_EQ(got.status, 200) << got.text;
  for (const ordered_json& address : got.json["addresses"]) {
    EXPECT_TRUE(address.get<std::string>().ends_with("/#token=a-secret-of-ours")) << address;
    EXPECT_EQ(address.get<std::string>().find("//127."), std::string::npos) << address;
  }
  EXPECT_EQ(got.json["addresses"].size() + 1, served.server().addresses().size())
      << "all but this computer's own";
}

TEST_F(ServerTest, HasNoBackgroundUnlessOneIsGiven) {
  EXPECT_TRUE(served.get("/").json["tiles_of"].is_null());
  EXPECT_EQ(served.get("/background/3/1/1").status, 404);
}

}  // namespace
}  // namespace tramline::server
