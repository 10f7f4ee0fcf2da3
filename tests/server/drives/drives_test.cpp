// Drives over HTTP: uploaded, evaluated, looked at, taken away, replayed, repaired, deleted.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "io/isoxml/time_log_bytes.h"
#include "io/vector/files.h"
#include "server/served.h"
#include "server/work/drives.h"
#include "support/refusals.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/geodesy/placed_log.h"
#include "tramline/geometry/region.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/io/log/read_log.h"

namespace tramline::server {
namespace {

using namespace testing_drives;
using testing_support::mentions;

ordered_json polygon_json(const Polygon& polygon) {
  const FrameProjection projection(frame_here());
  const auto ring_json = [&](Ring ring) {
    ring.push_back(ring.front());
    ordered_json out = ordered_json::array();
    for (const Point p : ring) {
      const Point at = projection.to_lonlat(p);
      out.push_back({at.x, at.y});
    }
    return out;
  };
  ordered_json rings = ordered_json::array({ring_json(polygon.outer)});
  for (const Ring& hole : polygon.holes) rings.push_back(ring_json(hole));
  return {{"type", "Polygon"}, {"coordinates", rings}};
}

/// m², of GeoJSON coordinates of a MultiPolygon.
double area_of_json(const ordered_json& polygons) {
  const FrameProjection projection(frame_here());
  Region region;
  for (const ordered_json& polygon : polygons) {
    Polygon out;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      Ring ring;
      for (const ordered_json& at : polygon[i]) ring.push_back(*projection.from_lonlat({at[0], at[1]}));
      ring.pop_back();
      if (i == 0)
        out.outer = ring;
      else
        out.holes.push_back(ring);
    }
    region.push_back(out);
  }
  return area(region);
}

/// What the frames of a stream add up to.
struct Shown {
  std::map<std::string, ordered_json> tiles{};
  ordered_json end{};
  int frames = 0;
  double first_s = 0;
  bool first_is_all = false;

  bool take(const std::string& name, const ordered_json& data) {
    if (name == "end") end = data.at("figures");
    if (name != "frame") return true;
    if (frames++ == 0) {
      first_s = data.at("time_s");
      first_is_all = data.at("all");
    }
    if (data.at("all")) tiles.clear();
    for (const ordered_json& tile : data.at("tiles")) tiles[tile.at("id")] = tile;
    return true;
  }
  double edges_m(const char* of) const {
    constexpr double kMetresPerDegree = 111320;
    double out = 0;
    for (const auto& [id, tile] : tiles)
      for (const ordered_json& polygon : tile.at(of))
        for (const ordered_json& ring : polygon)
          for (std::size_t i = 1; i < ring.size(); ++i)
            out += kMetresPerDegree * std::hypot((ring[i][0].get<double>() - ring[i - 1][0].get<double>()) *
                                                     std::cos(kLat * std::numbers::pi / 180),
                                                 ring[i][1].get<double>() - ring[i - 1][1].get<double>());
    return out;
  }
  double area_m2(const char* of) const {
    double out = 0;
    for (const auto& [id, tile] : tiles) out += area_of_json(tile.at(of));
    return out;
  }
};

class Drives : public ::testing::Test {
 protected:
  std::string new_field() {
    const Got made =
        here_.post("/fields", {{"name", "mill field"}, {"geometry", polygon_json(field_here().front())}});
    EXPECT_EQ(made.status, 201) << made.text;
    return made.json.at("id");
  }
  std::string upload_log(const std::string& bytes, const std::string& name = "spraying.csv") {
    const Got made = here_.upload(name, bytes);
    EXPECT_EQ(made.status, 201) << made.text;
    EXPECT_EQ(made.json.value("kind", ""), "log") << made.text;
    return made.json.value("id", "");
  }
  ordered_json new_drive(ordered_json request) {
    const ordered_json job = here_.job_of(here_.post("/drives", request));
    EXPECT_EQ(job.at("state"), "done") << job.dump();
    if (job.at("state") != "done") return {};
    return here_.get("/drives/" + job.at("result").at("drive").get<std::string>()).json;
  }
  /// The sentence with which a drive is refused when it is evaluated.
  std::string failure_of(const ordered_json& request) {
    const ordered_json job = here_.job_of(here_.post("/drives", request));
    EXPECT_EQ(job.at("state"), "failed") << job.dump();
    return job.at("error").dump();
  }

