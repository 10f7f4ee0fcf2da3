// Land that was drawn for a plan, and what becomes of plans when the field is changed.

#include "server/served.h"

namespace tramline::server {
namespace {

// A rectangle of about 200 m by 150 m on a degree of longitude of 71,695 m and one of latitude of 111,229 m.
constexpr double kEast_deg = 200 / 71695.0, kNorth_deg = 150 / 111229.0;

/// Corners as parts of the rectangle, from its south-west.
ordered_json polygon(const std::vector<std::pair<double, double>>& corners) {
  ordered_json ring = ordered_json::array();
  for (const auto& [x, y] : corners) ring.push_back({9 + x * kEast_deg, 50 + y * kNorth_deg});
  ring.push_back(ring.front());
  return {{"type", "Polygon"}, {"coordinates", {ring}}};
}
ordered_json box(double west, double south, double east, double north) {
  return polygon({{west, south}, {east, south}, {east, north}, {west, north}});
}

class LandTest : public ServerTest {
 protected:
  std::string rectangle() {
    const Got kept = served.post("/fields", {{"name", "meadow"}, {"geometry", box(0, 0, 1, 1)}});
    EXPECT_EQ(kept.status, 201) << kept.text;
    return kept.json.value("id", "");
  }
  ordered_json summary(const std::string& field, ordered_json settings) {
    settings["route"] = false;
    settings["headlands"] = settings.value("headlands", 0);
    settings["obstacle_headlands"] = 0;
    return served.get("/plans/" + served.planned(field, settings)).json["summary"];
  }
  std::string refusal(const std::string& field, const ordered_json& land) {
    const Got got = served.post("/jobs", {{"kind", "plan"},
                                          {"field", field},
                                          {"machine", {{"width_m", 6}, {"radius_m", 6}}},
                                          {"settings", {{"land", land}}}});
    EXPECT_EQ(got.status, 400) << got.text;
    return got.message();
  }
};

TEST_F(LandTest, AnEditKeepsHeadlandsAndDirections) {
  const std::string field = rectangle();
  const auto job = [&](const ordered_json& more) {
    ordered_json request = {
        {"kind", "plan"}, {"field", field}, {"machine", {{"width_m", 6}, {"radius_m", 6}}}};
    request.update(more);
    return request;
  };
  const auto made = [&](const ordered_json& more) {
    const ordered_json done = served.job_of(served.post("/jobs", job(more)));
    EXPECT_EQ(done["state"], "done") << done.dump();
    return served.get("/plans/" + std::string(done["result"]["plan"])).json;
  };
  const auto passes = [&](const ordered_json& plan) {
    return served.get("/plans/" + std::string(plan["id"]) + "/layers/headland_passes").json["features"];
  };
  const ordered_json best = made({{"draft", true}});
  const ordered_json skip = {{{"kind", "skip"}, {"geometry", box(0.25, 0.25, 0.5, 0.5)}}};
  const ordered_json edited =
      made({{"draft", true}, {"edit_of", best["id"]}, {"settings", {{"land", skip}}}});
  EXPECT_EQ(edited["asked"]["edit_of"], best["id"]);
  EXPECT_EQ(edited["summary"]["direction_deg"], best["summary"]["direction_deg"]);
  EXPECT_EQ(passes(edited), passes(best));
  EXPECT_NEAR(edited["summary"]["given_up_m2"].get<double>(), 50 * 37.5, 5);
  EXPECT_GT(edited["summary"]["whole_cost"]["euros"], best["summary"]["whole_cost"]["euros"]);
  const ordered_json check = served.job_of(served.post("/jobs", {{"kind", "check"}, {"plan", edited["id"]}}));
  EXPECT_TRUE(check["result"]["check"]["ok"].get<bool>()) << check.dump();

  // North to south, or about: along the line.
  const ordered_json line = {{9 + 0.5 * kEast_deg, 50 + 0.1 * kNorth_deg},
                             {9 + 0.5 * kEast_deg, 50 + 0.9 * kNorth_deg}};
  const ordered_json turned =
      made({{"draft", true}, {"edit_of", best["id"]}, {"settings", {{"line", line}}}});
  const double north_deg = turned["summary"]["direction_deg"][0];
  EXPECT_LT(std::min(north_deg, 180 - north_deg), 0.1);
  EXPECT_EQ(passes(turned), passes(best));
  // The draft before is gone; the one that both are edits of is not, until a plan is made anew.
  EXPECT_EQ(served.get("/plans/" + std::string(edited["id"])).status, 404);
  EXPECT_EQ(served.get("/plans/" + std::string(best["id"])).status, 200);
  const ordered_json anew = made({{"draft", true}});
  EXPECT_EQ(served.get("/plans").json.size(), 1U) << anew["id"];
  EXPECT_EQ(anew["summary"]["direction_deg"], best["summary"]["direction_deg"]);

  // A plan is no plan of another shape of its field.
  ASSERT_EQ(served.patch("/fields/" + field, {{"boundary", box(0, 0, 1, 0.8)}}).status, 200);
  const ordered_json refused = served.job_of(served.post("/jobs", job({{"edit_of", anew["id"]}})));
  EXPECT_EQ(refused["state"], "failed");
  EXPECT_EQ(served.post("/jobs", job({{"edit_of", "nothing"}})).status, 404);
  EXPECT_EQ(served.post("/jobs", job({{"edit_of", anew["id"]}, {"explain", true}})).status, 400);
}

TEST_F(LandTest, NoSwathEntersLandLeftOut) {
  const std::string field = rectangle();
  // A quarter of each side: 50 m by 37.5 m.
  const ordered_json skip = {{{"kind", "skip"}, {"geometry", box(0.25, 0.25, 0.5, 0.5)}}};
  const ordered_json told = summary(field, {{"land", skip}});
  EXPECT_NEAR(told["given_up_m2"].get<double>(), 50 * 37.5, 5);
  EXPECT_GE(told["uncovered_m2"].get<double>(), 50 * 37.5 - 5);
}

TEST_F(LandTest, SubfieldsHaveTheirDirectionAndCutsDivide) {
  const std::string field = rectangle();
  const ordered_json west = {
      {{"kind", "subfield"}, {"geometry", box(-0.1, -0.1, 0.5, 1.1)}, {"direction_deg", 0}}};
  const ordered_json told = summary(field, {{"land", west}});
  EXPECT_EQ(told["subfields"], 2);
  const auto degrees = told["direction_deg"].get<std::vector<double>>();
  EXPECT_TRUE(std::any_of(degrees.begin(), degrees.end(), [](double deg) {
    return std::abs(std::remainder(deg, 180)) < 0.1;
  })) << told["direction_deg"].dump();
  const ordered_json cut = {
      {{"kind", "cut"},
       {"geometry",
        {{"type", "LineString"},
         {"coordinates", {{9 + kEast_deg / 2, 49.9999}, {9 + kEast_deg / 2, 50.0015}}}}}}};
  EXPECT_EQ(summary(field, {{"land", cut}})["subfields"], 2);
  EXPECT_EQ(summary(field, ordered_json::object())["subfields"], 1);
}

/// A straight guide is the border of two swaths: with one 33 m from the south, swaths of 6 m begin there.
TEST_F(LandTest, TracksOfASubfieldFollowItsGuide) {
  const std::string field = rectangle();
  const double lat = 50 + 33 / 111229.0;
  const ordered_json guided = {{{"kind", "subfield"},
                                {"geometry", box(-0.1, -0.1, 1.1, 1.1)},
                                {"guide", {{9, lat}, {9 + kEast_deg, lat}}}}};
  const std::string plan = served.planned(
      field, {{"land", guided}, {"route", false}, {"headlands", 0}, {"obstacle_headlands", 0}});
  int seen = 0;
  const ordered_json tracks = served.get("/plans/" + plan + "/layers/tracks").json;
  for (const ordered_json& track : tracks["features"]) {
    const ordered_json& line = track["geometry"]["coordinates"];
    const ordered_json& first = track["geometry"]["type"] == "LineString" ? line[0] : line[0][0];
    const double north_m = (first[1].get<double>() - 50) * 111229;
    // Swaths of 12 m end on the guide, which lies 33 m north of the border.
    EXPECT_LT(std::abs(std::remainder(north_m - (33 + 6), 12)), 0.05) << north_m;
    ++seen;
  }
  EXPECT_GE(seen, 11);
}

TEST_F(LandTest, LandThatIsDoneIsNotMissedAndTracksAlonePlanned) {
  const std::string field = rectangle();
  const ordered_json done = {{{"kind", "done"}, {"geometry", box(-0.1, -0.1, 0.5, 1.1)}}};
  const Got begun = served.post("/jobs", {{"kind", "plan"},
                                          {"field", field},
                                          {"machine", {{"width_m", 6}, {"radius_m", 6}}},
                                          {"settings", {{"land", done}}}});
  const ordered_json job = served.job_of(begun);
  ASSERT_EQ(job["state"], "done") << job.dump();
  const ordered_json plan = served.get("/plans/" + job["result"]["plan"].get<std::string>()).json;
  EXPECT_FALSE(plan["summary"].contains("route"));
  EXPECT_NEAR(plan["summary"]["body_m2"].get<double>(), 15000, 30) << "half of 30,000 m² is left";
  EXPECT_EQ(plan["asked"]["settings"]["land"], done);
}

TEST_F(LandTest, SaysWhatIsWrongWithAShape) {
  const std::string field = rectangle();
  EXPECT_NE(refusal(field, {{{"kind", "meadow"}, {"geometry", box(0, 0, 1, 1)}}})
                .find("subfield, cut, skip or done"),
            std::string::npos);
  EXPECT_NE(refusal(field, {{{"kind", "cut"}, {"geometry", box(0, 0, 1, 1)}}}).find("has to be a line"),
            std::string::npos);
  EXPECT_NE(
      refusal(field, {{{"kind", "skip"}, {"geometry", box(3, 3, 4, 4)}}}).find("does not reach the field"),
      std::string::npos);
  EXPECT_NE(refusal(field, {{{"kind", "skip"}, {"geometry", box(0, 0, 1, 1)}, {"direction_deg", 3}}})
                .find("are for subfields"),
            std::string::npos);
  EXPECT_NE(refusal(field, {{{"kind", "subfield"}, {"geometry", box(0, 0, 1, 1)}, {"direction_deg", 1000}}})
                .find("between -360 and 360"),
            std::string::npos);
  EXPECT_EQ(served.get("/plans?field=" + field).json.size(), 0U);
}

TEST_F(LandTest, PlansKnowOfWhichShapeTheyAre) {
  const std::string field = rectangle();
  const std::string plan = served.planned(field, {{"route", false}});
  const auto earlier = [&] {
    EXPECT_EQ(served.get("/plans/" + plan).json["earlier_shape"],
              served.get("/plans?field=" + field).json[0]["earlier_shape"]);
    return served.get("/plans/" + plan).json["earlier_shape"].get<bool>();
  };
  EXPECT_FALSE(earlier());
  EXPECT_EQ(served.patch("/fields/" + field, {{"name", "another"}}).status, 200);
  EXPECT_FALSE(earlier()) << "a name is no shape";
  const ordered_json pole = {
      {{"kind", "obstacle"},
       {"geometry", {{"type", "Point"}, {"coordinates", {9 + kEast_deg / 2, 50 + kNorth_deg / 2}}}},
       {"size_m", 2}}};
  EXPECT_EQ(served.patch("/fields/" + field, {{"add", pole}}).status, 200);
  EXPECT_TRUE(earlier());
  // Without the pole it is the shape that was planned, whenever that is.
  EXPECT_EQ(served.patch("/fields/" + field, {{"remove", {1}}}).status, 200);
  EXPECT_FALSE(earlier());
  // The same shape a hundred metres farther east is another field.
  EXPECT_EQ(served.patch("/fields/" + field, {{"boundary", box(0.5, 0, 1.5, 1)}}).status, 200);
  EXPECT_TRUE(earlier());
}

}  // namespace
}  // namespace tramline::server
