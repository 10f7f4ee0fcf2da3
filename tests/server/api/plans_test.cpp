#include <ogrsf_frmts.h>

#include <map>
#include <set>

#include "server/served.h"
#include "tramline/check/verify.h"
#include "tramline/io/plan/read_plan.h"

namespace tramline::server {
namespace {

TEST_F(ServerTest, PlansAFieldAndKeepsThePlan) {
  const std::string field = served.field_of("plain-metres.gpkg");
  const std::string id = served.planned(
      field, {{"end_rule", "cover"}, {"headlands", 1}, {"obstacle_headlands", 0}, {"route", false}}, true);
  const ordered_json listed = served.get("/plans?field=" + field).json;
  ASSERT_EQ(listed.size(), 1U);
  EXPECT_EQ(listed[0]["id"], id);
  EXPECT_EQ(listed[0]["kind"], "plan");
  EXPECT_EQ(served.get("/plans?field=none").json.size(), 0U);

  const ordered_json plan = served.get("/plans/" + id).json;
  EXPECT_EQ(plan["summary"]["end_rule"], "cover");
  EXPECT_EQ(plan["summary"]["headland_passes"], 1);
  EXPECT_EQ(plan["summary"]["cost"], listed[0]["cost"]);
  EXPECT_NEAR(plan["summary"]["identity_error_m2"], 0, 1e-3);
  EXPECT_EQ(plan["explain"]["causes"].size(), 10U);
  EXPECT_EQ(served.patch("/plans/" + id, {{"name", "spring"}}).json["name"], "spring");
  const ordered_json renamed = served.get("/plans/" + id).json;
  EXPECT_EQ(renamed["name"], "spring");
  EXPECT_EQ(renamed["summary"], plan["summary"]) << "a name changes nothing else";
  EXPECT_EQ(renamed["explain"], plan["explain"]);
  EXPECT_EQ(renamed["created"], plan["created"]);
  EXPECT_EQ(served.remove("/plans/" + id).status, 200);
  EXPECT_EQ(served.get("/plans/" + id).status, 404);
  EXPECT_EQ(served.get("/plans/" + id + "/layers").status, 404);
}

TEST_F(ServerTest, KeepsWhatAPlanWasAskedForAndWhatItsRouteTakes) {
  const std::string field = served.field_of("plain-metres.gpkg");
  const ordered_json settings{{"headlands", 1}, {"end_rule", "inside"}};
  const std::string id = served.planned(field, settings);
  const ordered_json plan = served.get("/plans/" + id).json;
  EXPECT_EQ(plan["asked"]["settings"], settings);
  EXPECT_EQ(plan["asked"]["machine"]["width_m"], 12);
  EXPECT_FALSE(plan["asked"].contains("field"));
  const ordered_json listed = served.get("/plans").json[0];
  EXPECT_EQ(listed["route"]["euros"], plan["summary"]["whole_cost"]["euros"]);
  EXPECT_EQ(listed["route"]["hours"], plan["summary"]["whole_cost"]["hours"]);
  EXPECT_EQ(served.patch("/plans/" + id, {{"name", "spring"}}).json["route"], listed["route"]);
  EXPECT_EQ(served.get("/plans/" + id).json["asked"], plan["asked"]) << "a name changes nothing else";

  // Plans of one second stand in no particular order, so the one of tracks is looked up by its name.
  const std::string tracks = served.planned(field, {{"route", false}});
  std::map<std::string, ordered_json> routes;
  for (const ordered_json& kept : served.get("/plans").json) routes[kept["id"]] = kept["route"];
  ASSERT_EQ(routes.size(), 2U);
  EXPECT_TRUE(routes.at(tracks).is_null());
  EXPECT_EQ(routes.at(id), listed["route"]);
}

TEST_F(ServerTest, TellsHowMuchIsWorkedBeyondTheBoundary) {
  const std::string field = served.field_of("plain-metres.gpkg");
  const auto beyond = [&](const char* boundary) {
    const std::string id = served.planned(
        field, {{"boundary", boundary}, {"headlands", 0}, {"route", false}, {"end_rule", "cover"}});
    double drawn_m2 = 0;
    const ordered_json drawn = served.get("/plans/" + id + "/layers/outside").json;
    for (const ordered_json& feature : drawn["features"])
      drawn_m2 += feature["properties"]["area_m2"].get<double>();
    const ordered_json summary = served.get("/plans/" + id).json["summary"];
    EXPECT_NEAR(summary["outside_m2"].get<double>(), drawn_m2, 1e-6);
    EXPECT_LE(drawn_m2, summary["overlap_m2"].get<double>() + 0.01);
    return drawn_m2;
  };
  EXPECT_LT(beyond("hard"), 0.01);
  EXPECT_GT(beyond("soft"), 1);
}

TEST_F(ServerTest, PlansAsInAPaperButForWhatIsGiven) {
  const std::string field = served.field_of("plain-metres.gpkg");
  const std::string id = served.planned(field, {{"like", "versleijen"}, {"end_rule", "cover"}});
  const ordered_json summary = served.get("/plans/" + id).json["summary"];
  EXPECT_EQ(summary["strategy"], "sweep");
  EXPECT_EQ(summary["avoid"], "paper");
  EXPECT_EQ(summary["end_rule"], "cover");
}

/// The plan's id; a draft that is made as a page does when something changes.
std::string drafted(const Served& served, const std::string& field, double width_m) {
  const ordered_json job =
      served.job_of(served.post("/jobs", {{"kind", "plan"},
                                          {"field", field},
                                          {"machine", {{"width_m", width_m}, {"radius_m", 6}}},
                                          {"settings", {{"strategy", "sweep"}}},
                                          {"draft", true}}));
  EXPECT_EQ(job.value("state", ""), "done") << job.dump();
  return job["result"].value("plan", "");
}

std::set<std::string> ids_of(const Served& served, const std::string& field) {
  std::set<std::string> out;
  for (const auto& plan : served.get("/plans?field=" + field).json) out.insert(std::string(plan["id"]));
  return out;
}

TEST_F(ServerTest, ADraftReplacesTheDraftOfItsFieldAndNothingElse) {
  const std::string field = served.field_of("plain-metres.gpkg"), other = served.field_of("roadside.geojson");
  const std::string plan = served.planned(field), elsewhere = drafted(served, other, 6);
  const std::string first = drafted(served, field, 6);
  EXPECT_EQ(served.get("/plans/" + first).json["draft"], true);
  EXPECT_EQ(ids_of(served, field), (std::set<std::string>{plan, first}));
  const std::string second = drafted(served, field, 7);
  EXPECT_EQ(ids_of(served, field), (std::set<std::string>{plan, second}));
  EXPECT_EQ(served.get("/plans/" + first).status, 404);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "plans" / (first + ".gpkg")));
  EXPECT_EQ(served.get("/plans/" + plan).json["draft"], false);
  // A plan that was asked for leaves the draft alone.
  const std::string third = served.planned(field);
  EXPECT_EQ(ids_of(served, field), (std::set<std::string>{plan, second, third}));
  EXPECT_EQ(ids_of(served, other), std::set<std::string>{elsewhere});
}

