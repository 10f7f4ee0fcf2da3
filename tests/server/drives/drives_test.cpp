// Drives over HTTP: uploaded, evaluated, looked at, taken away, refused.

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "server/drives/drives_on_server.h"
#include "server/drives/shown_replay.h"
#include "support/refusals.h"
#include "tramline/io/coverage/read_coverage.h"

namespace tramline::server {
namespace {

using testing_support::mentions;

/// One that is evaluated here, too.
class EvaluatedDrive : public Drives {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "own.csv") << log_;
    whole_ = evaluated_here(folder_ / "own.csv");
    sent_ = here_.upload("spraying.csv", log_).json;
    field_ = new_field();
    drive_ = new_drive({{"upload", sent_.at("id")}, {"field", field_}, {"name", "Tuesday"}});
    ASSERT_TRUE(drive_.is_object());
    path_ = "/drives/" + drive_.at("id").get<std::string>();
  }

  const std::string log_ = joined(csv_lines(1500));
  Coverage whole_;
  ordered_json sent_, drive_;
  std::string field_, path_;
};

TEST_F(EvaluatedDrive, SaysWhatEvaluateSays) {
  ASSERT_EQ(sent_.at("logs").size(), 1U);
  EXPECT_EQ(sent_["logs"][0].at("fixes"), 1500);
  EXPECT_EQ(sent_["logs"][0].at("width_m"), 6);
  EXPECT_EQ(drive_.at("name"), "Tuesday");
  EXPECT_EQ(drive_.at("field"), field_);
  EXPECT_EQ(drive_.at("to_s").get<double>() - drive_.at("from_s").get<double>(), 1499);
  const ordered_json& summary = drive_.at("summary");
  // The two planes are centred on places a few metres apart.
  EXPECT_NEAR(summary.at("covered_m2"), whole_.areas.covered_m2, 1e-3);
  EXPECT_NEAR(summary.at("missed_m2"), whole_.areas.missed_m2, 1e-3);
  EXPECT_NEAR(summary.at("repeated_m2"), whole_.areas.repeated_m2, 1e-3);
  EXPECT_EQ(summary.at("missed_regions"), whole_.gaps.size());
  EXPECT_EQ(summary.at("log"), "spraying.csv");
  ASSERT_EQ(drive_.at("gaps").size(), whole_.gaps.size());
  const Point gap = FrameProjection(frame_here()).to_lonlat(whole_.gaps.front().centre);
  EXPECT_NEAR(drive_["gaps"][0].at("area_m2"), whole_.gaps.front().area_m2, 1e-3);
  EXPECT_NEAR(drive_["gaps"][0].at("lon"), gap.x, 1e-6);
  EXPECT_TRUE(drive_.at("compared").is_null());
  ASSERT_EQ(drive_.at("bbox").size(), 4U);
  EXPECT_LT(drive_["bbox"][0].get<double>(), kLon);
  EXPECT_GT(drive_["bbox"][3].get<double>(), kLat);

  const ordered_json list = here_.get("/drives").json;
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].at("id"), drive_.at("id"));
  EXPECT_NEAR(list[0].at("missed_m2"), whole_.areas.missed_m2, 1e-3);
}

TEST_F(EvaluatedDrive, HasLayersForTheMap) {
  for (const char* layer : {"covered", "repeated", "missed", "multiplicity", "track", "gaps", "field"}) {
    const Got got = here_.get(path_ + "/layers/" + layer);
    ASSERT_EQ(got.status, 200) << layer << got.text;
    EXPECT_EQ(got.json.at("type"), "FeatureCollection") << layer;
    ASSERT_FALSE(got.json.at("features").empty()) << layer;
  }
  double covered_m2 = 0;
  const ordered_json covered = here_.get(path_ + "/layers/covered").json;
  for (const ordered_json& feature : covered.at("features"))
    covered_m2 += area_of_json(feature.at("geometry").at("type") == "Polygon"
                                   ? ordered_json::array({feature["geometry"]["coordinates"]})
                                   : feature["geometry"]["coordinates"]);
  EXPECT_NEAR(covered_m2, whole_.areas.covered_m2, 0.5) << "seven decimals of a degree are a centimetre";
}

TEST_F(EvaluatedDrive, CanBeTakenAwayAndDeleted) {
  EXPECT_EQ(here_.get(path_ + "/files/log").text, log_);
  EXPECT_TRUE(here_.get(path_ + "/files/png").text.starts_with("\x89PNG"));
  EXPECT_TRUE(mentions(here_.get(path_ + "/files/svg").text, "<svg"));
  const Got pdf = here_.get(path_ + "/files/pdf");
  EXPECT_TRUE(pdf.text.starts_with("%PDF"));
  EXPECT_TRUE(mentions(pdf.headers.find("Content-Disposition")->second, "attachment"));
  std::ofstream(folder_ / "taken.gpkg", std::ios::binary) << here_.get(path_ + "/files/gpkg").text;
  const Coverage taken = io::read_coverage(folder_ / "taken.gpkg");
  EXPECT_EQ(taken.areas.covered_m2, drive_.at("summary").at("covered_m2").get<double>());

  EXPECT_EQ(here_.remove(path_).status, 200);
  EXPECT_EQ(here_.get(path_).status, 404);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path() / "drives"), {}), 0);
}

