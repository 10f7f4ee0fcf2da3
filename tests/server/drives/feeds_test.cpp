// Live feeds over HTTP: begun, followed by several, switched, ended, and found again after the server was
// killed.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "server/served.h"
#include "server/work/drives.h"
#include "server/work/fake_tractor.h"
#include "support/refusals.h"

namespace tramline::server {
namespace {

using namespace testing_drives;
using std::chrono::milliseconds;
using testing_support::mentions;

class Feeds : public ::testing::Test {
 protected:
  /// A feed of the tractor; its id.
  std::string begin(Served& server, const ordered_json& more = ordered_json::object()) {
    ordered_json request = {{"source", tractor_.address()}};
    request.update(more);
    std::thread dialling([this] { tractor_.answer(); });
    const Got made = server.post("/feeds", request);
    dialling.join();
    EXPECT_EQ(made.status, 201) << made.text;
    return made.json.value("id", "");
  }
  static void wait_for(const Served& server, const std::string& feed, int fixes) {
    for (int i = 0; i < 1000 && server.get("/feeds/" + feed).json.value("fixes", 0) < fixes; ++i)
      std::this_thread::sleep_for(milliseconds(10));
    EXPECT_GE(server.get("/feeds/" + feed).json.value("fixes", 0), fixes);
  }
  void send(const std::vector<std::string>& lines, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) tractor_.send(lines[i] + "\n");
  }

  testing_support::TemporaryFolder folder_;
  FakeTractor tractor_;
};

TEST_F(Feeds, AreFollowedByTwoAndKeptAsADrive) {
  Served here(folder_.path());
  const std::string feed = begin(here, {{"name", "Tuesday"}});
  const std::vector<std::string> lines = csv_lines(600);
  struct Seen {
    int frames = 0, states = 0;
    std::size_t places = 0;
    ordered_json end{};
  };
  std::vector<Seen> seen(2);
  std::vector<std::thread> readers;
  for (Seen& one : seen)
    readers.emplace_back([&one, &here, &feed] {
      here.follow("/feeds/" + feed + "/events", [&one](const std::string& name, const ordered_json& data) {
        one.frames += name == "frame" ? 1 : 0;
        one.states += name == "state" ? 1 : 0;
        if (name == "frame") one.places += data.at("line").size();
        if (name == "end") one.end = data.at("figures");
        return true;
      });
    });
  send(lines, 0, 301);
  wait_for(here, feed, 300);
  EXPECT_EQ(here.post("/feeds/" + feed + "/work", {{"on", false}}).status, 200);
  send(lines, 301, 401);
  wait_for(here, feed, 400);
  EXPECT_EQ(here.get("/feeds/" + feed).json.at("summary").at("working"), false);
  EXPECT_EQ(here.post("/feeds/" + feed + "/work", {{"on", true}}).status, 200);
  send(lines, 401, 601);
  wait_for(here, feed, 600);
  ASSERT_EQ(here.get("/feeds").json.size(), 1U);
  EXPECT_EQ(here.get("/feeds").json[0].at("name"), "Tuesday");

  const Got ended = here.remove("/feeds/" + feed);
  ASSERT_EQ(ended.status, 200) << ended.text;
  for (std::thread& reader : readers) reader.join();
  const ordered_json drive = here.get("/drives/" + ended.json.at("drive").get<std::string>()).json;
  EXPECT_EQ(drive.at("name"), "Tuesday");
  EXPECT_EQ(drive.at("fixes"), 600);
  for (const Seen& one : seen) {
    EXPECT_GT(one.frames, 0);
    EXPECT_GE(one.states, 1);
    EXPECT_GT(one.places, 100U);
    ASSERT_TRUE(one.end.is_object());
    EXPECT_NEAR(one.end.at("covered_m2"), drive.at("summary").at("covered_m2"), 1e-3);
    EXPECT_NEAR(one.end.at("gross_m2"), drive.at("summary").at("gross_m2"), 1e-3);
  }
  EXPECT_TRUE(here.get("/feeds").json.empty());
  EXPECT_EQ(here.get("/feeds/" + feed).status, 404);
  EXPECT_TRUE(mentions(here.get("/drives/" + feed + "/files/log").text, "#!work=0"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path() / "feeds"), {}), 0);
}

