// Drives and feeds that are deleted, cancelled and ended while something is done with them, and what a server
// that was killed leaves of them.

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "server/http/http_error.h"
#include "server/served.h"
#include "server/store/drive_store.h"
#include "server/work/drives.h"
#include "server/work/fake_tractor.h"

namespace tramline::server {
namespace {

using namespace testing_drives;
namespace fs = std::filesystem;

class DriveRaces : public ::testing::Test {
 protected:
  std::vector<std::string> files(const char* kind) const {
    std::vector<std::string> out;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder_ / kind, none))
      out.push_back(entry.path().filename().string());
    return out;
  }
  /// A job for a drive of so many fixes.
  static Got begun(const Served& server, int fixes) {
    const Got sent = server.upload("drive.csv", joined(csv_lines(fixes)));
    EXPECT_EQ(sent.status, 201) << sent.text;
    return server.post("/drives", {{"upload", sent.json.at("id")}});
  }
  static std::string kept(const Served& server, int fixes) {
    return server.job_of(begun(server, fixes)).at("result").at("drive");
  }
  static void wait_for_jobs(const Served& server) {
    for (const ordered_json& job : server.get("/jobs").json) server.finished(job);
  }

  testing_support::TemporaryFolder folder_;
};

TEST_F(DriveRaces, AJobCancelledWhileItWaitsLeavesNoLog) {
  ServerSettings settings;
  settings.limits.jobs = 0;
  const Served here(folder_.path(), settings);
  const Got job = begun(here, 50);
  ASSERT_EQ(job.json.at("state"), "queued");
  EXPECT_EQ(files("drives").size(), 1U);
  EXPECT_EQ(here.remove("/jobs/" + job.json.at("id").get<std::string>()).json.at("state"), "cancelled");
  EXPECT_TRUE(files("drives").empty());
}

// Wherever it is by then: either it is over, and the drive is there whole, or there is nothing of it.
TEST_F(DriveRaces, AJobCancelledAtAnyStageLeavesAllOrNothing) {
  const Served here(folder_.path());
  int cancelled = 0;
  for (int i = 0; i < 15; ++i) {
    const Got job = begun(here, 3000);
    std::this_thread::sleep_for(std::chrono::milliseconds(10 * i));
    here.remove("/jobs/" + job.json.at("id").get<std::string>());
    const ordered_json over = here.finished(job.json);
    if (over.at("state") == "cancelled") {
      ++cancelled;
      EXPECT_TRUE(here.get("/drives").json.empty());
      EXPECT_TRUE(files("drives").empty());
      continue;
    }
    ASSERT_EQ(over.at("state"), "done") << over.dump();
    const std::string drive = over.at("result").at("drive");
    EXPECT_EQ(here.get("/drives/" + drive + "/layers/covered").status, 200);
    EXPECT_EQ(here.get("/drives/" + drive + "/files/log").status, 200);
    EXPECT_EQ(here.remove("/drives/" + drive).status, 200);
  }
  EXPECT_GT(cancelled, 0);
}

TEST_F(DriveRaces, ADriveThatIsDeletedWhileItIsEvaluatedAgainStaysDeleted) {
  const Served here(folder_.path());
  int found_out = 0;
  for (int i = 0; i < 6; ++i) {
    const std::string drive = kept(here, 4000);
    const Got again = here.post("/jobs", {{"kind", "evaluate"}, {"drive", drive}});
    std::this_thread::sleep_for(std::chrono::milliseconds(15 * i));
    EXPECT_EQ(here.remove("/drives/" + drive).status, 200);
    const ordered_json over = here.finished(again.json);
    EXPECT_EQ(here.get("/drives/" + drive).status, 404);
    EXPECT_TRUE(files("drives").empty());
    if (over.at("state") == "done") continue;
    ++found_out;
    EXPECT_EQ(over.at("error").at("code"), "not_found") << over.dump();
  }
  EXPECT_GT(found_out, 0) << "the drives are too short for this test";
}

