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

}  // namespace
}  // namespace tramline::server