// Frames of a feed by meshes have the land and the number of meshes, and the drive at its end has the same.
TEST_F(Feeds, AreMeasuredByMeshes) {
  Served here(folder_.path());
  const std::string feed = begin(here, {{"options", {{"engine", "mesh"}, {"mesh_m", 0.1}}}});
  const std::vector<std::string> lines = csv_lines(300);
  ordered_json end;
  std::map<std::string, bool> tiles;  // by id: whether there is land in it
  std::thread reader([&] {
    here.follow("/feeds/" + feed + "/events", [&](const std::string& name, const ordered_json& data) {
      if (name == "end") end = data.at("figures");
      if (name != "frame") return true;
      if (data.at("all")) tiles.clear();
      for (const ordered_json& tile : data.at("tiles"))
        tiles[tile.at("id").get<std::string>()] = !tile.at("covered").empty();
      return true;
    });
  });
  send(lines, 0, 301);
  wait_for(here, feed, 300);
  const ordered_json shown = here.get("/feeds/" + feed).json;
  EXPECT_EQ(shown.at("options").at("engine"), "mesh");
  EXPECT_EQ(shown.at("options").at("mesh_m"), 0.1);
  EXPECT_EQ(shown.at("summary").at("engine"), "mesh");
  EXPECT_GT(shown.at("summary").at("meshes").at("covered").at("now").get<int>(), 1000);
  const Got ended = here.remove("/feeds/" + feed);
  ASSERT_EQ(ended.status, 200) << ended.text;
  reader.join();
  const ordered_json drive = here.get("/drives/" + ended.json.at("drive").get<std::string>()).json;
  EXPECT_EQ(drive.at("options").at("engine"), "mesh");
  ASSERT_TRUE(end.is_object());
  EXPECT_EQ(end.at("meshes").at("side_m"), 0.1);
  EXPECT_TRUE(end.at("meshes").at("missed").is_null()) << "there is no field";
  // The feed's plane is centred on its first place, the drive's on the middle of all.
  EXPECT_NEAR(end.at("covered_m2"), drive.at("summary").at("covered_m2"), 1);
  EXPECT_GT(std::count_if(tiles.begin(), tiles.end(), [](const auto& tile) { return tile.second; }), 50);
}

TEST_F(Feeds, WhatIsWrongIsSaidInASentence) {
  Served here(folder_.path());
  for (const char* source : {"", "tractor", "udp://:0", "tcp://127.0.0.1:1", "file:///nowhere.csv"}) {
    const Got got = here.post("/feeds", {{"source", source}});
    EXPECT_EQ(got.status, 400) << source;
    EXPECT_FALSE(mentions(got.message(), "--")) << got.message();
    EXPECT_GT(got.message().size(), 20U);
  }
  for (const char* body : {"", "{", "{}", "{\"source\": 5}", "{\"source\": \"udp://:4001\", \"colour\": 1}"})
    EXPECT_EQ(here.post_text("/feeds", body).status, 400) << body;
  EXPECT_EQ(here.post("/feeds", {{"source", "udp://:4001"}, {"field", "none"}}).status, 404);
  EXPECT_EQ(here.post("/feeds", {{"source", "udp://:4001"}, {"width_m", 0}}).status, 400);
  EXPECT_EQ(here.get("/feeds/none").status, 404);
  EXPECT_EQ(here.get("/feeds/none/events").status, 404);
  EXPECT_EQ(here.remove("/feeds/none").status, 404);
  EXPECT_EQ(here.post("/feeds/none/work", {{"on", true}}).status, 404);
  const std::string feed = begin(here);
  EXPECT_EQ(here.post("/feeds/" + feed + "/work", {{"on", true}}).status, 400) << "no fix has come yet";
  EXPECT_EQ(here.post("/feeds/" + feed + "/work", ordered_json::object()).status, 400);
  EXPECT_EQ(here.post("/feeds/" + feed + "/work", {{"on", "yes"}}).status, 400);
  const Got ended = here.remove("/feeds/" + feed);
  EXPECT_EQ(ended.status, 200);
  EXPECT_TRUE(ended.json.at("drive").is_null());
  EXPECT_TRUE(here.get("/drives").json.empty());
}