TEST_F(DriveRaces, TheStoreReplacesOnlyWhatIsThere) {
  const StoreFolder folder(folder_.path());
  std::vector<std::string> warnings;
  DriveStore store(folder, warnings);
  const std::string id = "20260314-081500-k3f9ab";
  std::ofstream(folder_ / "sent.csv") << "x";
  const DriveSource source{"drive.csv", ".csv", {}};
  const KeptDrive drive{id, "n", "", "", "", source, {}, ordered_json::object()};
  {
    const auto log = store.take_log(id, source, folder_ / "sent.csv");
    EXPECT_EQ(files("drives").size(), 1U);
    store.add(drive, {});
  }
  EXPECT_EQ(files("drives").size(), 3U) << "its .csv, .gpkg and .json";
  store.replace(drive, {});
  EXPECT_EQ(files("drives").size(), 3U);
  store.remove(id);
  EXPECT_TRUE(files("drives").empty());
  try {
    store.replace(drive, {});
    FAIL() << "it is back";
  } catch (const HttpError& error) {
    EXPECT_EQ(error.fault(), Fault::kNotFound);
  }
  EXPECT_TRUE(files("drives").empty());
  { const auto log = store.take_log(id, source, folder_ / "sent.csv"); }
  EXPECT_TRUE(files("drives").empty()) << "it came to nothing, so the log goes";
}

// Killed between the two files of a drive: they may be of two evaluations.
TEST_F(DriveRaces, AHalfReplacedDriveIsEvaluatedAnewAtTheNextStart) {
  std::string id, before;
  {
    const Served first(folder_.path());
    id = kept(first, 300);
    before = first.get("/drives/" + id + "/layers/covered").text;
    EXPECT_GT(before.size(), 100U);
  }
  std::ofstream(folder_ / "drives" / (id + ".gpkg"), std::ios::trunc) << "another evaluation's";
  std::ofstream(folder_ / "drives" / (id + ".replacing")) << "";
  std::ofstream(folder_ / "drives" / ("." + id + ".json.17-0.part")) << "{";
  const Served second(folder_.path());
  wait_for_jobs(second);
  EXPECT_EQ(second.get("/drives/" + id + "/layers/covered").text, before);
  EXPECT_EQ(files("drives").size(), 3U);
}

// Killed after the drive was kept and before the feed was forgotten.
TEST_F(DriveRaces, AFeedThatWasKeptIsNotKeptTwice) {
  std::string feed;
  {
    FakeTractor tractor;
    const Served first(folder_.path());
    std::thread dialling([&] { tractor.answer(); });
    feed = first.post("/feeds", {{"source", tractor.address()}}).json.value("id", "");
    dialling.join();
    tractor.send(joined(csv_lines(50)));
    for (int i = 0; i < 500 && first.get("/feeds/" + feed).json.value("fixes", 0) < 50; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  fs::copy(folder_ / "feeds", folder_ / "aside");
  { wait_for_jobs(Served(folder_.path())); }
  EXPECT_TRUE(files("feeds").empty());
  // As it was when the server was killed: a log is one file under two names.
  for (const std::string& name : files("aside"))
    fs::rename(folder_ / "aside" / name, folder_ / "feeds" / name);
  fs::remove(folder_ / "feeds" / (feed + ".log"));
  fs::create_hard_link(folder_ / "drives" / (feed + ".log"), folder_ / "feeds" / (feed + ".log"));
  const Served third(folder_.path());
  wait_for_jobs(third);
  for (const ordered_json& job : third.get("/jobs").json) EXPECT_EQ(job.at("state"), "done") << job.dump();
  EXPECT_EQ(third.get("/drives").json.size(), 1U);
  EXPECT_TRUE(files("feeds").empty());
}

TEST_F(DriveRaces, NoMoreFeedsThanThereIsRoomForAreOpenedAtOnce) {
  const Served here(folder_.path());
  std::ofstream(folder_ / "drive.csv") << joined(csv_lines(5));
  const std::string source = "file://" + (folder_ / "drive.csv").string();
  std::atomic<int> made = 0, refused = 0;
  std::vector<std::thread> clients;
  for (int i = 0; i < 3 * Limits().feeds; ++i)
    clients.emplace_back([&] {
      const int status = here.post("/feeds", {{"source", source}}).status;
      (status == 201 ? made : refused) += 1;
      EXPECT_TRUE(status == 201 || status == 503) << status;
    });
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(made, Limits().feeds);
  EXPECT_EQ(refused, 2 * Limits().feeds);
  const std::string feed = here.get("/feeds").json[0].at("id");
  EXPECT_EQ(here.remove("/feeds/" + feed).status, 200);
  EXPECT_EQ(here.post("/feeds", {{"source", source}}).status, 201) << "there is room again";
}

}  // namespace
}  // namespace tramline::server