TEST_F(ServerTest, WhatSomebodyWantsIsNoDraftAnyMore) {
  const std::string field = served.field_of("plain-metres.gpkg");
  const auto wanted = [&](const char* how, const auto& want) {
    const std::string plan = drafted(served, field, 6);
    want("/plans/" + plan);
    EXPECT_EQ(served.get("/plans/" + plan).json["draft"], false) << how;
    drafted(served, field, 7);
    EXPECT_EQ(served.get("/plans/" + plan).status, 200) << how;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "plans" / (plan + ".gpkg"))) << how;
  };
  wanted("named", [&](const std::string& path) {
    EXPECT_EQ(served.patch(path, {{"name", "spring"}}).json["draft"], false);
  });
  wanted("kept", [&](const std::string& path) {
    const Got kept = served.patch(path, {{"draft", false}});
    EXPECT_EQ(kept.status, 200) << kept.text;
    EXPECT_EQ(kept.json["draft"], false);
  });
  wanted("taken away",
         [&](const std::string& path) { EXPECT_EQ(served.get(path + "/files/gpkg").status, 200); });
  wanted("looked at",
         [&](const std::string& path) { EXPECT_EQ(served.get(path + "/files/png").status, 200); });
  EXPECT_EQ(served.get("/plans?field=" + field).json.size(), 5U)
      << "four that are wanted, and the newest draft";
}