  testing_support::TemporaryFolder folder_;
  Served here_{folder_.path()};
};

Coverage evaluated_here(const std::filesystem::path& log) {
  return coverage::evaluate(placed(io::read_log(log), frame_here()), field_here(), {}, {});
}

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

TEST_F(Drives, TilesOfAReplayAddUpToTheWhole) {
  const std::string log = joined(csv_lines(1500));
  const ordered_json drive = new_drive({{"upload", upload_log(log)}, {"field", new_field()}});
  const std::string path = "/drives/" + drive.at("id").get<std::string>() + "/replay";
  const double begin_s = drive.at("from_s");
  for (const auto& [from_s, speed] :
       std::vector<std::pair<double, int>>{{begin_s, 1000}, {begin_s + 1200, 300}}) {
    SCOPED_TRACE(speed);
    Shown shown;
    const int status =
        here_.follow(fmt::format("{}?from_s={}&speed={}", path, from_s, speed),
                     [&](const auto& name, const auto& data) { return shown.take(name, data); });
    EXPECT_EQ(status, 200);
    EXPECT_TRUE(shown.first_is_all);
    EXPECT_EQ(shown.first_s, from_s);
    ASSERT_TRUE(shown.end.is_object());
    const ordered_json& summary = drive.at("summary");
    for (const char* key : {"covered_m2", "covered_inside_m2", "outside_m2", "repeated_m2", "missed_m2",
                            "gross_m2", "sliver_m2"})
      EXPECT_EQ(shown.end.at(key), summary.at(key)) << key;
    EXPECT_NEAR(shown.area_m2("covered"), summary.at("covered_m2"), 0.05);
    EXPECT_NEAR(shown.area_m2("repeated"), summary.at("repeated_m2"), 0.05);
    EXPECT_GT(shown.frames, 5);
  }
}

// Outlines within 2 cm: no area differs by more than 2 cm along its edge, and no figure at all.
TEST_F(Drives, TilesForTheEyeAreSmallerAndWithinWhatIsAskedFor) {
  std::vector<std::string> lines = csv_lines(1500);
  for (std::size_t i = 1; i < lines.size(); ++i)  // a machine that sways by a few millimetres
    lines[i] = csv_line(static_cast<int>(i - 1) * 10,
                        lanes(1500)[i - 1] + Point{0, 4e-8 * std::sin(static_cast<double>(i))}, 6);
  const ordered_json drive = new_drive({{"upload", upload_log(joined(lines))}, {"field", new_field()}});
  struct Seen {
    Shown shown{};
    std::size_t bytes = 0;
  };
  const auto seen_with = [&](const char* detail) {
    Seen out;
    here_.follow(fmt::format("/drives/{}/replay?from_s={}&speed=1000{}", drive.at("id").get<std::string>(),
                             drive.at("to_s").get<double>(), detail),
                 [&](const auto& name, const auto& data) {
                   out.bytes += data.dump().size();
                   return out.shown.take(name, data);
                 });
    return out;
  };
  const Seen all = seen_with(""), eye = seen_with("&detail_m=0.02");
  EXPECT_EQ(eye.shown.frames, 1);
  EXPECT_LT(2 * eye.bytes, all.bytes) << eye.bytes << " of " << all.bytes;
  EXPECT_EQ(eye.shown.end, all.shown.end);
  for (const char* of : {"covered", "repeated"})
    EXPECT_NEAR(eye.shown.area_m2(of), all.shown.area_m2(of), 0.02 * all.shown.edges_m(of)) << of;
  for (const char* wrong : {"-1", "11", "x", "nan"})
    EXPECT_EQ(here_.get("/drives/" + drive.at("id").get<std::string>() + "/replay?detail_m=" + wrong).status,
              400)
        << wrong;
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
  EXPECT_EQ(here_.post("/jobs", {{"kind", "evaluate"}, {"drive", "none"}}).status, 404);
  EXPECT_EQ(here_.post("/jobs", {{"kind", "repair"}, {"drive", "none"}, {"machine", {}}}).status, 404);

  const Got field_file = here_.upload("f.geojson", polygon_json(field_here().front()).dump());
  ASSERT_EQ(field_file.status, 201) << field_file.text;
  EXPECT_TRUE(mentions(here_.post("/drives", {{"upload", field_file.json.at("id")}}).message(), "no log"));
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
  const ordered_json job =
      here_.job_of(here_.post("/jobs", {{"kind", "plan"}, {"field", field}, {"machine", machine}}));
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

std::string task_set_with_partfield(const testing_support::TemporaryFolder& folder) {
  const auto position = [](Point p) {
    return fmt::format(R"(<PNT A="10" C="{:.9f}" D="{:.9f}"/>)", p.y, p.x);
  };
  const FrameProjection projection(frame_here());
  std::string ring;
  const Region field = field_here();
  for (const Point p : field.front().outer) ring += position(projection.to_lonlat(p));
  const std::string tasks =
      R"(<?xml version="1.0"?><ISO11783_TaskData VersionMajor="4"><PFD A="PFD1" C="mill"><PLN A="1"><LSG A="1">)" +
      ring + R"(</LSG></PLN></PFD><TSK A="TSK1" B="spray" E="PFD1"><TLG A="TLG00001"/></TSK>)" +
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

TEST_F(Drives, ThePartfieldOfATaskSetBecomesAField) {
  const Got sent = here_.upload("TASKDATA.zip", task_set_with_partfield(folder_));
  ASSERT_EQ(sent.status, 201) << sent.text;
  EXPECT_EQ(sent.json.at("kind"), "log");
  ASSERT_EQ(sent.json.at("logs").size(), 2U);
  EXPECT_EQ(sent.json["logs"][0].at("partfield"), "PFD1");
  const std::string upload = sent.json.at("id");
  const ordered_json drive = new_drive({{"upload", upload}, {"log", "TLG00001"}});
  ASSERT_TRUE(drive.at("field").is_string()) << drive.dump();
  EXPECT_EQ(here_.get("/fields").json.size(), 1U);
  EXPECT_NEAR(drive.at("summary").at("field_area_m2"), 200 * 150, 1);
  EXPECT_GT(drive.at("missed_m2").get<double>(), 1000);
  // The same partfield again is the same field; a log that names none has none.
  EXPECT_EQ(new_drive({{"upload", upload}, {"log", "TLG00001"}}).at("field"), drive.at("field"));
  EXPECT_EQ(here_.get("/fields").json.size(), 1U);
  EXPECT_TRUE(new_drive({{"upload", upload}, {"log", "TLG00002"}}).at("field").is_null());
  EXPECT_TRUE(mentions(failure_of({{"upload", upload}, {"log", "TLG00009"}}), "TLG00001"));
}

TEST_F(Drives, RealLogsReplayedEndWithWhatEvaluateSays) {
  const char* data = std::getenv("TRAMLINE_DATA");
  const std::filesystem::path logs = std::filesystem::path(data == nullptr ? "" : data) / "logs";
  if (data == nullptr || !std::filesystem::is_directory(logs))
    GTEST_SKIP() << "no folder of real logs: set TRAMLINE_DATA";
  int done = 0;
  for (const char* name : {"isoxml_jdsprayer_TLG00015.csv", "isoxml_microtrak_TLG00004.csv",
                           "isoxml_sh2020_TLG00002.csv", "yield_gartner_corn_mn.csv"}) {
    if (!std::filesystem::exists(logs / name)) {
      std::cout << "skipped, not there: " << name << "\n";
      continue;
    }
    SCOPED_TRACE(name);
    const Got sent = here_.upload(name, testing_support::bytes_of(logs / name));
    if (sent.status != 201 || sent.json.value("kind", "") != "log") {
      std::cout << "skipped, no log: " << sent.text << "\n";
      continue;
    }
    const ordered_json drive = new_drive({{"upload", sent.json.at("id")}, {"width_m", 12}});
    if (!drive.is_object()) continue;
    Shown shown;
    here_.follow(fmt::format("/drives/{}/replay?speed=1000&from_s={}", drive.at("id").get<std::string>(),
                             drive.at("to_s").get<double>() - 1500),
                 [&](const auto& event, const auto& json) { return shown.take(event, json); });
    EXPECT_EQ(shown.end.at("covered_m2"), drive.at("summary").at("covered_m2"));
    EXPECT_EQ(shown.end.at("repeated_m2"), drive.at("summary").at("repeated_m2"));
    ++done;
  }
  EXPECT_GE(done, 3);
}

}  // namespace
}  // namespace tramline::server