TEST_F(Feeds, ReadFilesOnlyBelowTheStoreAndTheFoldersNamed) {
  const testing_support::TemporaryFolder named, other;
  for (const std::filesystem::path& folder : {folder_.path(), named.path(), other.path()})
    std::ofstream(folder / "drive.csv") << joined(csv_lines(5));
  ServerSettings settings;
  settings.feed_folders = {named.path()};
  Served here(folder_.path(), settings);
  const auto begun = [&](const std::filesystem::path& file) {
    return here.post("/feeds", {{"source", "file://" + file.string()}});
  };
  EXPECT_EQ(begun(folder_ / "drive.csv").status, 201);
  EXPECT_EQ(begun(named / "drive.csv").status, 201);
  for (const std::filesystem::path& file : {other / "drive.csv", std::filesystem::path("/etc/passwd")}) {
    const Got refused = begun(file);
    EXPECT_EQ(refused.status, 400) << refused.text;
    EXPECT_TRUE(mentions(refused.message(), "is not in a folder that live feeds may read")) << refused.text;
  }
}

TEST_F(Feeds, ThereIsALimit) {
  Served here(folder_.path());
  const std::string followed = (folder_ / "drive.csv").string();
  std::ofstream(followed) << joined(csv_lines(5));
  int made = 0;
  Got last;
  for (; made < 100; ++made)
    if ((last = here.post("/feeds", {{"source", "file://" + followed}})).status != 201) break;
  EXPECT_EQ(made, Limits().feeds);
  EXPECT_EQ(last.status, 503);
  EXPECT_EQ(last.code(), "busy");
}

// A server that ends, however it ends, leaves the raw log; the next one makes a drive of it.
TEST_F(Feeds, AreFoundAgainByTheNextServer) {
  std::string feed;
  const std::vector<std::string> lines = csv_lines(200);
  {
    Served first(folder_.path());
    feed = begin(first, {{"name", "before the fall"}});
    send(lines, 0, 201);
    wait_for(first, feed, 200);
  }
  EXPECT_EQ(testing_support::bytes_of(folder_.path() / "feeds" / (feed + ".log")), joined(lines));
  Served second(folder_.path());
  ordered_json drives;
  for (int i = 0; i < 1000 && (drives = second.get("/drives").json).empty(); ++i)
    std::this_thread::sleep_for(milliseconds(10));
  ASSERT_EQ(drives.size(), 1U);
  EXPECT_EQ(drives[0].at("id"), feed);
  EXPECT_EQ(drives[0].at("name"), "before the fall");
  EXPECT_EQ(drives[0].at("fixes"), 200);
  EXPECT_TRUE(second.get("/feeds").json.empty());
  for (int i = 0; i < 500 && std::filesystem::exists(folder_.path() / "feeds" / (feed + ".json")); ++i)
    std::this_thread::sleep_for(milliseconds(10));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "feeds" / (feed + ".json")));
}

TEST_F(Feeds, AStreamThatIsNoLogEndsWithASentenceAndKeepsWhatCame) {
  Served here(folder_.path());
  const std::string feed = begin(here);
  tractor_.send("lon,lat\n10.5,52.3\n10.5001,52.3\n");
  std::string message;
  here.follow("/feeds/" + feed + "/events", [&](const std::string& name, const ordered_json& data) {
    if (name == "state") message = data.at("message");
    return true;
  });
  EXPECT_TRUE(mentions(message, "how wide")) << message;
  EXPECT_TRUE(here.get("/feeds/" + feed).json.at("ended"));
  const Got ended = here.remove("/feeds/" + feed);
  EXPECT_EQ(ended.status, 200);
  EXPECT_TRUE(ended.json.at("drive").is_null());
  EXPECT_TRUE(mentions(ended.json.at("message"), "kept in")) << ended.text;
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "feeds" / (feed + ".log")));
}

}  // namespace
}  // namespace tramline::server