TEST_F(ServerTest, RefusesDraftsThatAreNone) {
  const std::string field = served.field_of("plain-metres.gpkg");
  const ordered_json machine{{"width_m", 6}, {"radius_m", 6}};
  const auto refused = [&](ordered_json body) {
    const Got got = served.post("/jobs", body);
    EXPECT_EQ(got.status, 400) << got.text;
  };
  refused({{"kind", "plan"}, {"field", field}, {"machine", machine}, {"draft", "yes"}});
  refused({{"kind", "plan"}, {"field", field}, {"machine", machine}, {"draft", true}, {"name", "spring"}});
  refused({{"kind", "compare"}, {"field", field}, {"machine", machine}, {"draft", true}});
  const std::string path = "/plans/" + served.planned(field);
  EXPECT_EQ(served.patch(path, {{"draft", true}}).status, 400);
  EXPECT_EQ(served.patch(path, ordered_json::object()).status, 400);
  EXPECT_EQ(served.patch("/plans/none", {{"draft", false}}).status, 404);
}

TEST(Drafts, StayDraftsWhenTheServerStartsAgain) {
  const testing_support::TemporaryFolder folder;
  std::string field, draft;
  {
    const Served served(folder.path());
    field = served.field_of("plain-metres.gpkg");
    draft = drafted(served, field, 6);
  }
  const Served served(folder.path());
  EXPECT_EQ(served.get("/plans/" + draft).json["draft"], true);
  const std::string next = drafted(served, field, 7);
  EXPECT_EQ(ids_of(served, field), std::set<std::string>{next});
}

TEST_F(ServerTest, PlanFilesOpenInAGisAndHold) {
  const std::string id = served.planned(served.field_of("plain-metres.gpkg"));
  const auto path = folder.path() / "plans" / (id + ".gpkg");
  {
    const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
    ASSERT_NE(file, nullptr);
    EXPECT_GT(file->GetLayerByName("tracks")->GetFeatureCount(), 0);
  }
  EXPECT_TRUE(check::verify(io::read_plan(path)).holds());
  const Got begun = served.post("/jobs", {{"kind", "check"}, {"plan", id}});
  EXPECT_EQ(begun.status, 202);
  EXPECT_EQ(served.finished(begun.json)["result"]["check"]["ok"], true);
}

TEST_F(ServerTest, LayersAreThereOneByOne) {
  const std::string id = served.planned(served.field_of("riverside.geojson"), {{"strategy", "sweep"}});
  const ordered_json summary = served.get("/plans/" + id).json["summary"];
  const ordered_json layers = served.get("/plans/" + id + "/layers").json;
  std::set<std::string> names;
  for (const auto& layer : layers) {
    const std::string name = layer["name"];
    names.insert(name);
    const Got shapes = served.get("/plans/" + id + "/layers/" + name);
    ASSERT_EQ(shapes.status, 200) << name << shapes.text;
    EXPECT_EQ(shapes.json["features"].size(), layer["features"]) << name;
    if (name == "overlap") {
      EXPECT_EQ(layer["m2"], summary["overlap_m2"]);
    }
    if (name != "tracks") continue;
    EXPECT_EQ(layer["m"], summary["track_length_m"]);
    // riverside lies about 9.15° east, 52.69° north.
    const auto& first = shapes.json["features"][0];
    EXPECT_NEAR(first["geometry"]["coordinates"][0][0], 9.15, 0.01);
    EXPECT_NEAR(first["geometry"]["coordinates"][0][1], 52.694, 0.01);
    EXPECT_EQ(first["properties"]["order"], 1);
  }
  EXPECT_TRUE(names.contains("uncovered") && names.contains("swaths") && names.contains("headland_passes"));
  EXPECT_EQ(served.get("/plans/" + id + "/layers/metadata").status, 400);
  EXPECT_EQ(served.get("/plans/" + id + "/layers/none").status, 400);
}

