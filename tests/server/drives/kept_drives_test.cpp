// Drives that are kept: renamed, compared with plans, repaired, evaluated anew, found again.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "io/isoxml/time_log_bytes.h"
#include "io/vector/files.h"
#include "server/drives/drives_on_server.h"
#include "server/drives/shown_replay.h"
#include "support/refusals.h"

namespace tramline::server {
namespace {

using testing_support::mentions;

TEST_F(Drives, AreRenamedForGood) {
  const std::string id = new_drive({{"upload", upload_log(joined(csv_lines(30)))}}).at("id");
  ordered_json before = here_.get("/drives/" + id).json;
  const Got renamed = here_.patch("/drives/" + id, {{"name", "first cut"}});
  EXPECT_EQ(renamed.status, 200) << renamed.text;
  EXPECT_EQ(renamed.json["name"], "first cut");
  before["name"] = "first cut";
  EXPECT_EQ(here_.get("/drives/" + id).json, before) << "a name changes nothing else";
  std::ifstream file(folder_.path() / "drives" / (id + ".json"));
  EXPECT_EQ(ordered_json::parse(file)["name"], "first cut");
  EXPECT_EQ(here_.patch("/drives/" + id, {{"name", ""}}).status, 400);
  EXPECT_EQ(here_.patch("/drives/" + id, {{"field", "x"}}).status, 400);
  EXPECT_EQ(here_.patch("/drives/none", {{"name", "x"}}).status, 404);
}

TEST_F(Drives, ADraftThatADriveIsComparedWithStays) {
  const std::string field = new_field();
  const auto drafted = [&](double width_m) {
    const ordered_json job =
        here_.job_of(here_.post("/jobs", {{"kind", "plan"},
                                          {"field", field},
                                          {"machine", {{"width_m", width_m}, {"radius_m", 5}}},
                                          {"draft", true}}));
    return job.at("result").at("plan").get<std::string>();
  };
  const std::string plan = drafted(6);
  new_drive({{"upload", upload_log(joined(csv_lines(60)))}, {"field", field}, {"plan", plan}});
  const std::string next = drafted(7), last = drafted(8);
  EXPECT_EQ(here_.get("/plans/" + plan).json["draft"], false);
  EXPECT_EQ(here_.get("/plans/" + next).status, 404);
  EXPECT_EQ(here_.get("/plans/" + last).status, 200);
}

TEST_F(Drives, WhatWasMissedIsPlannedAndComparedWithAPlan) {
  const std::string field = new_field();
  const ordered_json machine = {{"width_m", 6}, {"radius_m", 5}};
  const ordered_json quick = {{"strategy", "sweep"}, {"route", false}};
  const ordered_json job = here_.job_of(
      here_.post("/jobs", {{"kind", "plan"}, {"field", field}, {"machine", machine}, {"settings", quick}}));
  ASSERT_EQ(job.at("state"), "done") << job.dump();
  const std::string plan = job.at("result").at("plan");
  const ordered_json drive =
      new_drive({{"upload", upload_log(joined(csv_lines(1500)))}, {"field", field}, {"plan", plan}});
  const ordered_json& compared = drive.at("compared");
  ASSERT_TRUE(compared.is_object());
  EXPECT_GT(compared.at("planned_m2").get<double>(), 25000);
  // What the plan works is about the field; what is missed of it, about what is missed of the field.
  EXPECT_NEAR(compared.at("planned_missed_m2"), drive.at("missed_m2"), 1500);

  const ordered_json repaired = here_.job_of(here_.post(
      "/jobs", {{"kind", "repair"}, {"drive", drive.at("id")}, {"machine", machine}, {"min_area_m2", 5}}));
  ASSERT_EQ(repaired.at("state"), "done") << repaired.dump();
  const ordered_json& report = repaired.at("result").at("report");
  EXPECT_NEAR(report.at("missed_before_m2"), drive.at("missed_m2"), 0.5);
  EXPECT_LT(report.at("missed_after_m2").get<double>(), 0.2 * report.at("missed_before_m2").get<double>());
  EXPECT_EQ(report.at("min_area_m2"), 5);
  const ordered_json kept = here_.get("/plans/" + repaired["result"].at("plan").get<std::string>()).json;
  EXPECT_EQ(kept.at("kind"), "repair");
  EXPECT_EQ(kept.at("field"), field);
  for (const double least : {0.0, -1.0, 1e12})
    EXPECT_EQ(
        here_
            .post(
                "/jobs",
                {{"kind", "repair"}, {"drive", drive.at("id")}, {"machine", machine}, {"min_area_m2", least}})
            .status,
        400);
}

TEST_F(Drives, IsEvaluatedAnewAndOutlivesTheServer) {
  testing_support::TemporaryFolder folder;
  std::string id;
  {
    Served first(folder.path());
    const Got sent = first.upload("drive.csv", joined(csv_lines(200)));
    const ordered_json job = first.job_of(first.post(
        "/drives", {{"upload", sent.json.at("id")}, {"options", {{"repeat", "strict"}, {"max_gap_s", 20}}}}));
    id = job.at("result").at("drive");
    // A drive whose evaluation was cut short, and somebody's own file.
    std::ofstream(folder / "drives/20260314-081500-k3f9ab.csv") << "x";
    std::ofstream(folder / "drives/notes.txt") << "mine";
    std::ofstream(folder / "drives/damaged.json") << "{";
  }
  Served second(folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder / "drives/20260314-081500-k3f9ab.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "drives/notes.txt"));
  EXPECT_TRUE(std::filesystem::exists(folder / "drives/damaged.json"));
  ASSERT_EQ(second.get("/drives").json.size(), 1U);
  const ordered_json before = second.get("/drives/" + id).json;
  EXPECT_EQ(before.at("options").at("repeat"), "strict");
  const ordered_json job = second.job_of(second.post("/jobs", {{"kind", "evaluate"}, {"drive", id}}));
  EXPECT_EQ(job.at("state"), "done") << job.dump();
  const ordered_json after = second.get("/drives/" + id).json;
  EXPECT_EQ(after.at("summary").at("covered_m2"), before.at("summary").at("covered_m2"));
  EXPECT_EQ(after.at("options"), before.at("options"));
  Shown shown;
  second.follow("/drives/" + id + "/replay?speed=1000",
                [&](const auto& name, const auto& data) { return shown.take(name, data); });
  EXPECT_EQ(shown.end.at("repeated_m2"), after.at("summary").at("repeated_m2"));
}

// The scale is the user's: the same drive by other meshes, and exactly again. Which log it is, how wide the
// machine is and the name stay.
TEST_F(Drives, IsEvaluatedAnewWithOtherOptions) {
  const ordered_json exact = new_drive({{"upload", upload_log(joined(csv_lines(300)))},
                                        {"field", new_field()},
                                        {"name", "Tuesday"},
                                        {"options", {{"max_gap_s", 20}}}});
  const std::string id = exact.at("id");
  const auto anew = [&](const ordered_json& options) {
    const ordered_json job =
        here_.job_of(here_.post("/jobs", {{"kind", "evaluate"}, {"drive", id}, {"options", options}}));
    EXPECT_EQ(job.at("state"), "done") << job.dump();
    return here_.get("/drives/" + id).json;
  };
  EXPECT_FALSE(exact.at("summary").contains("meshes"));
  const ordered_json meshes = anew({{"engine", "mesh"}, {"mesh_m", 0.25}});
  EXPECT_EQ(meshes.at("name"), "Tuesday");
  EXPECT_EQ(meshes.at("options").at("engine"), "mesh");
  EXPECT_EQ(meshes.at("options").at("max_gap_s"), 10) << "in the place of those that it had";
  EXPECT_EQ(meshes.at("summary").at("meshes").at("side_m"), 0.25);
  const double covered_m2 = exact.at("summary").at("covered_m2");
  EXPECT_NEAR(meshes.at("summary").at("covered_m2"), covered_m2, 0.01 * covered_m2);
  EXPECT_NE(meshes.at("summary").at("covered_m2"), exact.at("summary").at("covered_m2"));
  ordered_json again = anew({{"max_gap_s", 20}});
  ordered_json before = exact;
  for (ordered_json* one : {&again, &before}) (*one)["summary"].erase("seconds");
  EXPECT_EQ(again, before);
  EXPECT_EQ(here_.post("/jobs", {{"kind", "evaluate"}, {"drive", id}, {"options", {{"mesh_m", 2}}}}).status,
            400);
  EXPECT_EQ(here_.get("/drives/" + id).json.at("options"), exact.at("options"));
}

// East, north, west, south: logged as angles anticlockwise from east.
TEST_F(Drives, HeadingsThatContradictTheWayAreTold) {
  const FrameProjection projection(frame_here());
  std::string log = "time,lon,lat,width,heading\n";
  Point at{0, 0};
  for (int i = 0; i < 80; ++i) {
    const Point place = projection.to_lonlat(at);
    const int angle_deg = 90 * (i / 20);
    log += fmt::format("{},{}\n", csv_line(i * 10, place, 6), angle_deg);
    at = at + 1.5 * Point{std::cos(angle_deg * std::numbers::pi / 180),
                          std::sin(angle_deg * std::numbers::pi / 180)};
  }
  const std::string upload = upload_log(log);
  const ordered_json wrong = new_drive({{"upload", upload}});
  const ordered_json& found = wrong.at("summary").at("headings");
  EXPECT_EQ(found.at("read_as"), "compass");
  EXPECT_EQ(found.at("steps"), 79);
  EXPECT_GE(found.at("off").get<int>(), 76) << "all but perhaps where it turns";
  EXPECT_EQ(found.at("better"), "math");
  EXPECT_TRUE(mentions(wrong.at("summary").at("warnings").dump(), "headings"));
  const ordered_json right = new_drive({{"upload", upload}, {"options", {{"headings", "math"}}}});
  EXPECT_FALSE(right.at("summary").contains("headings"));
  EXPECT_GT(right.at("covered_m2").get<double>(), 5 * wrong.at("covered_m2").get<double>());
  const ordered_json track = new_drive({{"upload", upload}, {"options", {{"headings", "from-track"}}}});
  EXPECT_NEAR(track.at("covered_m2"), right.at("covered_m2"), 0.05 * right.at("covered_m2").get<double>());
}

/// `name` is an attribute of the partfield, or nothing.
std::string task_set_with_partfield(const testing_support::TemporaryFolder& folder,
                                    const std::string& name = R"(C="mill")") {
  const auto position = [](Point p) {
    return fmt::format(R"(<PNT A="10" C="{:.9f}" D="{:.9f}"/>)", p.y, p.x);
  };
  const FrameProjection projection(frame_here());
  std::string ring;
  const Region field = field_here();
  for (const Point p : field.front().outer) ring += position(projection.to_lonlat(p));
  const std::string tasks =
      R"(<?xml version="1.0"?><ISO11783_TaskData VersionMajor="4"><PFD A="PFD1" )" + name +
      R"(><PLN A="1"><LSG A="1">)" + ring +
      R"(</LSG></PLN></PFD><TSK A="TSK1" B="spray" E="PFD1"><TLG A="TLG00001"/></TSK>)" +
      R"(<TSK A="TSK2" B="mow"><TLG A="TLG00002"/></TSK></ISO11783_TaskData>)";
  std::string records;
  std::uint32_t ms = 0;
  for (const Point p : lanes(400))
    records += testing_logs::record(ms += 1000, 14611, static_cast<std::int32_t>(std::lround(p.y * 1e7)),
                                    static_cast<std::int32_t>(std::lround(p.x * 1e7)), 4, {{0, 6000}});
  const std::string header = testing_logs::header(R"(<DLV A="0043" B="" C="DET-1"/>)");
  const std::string zip = (folder / "set.zip").string();
  testing_files::write_zip(zip, {{"TASKDATA/TASKDATA.XML", tasks},
                                 {"TASKDATA/TLG00001.xml", header},
                                 {"TASKDATA/TLG00001.bin", records},
                                 {"TASKDATA/TLG00002.xml", header},
                                 {"TASKDATA/TLG00002.bin", records}});
  return testing_support::bytes_of(zip);
}

TEST_F(Drives, APartfieldWithoutADesignatorIsCalledByItsId) {
  for (const char* none : {"", R"(C="")", R"(C=" ")"}) {
    const Got sent = here_.upload("TASKDATA.zip", task_set_with_partfield(folder_, none));
    const ordered_json drive = new_drive({{"upload", sent.json.at("id")}, {"log", "TLG00001"}});
    const std::string path = "/fields/" + drive.at("field").get<std::string>();
    EXPECT_EQ(here_.get(path).json.at("name"), "PFD1") << none;
    EXPECT_EQ(here_.remove(path).status, 200);
  }
}

TEST_F(Drives, ThePartfieldOfATaskSetBecomesAField) {
  const Got sent = here_.upload("TASKDATA.zip", task_set_with_partfield(folder_));
  ASSERT_EQ(sent.status, 201) << sent.text;
  EXPECT_EQ(sent.json.at("kind"), "log");
  ASSERT_EQ(sent.json.at("logs").size(), 2U);
  EXPECT_EQ(sent.json["logs"][0].at("partfield"), "PFD1");
  const std::string upload = sent.json.at("id");
  const ordered_json drive = new_drive({{"upload", upload}, {"log", "TLG00001"}});
  ASSERT_TRUE(drive.at("field").is_string()) << drive.dump();
  const ordered_json fields = here_.get("/fields").json;
  ASSERT_EQ(fields.size(), 1U);
  EXPECT_EQ(fields[0].at("name"), "mill") << "its designator";
  EXPECT_NEAR(drive.at("summary").at("field_area_m2"), 200 * 150, 1);
  EXPECT_GT(drive.at("missed_m2").get<double>(), 1000);
  // The same partfield again is the same field; a log that names none has none.
  EXPECT_EQ(new_drive({{"upload", upload}, {"log", "TLG00001"}}).at("field"), drive.at("field"));
  EXPECT_EQ(here_.get("/fields").json.size(), 1U);
  EXPECT_TRUE(new_drive({{"upload", upload}, {"log", "TLG00002"}}).at("field").is_null());
  EXPECT_TRUE(mentions(failure_of({{"upload", upload}, {"log", "TLG00009"}}), "TLG00001"));
}

}  // namespace
}  // namespace tramline::server
