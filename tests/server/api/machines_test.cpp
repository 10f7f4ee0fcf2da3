#include "server/served.h"

namespace tramline::server {
namespace {

TEST_F(ServerTest, MachinesAreKeptChangedAndDeleted) {
  const Got added = served.post("/machines", {{"name", "sprayer"}, {"width_m", 24}, {"radius_m", 8}});
  ASSERT_EQ(added.status, 201) << added.text;
  EXPECT_TRUE(added.json["min_length_m"].is_null());
  const std::string path = "/machines/" + std::string(added.json["id"]);
  const Got changed =
      served.put(path, {{"name", "sprayer"}, {"width_m", 27}, {"radius_m", 8}, {"min_length_m", 0}});
  EXPECT_EQ(changed.status, 200) << changed.text;
  EXPECT_EQ(changed.json["min_length_m"], 0);
  EXPECT_EQ(served.get("/machines").json, ordered_json::array({changed.json}));
  EXPECT_EQ(served.remove(path).status, 200);
  EXPECT_EQ(served.remove(path).status, 404);
  EXPECT_EQ(served.put(path, {{"name", "x"}, {"width_m", 3}, {"radius_m", 6}}).status, 404);
}

TEST_F(ServerTest, MachinesKeepWhatTheyNeedToTurn) {
  const ordered_json turning{{"reverse", true}, {"implement", "towed"}, {"drawbar_m", 6}, {"lift_m", 1.5}};
  const Got added =
      served.post("/machines", {{"name", "s"}, {"width_m", 36}, {"radius_m", 7}, {"turning", turning}});
  ASSERT_EQ(added.status, 201) << added.text;
  EXPECT_EQ(added.json["turning"]["drawbar_m"], 6);
  EXPECT_EQ(added.json["turning"]["turning_speed_mps"], 1.5);
  EXPECT_EQ(served.get("/machines").json, ordered_json::array({added.json}));
  const Got plain = served.post("/machines", {{"name", "p"}, {"width_m", 3}, {"radius_m", 6}});
  EXPECT_FALSE(plain.json.contains("turning")) << plain.text;
}

TEST_F(ServerTest, RefusesWhatNoMachineNeedsToTurn) {
  const auto refused = [&](const ordered_json& turning) {
    const Got got =
        served.post("/machines", {{"name", "s"}, {"width_m", 36}, {"radius_m", 7}, {"turning", turning}});
    EXPECT_EQ(got.status, 400) << got.text;
    return got.message();
  };
  EXPECT_NE(refused({{"turning_speed_mps", 0}}).find("turning.turning_speed_mps is 0"), std::string::npos);
  EXPECT_NE(refused({{"drawbar_m", 3}}).find("turning.drawbar_m"), std::string::npos);
  EXPECT_NE(refused({{"implement", "towed"}}).find("turning.drawbar_m is missing"), std::string::npos);
  EXPECT_NE(refused({{"implement", "pushed"}}).find("mounted or towed"), std::string::npos);
  EXPECT_NE(refused({{"width", 3}}).find("turning.width"), std::string::npos);
  EXPECT_NE(refused(7).find("turning"), std::string::npos);
}

// w = 3, r = 6: 6 + sqrt(144 − 56.25) + 1.5 m for adjacent tracks, half a circle for jumps of 12 m.
TEST_F(ServerTest, TurnsOfAMachine) {
  const ordered_json machine{{"width_m", 3}, {"radius_m", 6}};
  const Got got = served.post("/turns", {{"machine", machine}});
  ASSERT_EQ(got.status, 200) << got.text;
  ASSERT_EQ(got.json["spacings"].size(), 8U);
  EXPECT_EQ(got.json["spacings"][0]["manoeuvres"][0]["kind"], "omega");
  EXPECT_NEAR(got.json["spacings"][0]["manoeuvres"][0]["depth_m"], 16.8675, 1e-4);
  EXPECT_EQ(got.json["spacings"][3]["manoeuvres"][0]["passes"], 3);
  const Got one = served.post("/turns", {{"machine", machine}, {"spacing_m", 12}, {"angle_deg", 60}});
  ASSERT_EQ(one.status, 200) << one.text;
  EXPECT_EQ(one.json["spacings"].size(), 1U);
  for (const ordered_json& body :
       {ordered_json{{"machine", machine}, {"spacing_m", 0}},
        ordered_json{{"machine", machine}, {"angle_deg", 0}},
        ordered_json{{"machine", {{"width_m", 3}, {"radius_m", 0}}}}, ordered_json{{"spacing_m", 3}},
        ordered_json{{"machine", machine}, {"spacing", 3}}}) {
    const Got refused = served.post("/turns", body);
    EXPECT_EQ(refused.status, 400) << refused.text;
    EXPECT_FALSE(refused.message().empty());
  }
}

TEST_F(ServerTest, RefusesMachinesThatAreNone) {
  const auto refused = [&](const ordered_json& body) {
    const Got got = served.post("/machines", body);
    EXPECT_EQ(got.status, 400) << got.text;
    return got.message();
  };
  EXPECT_NE(refused({{"name", "a"}, {"radius_m", 6}}).find("width_m"), std::string::npos);
  EXPECT_NE(refused({{"name", "a"}, {"width_m", "3"}, {"radius_m", 6}}).find("width_m has to be a number"),
            std::string::npos);
  EXPECT_NE(refused({{"name", "a"}, {"width_m", -3}, {"radius_m", 6}}).find("width"), std::string::npos);
  EXPECT_NE(refused({{"width_m", 3}, {"radius_m", 6}}).find("name"), std::string::npos);
  EXPECT_EQ(served.get("/machines").json.size(), 0U);
}

TEST_F(ServerTest, BodiesHaveToBeJsonObjects) {
  for (const char* body : {"", "{", "[1]", "7", "{\"name\": \"\xff\"}", "null"}) {
    const Got got = served.post_text("/machines", body);
    EXPECT_EQ(got.status, 400) << body;
    EXPECT_EQ(got.code(), "bad_input") << body;
    EXPECT_FALSE(got.message().empty()) << body;
  }
  EXPECT_EQ(served.post_text("/machines", std::string(100'000, '[')).status, 400);
}

TEST_F(ServerTest, SaysWhatIsUsualForEachOperation) {
  const ordered_json list = served.get("/operations?width_m=6").json;
  ASSERT_EQ(list.size(), 9U);
  EXPECT_EQ(list[2]["operation"], "spraying");
  EXPECT_EQ(list[2]["rates"]["price_per_hour"], 120);
  // A litre a hectare (docs/machine.md), of which there are 6 m times 2.9 m/s in an hour.
  EXPECT_NEAR(list[2]["rates"]["fuel_l_per_h"].get<double>(), 1 * 6 * 2.9 * 0.36, 1e-9);
  EXPECT_TRUE(list[2]["standing_crop"].get<bool>());
  EXPECT_EQ(served.get("/operations?width_m=wide").status, 400);
  EXPECT_EQ(served.get("/operations?width_m=-1").status, 400);
}

}  // namespace
}  // namespace tramline::server