TEST_F(ServerTest, EveryFileCanBeTakenAway) {
  const std::string id = served.planned(served.field_of("roadside.geojson"), {{"strategy", "sweep"}});
  served.patch("/plans/" + id, {{"name", "M\xC3\xBChle \"1\"\r\nX: y"}});
  const std::pair<const char*, const char*> starts[] = {
      {"gpkg", "SQLite format 3"}, {"geojson", "{"},   {"flatgeobuf", "fgb"}, {"kml", "<?xml"},
      {"shapefile", "PK"},         {"png", "\x89PNG"}, {"svg", "<?xml"},      {"pdf", "%PDF"}};
  for (const auto& [format, start] : starts) {
    const Got file = served.get("/plans/" + id + "/files/" + format);
    EXPECT_EQ(file.status, 200) << format << file.text;
    EXPECT_TRUE(file.text.starts_with(start)) << format;
    const std::string disposition = file.headers.find("Content-Disposition")->second;
    EXPECT_TRUE(disposition.starts_with("attachment; filename=\"M--hle--1---X--y.")) << disposition;
    EXPECT_FALSE(file.headers.contains("X")) << "a name is no header";
  }
  EXPECT_EQ(served.get("/plans/" + id + "/files/exe").status, 404);
  EXPECT_EQ(served.get("/plans/" + id + "/files/flatgeobuf?crs=EPSG:25832").status, 200);
  const Got wrong = served.get("/plans/" + id + "/files/flatgeobuf?crs=EPSG:0");
  EXPECT_EQ(wrong.status, 400) << wrong.text;
}

TEST_F(ServerTest, TracksFollowALineThatWasDrawn) {
  const std::string field = served.post("/fields", {{"name", "square"}, {"geometry", square()}}).json["id"];
  const std::string straight = served.planned(field, {{"line", {{9.0004, 50.0001}, {9.0024, 50.0017}}}});
  const ordered_json plan = served.get("/plans/" + straight).json["summary"];
  // 0.002° of longitude and 0.0016° of latitude at 50° north, in metres: 143.39 east and 177.97 north.
  EXPECT_NEAR(plan["direction_deg"][0], std::atan2(143.39, 177.97) * 180 / 3.14159265358979, 0.1);
  const std::string curved =
      served.planned(field, {{"line", {{9.0002, 50.0001}, {9.0012, 50.0004}, {9.0026, 50.0004}}}});
  EXPECT_EQ(served.get("/plans/" + curved).json["summary"]["kind"], "curved");
  const Got far = served.post("/jobs", {{"kind", "plan"},
                                        {"field", field},
                                        {"machine", {{"width_m", 6}, {"radius_m", 6}}},
                                        {"settings", {{"line", {{10, 51}, {10.1, 51}}}}}});
  EXPECT_EQ(far.status, 400) << far.text;
}

TEST_F(ServerTest, ComparesPlansAndKeepsOne) {
  const std::string field = served.field_of("plain-metres.gpkg");
  const Got begun = served.post(
      "/jobs", {{"kind", "compare"}, {"field", field}, {"machine", {{"width_m", 6}, {"radius_m", 6}}}});
  ASSERT_EQ(begun.status, 202) << begun.text;
  const ordered_json job = served.finished(begun.json);
  const std::string front = job["result"]["front"];
  const ordered_json compared = served.get("/fronts/" + front).json;
  ASSERT_GT(compared["front"].size(), 1U);
  const Got kept = served.post("/fronts/" + front + "/points/2", ordered_json::object());
  ASSERT_EQ(kept.status, 201) << kept.text;
  const ordered_json plan = served.get("/plans/" + std::string(kept.json["plan"])).json;
  EXPECT_EQ(plan["summary"]["overlap_m2"], compared["front"][1]["overlap_m2"]);
  EXPECT_EQ(plan["summary"]["turns"], compared["front"][1]["turns"]);
  EXPECT_EQ(plan["field"], field);
  for (const char* wrong : {"0", "99999", "x", "-1", "1.5"})
    EXPECT_EQ(served.post("/fronts/" + front + "/points/" + wrong, ordered_json::object()).status, 404)
        << wrong;
  EXPECT_EQ(served.get("/fronts/none").status, 404);
  const Got curved = served.post("/jobs", {{"kind", "compare"},
                                           {"field", field},
                                           {"machine", {{"width_m", 6}, {"radius_m", 6}}},
                                           {"settings", {{"curved", "auto"}}}});
  EXPECT_EQ(curved.status, 400);
}

}  // namespace
}  // namespace tramline::server