TEST_F(Drives, WhatIsWrongIsSaidInASentence) {
  const std::string log = upload_log(joined(csv_lines(30)));
  for (const char* body : {"", "{", "[1]", "\"x\"", "{\"upload\": 7}", "{\"what\": 1}"}) {
    const Got got = here_.post_text("/drives", body);
    EXPECT_EQ(got.status, 400) << body;
    EXPECT_EQ(got.code(), "bad_input");
    EXPECT_FALSE(got.message().empty());
  }
  EXPECT_EQ(here_.post("/drives", {{"upload", "none"}}).status, 404);
  EXPECT_EQ(here_.post("/drives", {{"upload", log}, {"field", "none"}}).status, 404);
  EXPECT_EQ(here_.post("/drives", {{"upload", log}, {"plan", "none"}}).status, 404);
  EXPECT_EQ(here_.post("/drives", {{"upload", log}, {"width_m", -1}}).status, 400);
  EXPECT_EQ(here_.post("/drives", {{"upload", log}, {"options", {{"quads", "round"}}}}).status, 400);
  EXPECT_EQ(here_.post("/drives", {{"upload", log}, {"options", {{"max_gap_s", 0}}}}).status, 400);
  EXPECT_EQ(here_.post("/drives", {{"upload", log}, {"options", {{"speed", 1}}}}).status, 400);
  for (const ordered_json& wrong :
       {ordered_json{{"engine", "meshes"}}, ordered_json{{"mesh_m", 0.001}}, ordered_json{{"mesh_m", 1.5}},
        ordered_json{{"mesh_m", "fine"}}, ordered_json{{"headings", "north"}}}) {
    const Got refused = here_.post("/drives", {{"upload", log}, {"options", wrong}});
    EXPECT_EQ(refused.status, 400) << wrong;
    EXPECT_TRUE(mentions(refused.message(), wrong.begin().key())) << refused.message();
  }
  EXPECT_EQ(here_.post("/jobs", {{"kind", "evaluate"}, {"drive", "none"}}).status, 404);
  EXPECT_EQ(here_.post("/jobs", {{"kind", "repair"}, {"drive", "none"}, {"machine", {}}}).status, 404);

  const Got field_file = here_.upload("f.geojson", polygon_json(field_here().front()).dump());
  ASSERT_EQ(field_file.status, 201) << field_file.text;
  EXPECT_TRUE(
      mentions(here_.post("/drives", {{"upload", field_file.json.at("id")}}).message(), "not a machine log"));
  EXPECT_EQ(here_.upload("empty.csv", "").status, 400);

  EXPECT_TRUE(mentions(failure_of({{"upload", upload_log("lon,lat\n10.5,52.3\n10.5001,52.3\n")}}),
                       "give the working width"));
  const std::string far = upload_log("lon,lat,width\n11.5,52.3,6\n11.5001,52.3,6\n11.5002,52.3,6\n");
  EXPECT_TRUE(mentions(failure_of({{"upload", far}, {"field", new_field()}}), "nowhere near"));
  EXPECT_TRUE(here_.get("/drives").json.empty());
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path() / "drives"), {}), 0)
      << "nothing is left of drives that failed";
}

TEST_F(Drives, UnknownIdsLayersFormatsAndSpeeds) {
  for (const char* path : {"/drives/none", "/drives/none/layers/covered", "/drives/none/files/png",
                           "/drives/none/replay", "/drives/..%2f..%2fetc%2fpasswd", "/drives/a/b/c"})
    EXPECT_EQ(here_.get(path).status, 404) << path;
  EXPECT_EQ(here_.remove("/drives/none").status, 404);
  const ordered_json drive = new_drive({{"upload", upload_log(joined(csv_lines(30)))}});
  const std::string path = "/drives/" + drive.at("id").get<std::string>();
  EXPECT_TRUE(drive.at("missed_m2").is_null());
  for (const char* what : {"/layers/metadata", "/layers/none", "/files/exe", "/layers/..", "/files/.."})
    EXPECT_EQ(here_.get(path + what).status, 404) << what;
  for (const char* query : {"?speed=0", "?speed=1e9", "?speed=x", "?from_s=now", "?speed=nan", "?from_s=inf"})
    EXPECT_EQ(here_.get(path + "/replay" + query).status, 400) << query;
  // Without a field there is nothing to repair.
  const Got repair = here_.post(
      "/jobs",
      {{"kind", "repair"}, {"drive", drive.at("id")}, {"machine", {{"width_m", 6}, {"radius_m", 5}}}});
  EXPECT_EQ(repair.status, 400);
  EXPECT_TRUE(mentions(repair.message(), "without a field")) << repair.message();
}

}  // namespace
}  // namespace tramline::server
