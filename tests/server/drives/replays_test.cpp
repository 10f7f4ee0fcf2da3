// Replays over HTTP: what their frames add up to.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "server/drives/drives_on_server.h"
#include "server/drives/shown_replay.h"

namespace tramline::server {
namespace {

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

// By meshes, too: as they are, and for the eye, where outlines are within a mesh of those of meshes.
TEST_F(Drives, TilesOfMeshesAddUpToTheWhole) {
  const ordered_json drive = new_drive({{"upload", upload_log(joined(csv_lines(1500)))},
                                        {"field", new_field()},
                                        {"options", {{"engine", "mesh"}, {"mesh_m", 0.1}}}});
  const ordered_json& summary = drive.at("summary");
  EXPECT_EQ(summary.at("engine"), "mesh");
  std::size_t bytes_of_all = 0;
  for (const char* detail : {"", "&detail_m=0.02"}) {
    SCOPED_TRACE(detail);
    Shown shown;
    std::size_t bytes = 0;
    here_.follow(fmt::format("/drives/{}/replay?speed=1000{}", drive.at("id").get<std::string>(), detail),
                 [&](const auto& name, const auto& data) {
                   bytes += data.dump().size();
                   return shown.take(name, data);
                 });
    ASSERT_TRUE(shown.end.is_object());
    for (const char* key : {"covered_m2", "covered_inside_m2", "outside_m2", "repeated_m2", "missed_m2",
                            "gross_m2", "sliver_m2", "meshes"})
      EXPECT_EQ(shown.end.at(key), summary.at(key)) << key;
    const bool all = bytes_of_all == 0;
    if (all) bytes_of_all = bytes;
    for (const char* of : {"covered", "repeated"})
      EXPECT_NEAR(shown.area_m2(of), summary.at(std::string(of) + "_m2"),
                  all ? 0.05 : 0.1 * shown.edges_m(of))
          << of;
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
