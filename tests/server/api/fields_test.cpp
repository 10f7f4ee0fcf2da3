#include "server/served.h"
#include "tramline/io/field/read_field.h"
#include "tramline/io/field/write_field.h"

namespace tramline::server {
namespace {

TEST_F(ServerTest, KeepsAFieldOfAFile) {
  const std::string id = served.field_of("riverside.geojson");
  const Got field = served.get("/fields/" + id);
  EXPECT_EQ(field.json["name"], "Riverside");
  EXPECT_EQ(field.json["obstacles"], 7);
  EXPECT_EQ(field.json["geodetic"], true);
  EXPECT_EQ(field.json["shapes"]["features"].size(), 8U);
  EXPECT_EQ(field.json["shapes"]["features"][0]["properties"]["kind"], "field");
  // riverside.geojson repeats a vertex; whoever looks at the field later is told as well.
  EXPECT_FALSE(field.json["repairs"].empty());
  EXPECT_EQ(served.get("/fields").json.size(), 1U);
  EXPECT_EQ(served.remove("/fields/" + id).status, 200);
  EXPECT_EQ(served.get("/fields/" + id).status, 404);
  EXPECT_EQ(served.get("/fields").json.size(), 0U);
}

TEST_F(ServerTest, ObstaclesOfAnotherFileGoIntoTheField) {
  const std::string bare = served.field_of("riverside.geojson");
  const Got file = served.upload_example("riverside.geojson"),
            obstacles = served.upload_example("riverside-obstacles.geojson");
  const Got kept = served.post("/fields", {{"upload", file.json["id"]},
                                           {"fid", 0},
                                           {"name", "with pylons"},
                                           {"obstacles_upload", obstacles.json["id"]}});
  ASSERT_EQ(kept.status, 201) << kept.text;
  EXPECT_GT(kept.json["obstacles"], served.get("/fields/" + bare).json["obstacles"]);
  bool named = false;
  for (const auto& shape : kept.json["shapes"]["features"])
    named =
        named || shape["properties"].value("origin", "").starts_with("riverside-obstacles.geojson feature");
  EXPECT_TRUE(named) << kept.text;
}

ordered_json feature_at(double west, const ordered_json& properties) {
  return {{"type", "Feature"}, {"properties", properties}, {"geometry", square(west)}};
}

Got upload_features(const Served& served, const char* name, const std::vector<ordered_json>& features) {
  return served.upload(name, ordered_json{{"type", "FeatureCollection"}, {"features", features}}.dump());
}

TEST_F(ServerTest, FieldsAreStoredUnderTheNameThatTheListOfTheirFileHas) {
  ordered_json parts = feature_at(9.04, nullptr);
  parts["geometry"] = {{"type", "MultiPolygon"},
                       {"coordinates", {square(9.04)["coordinates"], square(9.05)["coordinates"]}}};
  const Got sent =
      upload_features(served, "long%20meadow.geojson",
                      {feature_at(9, nullptr), feature_at(9.01, {{"Schlagname", "Hofwiese"}}),
                       feature_at(9.02, {{"id", "F7"}}), feature_at(9.03, {{"name", " "}}), parts});
  const std::vector<std::string> names = {"long meadow, field 0", "Hofwiese", "F7", "long meadow, field 3",
                                          "long meadow, field 4"};
  ASSERT_EQ(sent.json["features"].size(), names.size()) << sent.text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(sent.json["features"][i]["name"], names[i]);
    const Got kept = served.post("/fields", {{"upload", sent.json["id"]}, {"fid", i}});
    ASSERT_EQ(kept.status, 201) << kept.text;
    EXPECT_EQ(kept.json["name"], names[i]);
    if (i != 4) continue;
    const std::string second = kept.json["others"][0];
    EXPECT_EQ(served.get("/fields/" + second).json["name"], "long meadow, field 4 #2");
  }
  // The only field of a file is called after it, and so are its plan and that plan's files.
  const Got one = upload_features(served, "mill%20field.geojson", {feature_at(9, nullptr)});
  const Got kept = served.post("/fields", {{"upload", one.json["id"]}});
  EXPECT_EQ(kept.json["name"], "mill field");
  const std::string plan = served.planned(kept.json["id"], {{"route", false}, {"headlands", 1}});
  EXPECT_EQ(served.get("/plans/" + plan).json["summary"]["field_id"], "mill field");
  const Got file = served.get("/plans/" + plan + "/files/geojson");
  EXPECT_NE(file.headers.find("Content-Disposition")->second.find("mill"), std::string::npos)
      << file.headers.find("Content-Disposition")->second;
}

TEST_F(ServerTest, RefusalsOfAFileCallItsFieldsByName) {
  const auto thin = [](const ordered_json& properties) {
    ordered_json out = feature_at(9, properties);
    out["geometry"]["coordinates"] = {{{9, 50}, {9, 50}, {9, 50}, {9, 50}}};
    return out;
  };
  const Got sent =
      upload_features(served, "meadow.geojson",
                      {thin(nullptr), thin({{"name", "Hofwiese"}, {"id", "F12"}}), feature_at(9, nullptr)});
  const auto says = [&](const ordered_json& sentence, const std::string& name) {
    const std::string text = sentence.get<std::string>();
    EXPECT_NE(text.find("feature '" + name + "'"), std::string::npos) << text;
    EXPECT_EQ(text.find(sent.json["id"].get<std::string>()), std::string::npos) << text;
  };
  says(sent.json["features"][0]["refused"], "meadow, field 0");
  says(sent.json["features"][1]["refused"], "Hofwiese");
  const auto refusal = [&](ordered_json request) {
    request["upload"] = sent.json["id"];
    const Got got = served.post("/fields", request);
    EXPECT_EQ(got.status, 400) << got.text;
    return got.message();
  };
  says(refusal({{"fid", 0}}), "meadow, field 0");
  says(refusal({{"fid", 0}, {"layer", sent.json["features"][0]["layer"]}}), "meadow, field 0");
  says(refusal({{"fid", 0}, {"name", "Anger"}}), "Anger");
  says(refusal({{"fid", 1}}), "Hofwiese");
  const std::string none = refusal({{"fid", 9}}), several = refusal(ordered_json::object());
  EXPECT_NE(none.find("layer 'meadow'"), std::string::npos) << none;
  EXPECT_NE(several.find("meadow, field 2"), std::string::npos) << several;
  EXPECT_EQ(several.find(sent.json["id"].get<std::string>()), std::string::npos) << several;
}

TEST_F(ServerTest, SeveralFeaturesHaveToBeChosenFrom) {
  const Got file = served.upload_example("two-farms.gpkg");
  const Got kept = served.post("/fields", {{"upload", file.json["id"]}, {"layer", "parcels"}});
  EXPECT_EQ(kept.status, 400);
  EXPECT_NE(kept.message().find("two-farms.gpkg"), std::string::npos) << kept.message();
  EXPECT_EQ(kept.message().find("--"), std::string::npos) << kept.message();
}

TEST_F(ServerTest, AllPartsOfAFeatureAreKept) {
  ordered_json two = square(), far = square(9.01);
  two["type"] = "MultiPolygon";
  two["coordinates"] = {square()["coordinates"], far["coordinates"]};
  const Got kept = served.post("/fields", {{"name", "both"}, {"geometry", two}});
  ASSERT_EQ(kept.status, 201) << kept.text;
  ASSERT_EQ(kept.json["others"].size(), 1U);
  EXPECT_EQ(served.get("/fields/" + std::string(kept.json["others"][0])).json["name"], "both #2");
}

TEST_F(ServerTest, KeepsADrawnField) {
  const Got kept = served.post("/fields", {{"name", "drawn"}, {"geometry", square()}});
  ASSERT_EQ(kept.status, 201) << kept.text;
  // 0.0028° of longitude at 50° and 0.0018° of latitude on the ellipsoid: 71,697 and 111,229 m to the degree.
  EXPECT_NEAR(kept.json["area_m2"], 0.0028 * 71697 * 0.0018 * 111229, 40);
  EXPECT_NEAR(kept.json["bbox"][0], 9, 1e-6);
  EXPECT_NEAR(kept.json["bbox"][3], 50.0018, 1e-6);
}

TEST_F(ServerTest, RefusesWhatIsNoField) {
  const auto refused = [&](const ordered_json& body) {
    const Got got = served.post("/fields", body);
    EXPECT_EQ(got.status, 400) << got.text;
    return got.message();
  };
  EXPECT_NE(refused({{"geometry", {{"type", "Point"}, {"coordinates", {9, 50}}}}}).find("polygon"),
            std::string::npos);
  EXPECT_NE(refused({{"geometry", {{"type", "Polygon"}, {"coordinates", "x"}}}}).find("list"),
            std::string::npos);
  EXPECT_NE(refused({{"geometry", {{"type", "Polygon"}, {"coordinates", {{{9, 50}, {9, 50}, {9, 50}}}}}}})
                .find("area"),
            std::string::npos);
  EXPECT_NE(refused({{"geometry", {{"type", "Polygon"}, {"coordinates", {{{900, 50}, {9, 50}, {9, 51}}}}}}})
                .find("not a longitude and latitude"),
            std::string::npos);
  EXPECT_NE(refused({{"geometry", square()}, {"nmae", "x"}}).find("nmae"), std::string::npos);
  EXPECT_NE(refused({{"geometry", square()}, {"name", 7}}).find("name has to be a text"), std::string::npos);
  EXPECT_NE(refused(ordered_json::object()).find("geometry"), std::string::npos);
}

TEST_F(ServerTest, ObstaclesAreDrawnAndTakenAway) {
  const std::string id = served.post("/fields", {{"name", "meadow"}, {"geometry", square()}}).json["id"];
  const auto at = [](double dx, double dy) { return ordered_json{9 + dx, 50 + dy}; };
  const Got drawn = served.patch(
      "/fields/" + id,
      {{"name", "meadow with a pond"},
       {"add",
        {{{"kind", "obstacle"},
          {"geometry", {{"type", "Point"}, {"coordinates", at(0.001, 0.001)}}},
          {"size_m", 4}},
         {{"kind", "passable"},
          {"geometry", {{"type", "LineString"}, {"coordinates", {at(0.002, -0.001), at(0.002, 0.003)}}}},
          {"size_m", 2}}}}});
  ASSERT_EQ(drawn.status, 200) << drawn.text;
  EXPECT_EQ(drawn.json["name"], "meadow with a pond");
  EXPECT_EQ(drawn.json["obstacles"], 1);
  EXPECT_EQ(drawn.json["passable"], 1);
  const ordered_json shapes = drawn.json["shapes"]["features"];
  EXPECT_NEAR(shapes[1]["properties"]["area_m2"], 16, 1e-6);
  // A strip 2 m wide from edge to edge: 0.0018° of latitude.
  EXPECT_NEAR(shapes[2]["properties"]["area_m2"], 2 * 0.0018 * 111229, 1);
  EXPECT_EQ(served.get("/fields/" + id).json, drawn.json) << "what is answered is what is kept";

  const Got less = served.patch("/fields/" + id, {{"remove", {1}}});
  EXPECT_EQ(less.json["obstacles"], 0);
  EXPECT_EQ(less.json["passable"], 1);
  EXPECT_EQ(served.patch("/fields/" + id, {{"remove", {2}}}).status, 400);
  EXPECT_EQ(served.patch("/fields/" + id, {{"remove", {0}}}).status, 400);
  EXPECT_EQ(served.patch("/fields/" + id, {{"remove", {"1"}}}).status, 400);
  const Got outside = served.patch(
      "/fields/" + id,
      {{"add", {{{"kind", "obstacle"}, {"geometry", {{"type", "Point"}, {"coordinates", at(0.01, 0)}}}}}}});
  EXPECT_EQ(outside.status, 400);
  EXPECT_NE(outside.message().find("does not reach the field"), std::string::npos) << outside.message();
}

TEST_F(ServerTest, ListsWithinListsWithoutEndAreRefused) {
  const std::string id = served.field_of("riverside.geojson");
  const std::string open(500'000, '['), close(500'000, ']');
  for (const std::string& body : {"{\"remove\":" + open + close + "}", "{\"add\":" + open}) {
    const Got got = served.patch_text("/fields/" + id, body);
    EXPECT_EQ(got.status, 400);
    EXPECT_NE(got.message().find("nested deeper than the 32 levels"), std::string::npos) << got.text;
  }
  EXPECT_EQ(served.get("/fields/" + id).status, 200);
  // The deepest that there is: a multipolygon to be added, seven levels.
  const Got taken =
      served.patch("/fields/" + id, ordered_json::parse(R"({"add":[{"kind":"obstacle","geometry":
      {"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[1,1],[0,0]]]]}}]})"));
  EXPECT_NE(taken.message().find("does not reach the field"), std::string::npos) << taken.text;
}

TEST_F(ServerTest, AFieldInPlainMetresIsShownAboutNowhere) {
  const std::string id = served.field_of("plain-metres.gpkg");
  const Got field = served.get("/fields/" + id);
  EXPECT_EQ(field.json["geodetic"], false);
  const double west = field.json["bbox"][0], east = field.json["bbox"][2], south = field.json["bbox"][1];
  EXPECT_NEAR(west, -east, 1e-5);
  // What is drawn near its corner goes back by the same way: 1e-4 degrees are some 11 m.
  const Got drawn = served.patch(
      "/fields/" + id, {{"add",
                         {{{"kind", "obstacle"},
                           {"geometry", {{"type", "Point"}, {"coordinates", {west + 1e-4, south + 1e-4}}}},
                           {"size_m", 3}}}}});
  ASSERT_EQ(drawn.status, 200) << drawn.text;
  bool found = false;
  for (const auto& shape : drawn.json["shapes"]["features"])
    if (shape["properties"].value("origin", "") == "drawn 1") {
      found = true;
      EXPECT_NEAR(shape["properties"]["area_m2"], 9, 1e-6);
      EXPECT_NEAR(shape["geometry"]["coordinates"][0][0][0], west + 1e-4, 2e-5);
    }
  EXPECT_TRUE(found);
}

/// What a job of this kind says when it is refused: no swath of 300 m fits into a square of 200 m.
std::string refusal_of(const Served& served, const char* kind, const std::string& field) {
  const ordered_json job =
      served.job_of(served.post("/jobs", {{"kind", kind},
                                          {"field", field},
                                          {"machine", {{"width_m", 300}, {"radius_m", 6}}},
                                          {"settings", {{"end_rule", "inside"}, {"route", false}}}}));
  EXPECT_EQ(job.value("state", ""), "failed") << job.dump();
  return job["error"].value("message", "");
}

TEST_F(ServerTest, RefusalsCallAFieldByItsStoredName) {
  const ordered_json feature{{"type", "Feature"}, {"properties", nullptr}, {"geometry", square()}};
  const Got sent = served.upload("field.geojson", feature.dump());
  const std::string id =
      served.post("/fields", {{"upload", sent.json["id"]}, {"fid", 0}, {"name", "Hofwiese"}}).json["id"];
  for (const char* kind : {"plan", "compare"}) {
    const std::string said = refusal_of(served, kind, id);
    EXPECT_NE(said.find("field 'Hofwiese'"), std::string::npos) << kind << ": " << said;
    EXPECT_EQ(said.find("field:0"), std::string::npos) << kind << ": " << said;
  }
  ASSERT_EQ(served.patch("/fields/" + id, {{"name", "Müllers Acker"}}).status, 200);
  EXPECT_NE(refusal_of(served, "plan", id).find("field 'Müllers Acker'"), std::string::npos);
  const std::string plan = served.planned(id);
  EXPECT_EQ(served.get("/plans/" + plan).json["summary"]["field_id"], "Müllers Acker");
}

Polygon box(double x, double y, double size) {
  return {{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}, {}};
}

Field odd_field(bool geodetic) {
  Field field;
  field.id = "odd \"field\"";
  // Thirds have no short decimals.
  field.outer = {{-100.0 / 3, -50.0 / 7}, {100.0 / 3, -50}, {100, 1e2 / 3}, {-100, 100}};
  field.obstacles = {{box(1.0 / 3, 2.0 / 3, 1.0 / 7), ObstacleKind::kObstacle, "drawn 1"},
                     {box(10.0 / 3, 20.0 / 3, 5), ObstacleKind::kPassable, "strips.geojson feature 3"}};
  field.frame.geodetic = geodetic;
  if (geodetic) {
    field.frame.origin_lon_deg = 9.1234567;
    field.frame.origin_lat_deg = -48.7654321;
  }
  field.source = {"a.geojson", "a", 3, 1, "EPSG:25832", "EPSG:4326", "b.geojson", 2.5, "c.geojson"};
  field.repairs = {{"one was removed", "outer ring, vertex 4", {9.1, 48.2}, -0.125}};
  field.warnings = {"a note, with \"quotes\""};
  return field;
}

void expect_same(const Field& a, const Field& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.outer, b.outer);
  EXPECT_EQ(a.frame, b.frame);
  ASSERT_EQ(a.obstacles.size(), b.obstacles.size());
  for (std::size_t i = 0; i < a.obstacles.size(); ++i) {
    EXPECT_EQ(a.obstacles[i].shape, b.obstacles[i].shape) << i;
    EXPECT_EQ(a.obstacles[i].kind, b.obstacles[i].kind) << i;
    EXPECT_EQ(a.obstacles[i].origin, b.obstacles[i].origin) << i;
  }
  EXPECT_EQ(a.source.file, b.source.file);
  EXPECT_EQ(a.source.fid, b.source.fid);
  EXPECT_EQ(a.source.part, b.source.part);
  EXPECT_EQ(a.source.input_crs, b.source.input_crs);
  EXPECT_EQ(a.source.obstacle_size_m, b.source.obstacle_size_m);
  ASSERT_EQ(a.repairs.size(), b.repairs.size());
  EXPECT_EQ(a.repairs[0].what, b.repairs[0].what);
  EXPECT_EQ(a.repairs[0].area_change_m2, b.repairs[0].area_change_m2);
  EXPECT_EQ(a.warnings, b.warnings);
}

TEST(FieldFile, AFieldComesBackAsItWas) {
  const testing_support::TemporaryFolder folder;
  for (const bool geodetic : {true, false}) {
    const Field field = odd_field(geodetic);
    const auto path = folder / (geodetic ? "a.gpkg" : "b.gpkg");
    io::write_field(field, path, {{"name", "Über \"uns\""}});
    const io::StoredField back = io::read_field(path);
    expect_same(back.field, field);
    EXPECT_EQ(back.remarks, (io::Metadata{{"name", "Über \"uns\""}}));
  }
}

TEST(FieldFile, InAShiftedPlaneOnceWrittenItDoesNotChangeAgain) {
  const testing_support::TemporaryFolder folder;
  Field field = odd_field(false);
  field.frame.origin_x_m = 3'456'789;
  field.frame.origin_y_m = 5'432'109;
  io::write_field(field, folder / "a.gpkg");
  const Field once = io::read_field(folder / "a.gpkg").field;
  for (std::size_t i = 0; i < field.outer.size(); ++i)
    EXPECT_LT(distance(field.outer[i], once.outer[i]), 2e-9);
  io::write_field(once, folder / "b.gpkg");
  expect_same(io::read_field(folder / "b.gpkg").field, once);
}

}  // namespace
}  // namespace tramline::server
