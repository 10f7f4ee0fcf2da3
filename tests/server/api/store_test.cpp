#include <csignal>
#include <fstream>
#include <set>

#include "server/served.h"
#include "server/store/new_id.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

TEST(Store, ARestartFindsEverything) {
  const testing_support::TemporaryFolder folder;
  ordered_json field, machines, plan, layers;
  std::string field_id, plan_id;
  {
    const Served served(folder.path());
    field_id = served.field_of("riverside.geojson");
    plan_id = served.planned(field_id, {{"strategy", "sweep"}}, true);
    served.post("/machines", {{"name", "drill"}, {"width_m", 3}, {"radius_m", 6}, {"min_length_m", 7.5}});
    field = served.get("/fields/" + field_id).json;
    machines = served.get("/machines").json;
    plan = served.get("/plans/" + plan_id).json;
    layers = served.get("/plans/" + plan_id + "/layers").json;
  }
  const Served again(folder.path());
  EXPECT_EQ(again.get("/fields/" + field_id).json, field);
  EXPECT_EQ(again.get("/machines").json, machines);
  EXPECT_EQ(again.get("/plans/" + plan_id).json, plan);
  EXPECT_EQ(again.get("/plans/" + plan_id + "/layers").json, layers);
  EXPECT_EQ(again.get("/plans?field=" + field_id).json.size(), 1U);
  EXPECT_TRUE(again.server().warnings().empty());
}

TEST(Store, TwoServersDoNotShareAFolder) {
  const testing_support::TemporaryFolder folder;
  const Served served(folder.path());
  ServerSettings settings;
  settings.folder = folder.path();
  try {
    Server second(settings);
    FAIL() << "the second server has the folder too";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_NE(std::string(error.what()).find("another tramline server"), std::string::npos) << error.what();
  }
}

TEST(Store, APortThatIsTakenIsNotShared) {
  const testing_support::TemporaryFolder folder, other;
  const Served served(folder.path());
  ServerSettings settings;
  settings.folder = other.path();
  settings.port = served.port();
  try {
    Server second(settings);
    FAIL() << "two servers listen on one port";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("--port"), std::string::npos) << error.what();
  }
}

TEST(Store, DamagedFilesAreToldOfAndLeftAlone) {
  const testing_support::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "plans");
  std::filesystem::create_directories(folder / "fields");
  std::ofstream(folder / "plans/20200101-000000-aaaaaa.gpkg") << "no plan at all";
  std::ofstream(folder / "fields/20200101-000000-bbbbbb.gpkg") << "";
  std::ofstream(folder / "machines.gpkg") << "what is this";
  std::ofstream(folder / "fields/.20200101-000000-cccccc.gpkg.17-0.part") << "half";
  const Served served(folder.path());
  EXPECT_EQ(served.server().warnings().size(), 3U);
  EXPECT_EQ(served.get("/plans").json.size(), 0U);
  EXPECT_EQ(served.get("/fields").json.size(), 0U);
  EXPECT_TRUE(std::filesystem::exists(folder / "plans/20200101-000000-aaaaaa.gpkg"));
  EXPECT_TRUE(std::filesystem::exists(folder / "machines.gpkg.unreadable"));
  EXPECT_FALSE(std::filesystem::exists(folder / "fields/.20200101-000000-cccccc.gpkg.17-0.part"));
  EXPECT_EQ(served.post("/machines", {{"name", "drill"}, {"width_m", 3}, {"radius_m", 6}}).status, 201);
}

TEST(Store, NothingIsLeftOverWhenAServerEnds) {
  const testing_support::TemporaryFolder folder;
  {
    const Served served(folder.path());
    served.upload_example("riverside.geojson");
    served.get("/plans/" + served.planned(served.field_of("plain-metres.gpkg")) + "/files/png");
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    const std::string path = entry.path().string();
    EXPECT_EQ(path.find("upload"), std::string::npos) << path;
    if (path.find(".scratch/") != std::string::npos) ADD_FAILURE() << path;
  }
}

TEST_F(ServerTest, PathsLeadNowhere) {
  std::ofstream(folder.path().parent_path() / "tramline-outside.gpkg") << "x";
  for (const std::string& path :
       {std::string("/api/v1/fields/../../../etc/passwd"),
        std::string("/api/v1/fields/..%2F..%2Fetc%2Fpasswd"),
        std::string("/api/v1/plans/..%2F..%2Ftramline-outside/files/gpkg"),
        std::string("/api/v1/plans/../files/gpkg"), std::string("/api/v1/plans/%2e%2e/files/gpkg"),
        std::string("/api/v1/fields/a%00b"), std::string("/../etc/passwd"),
        std::string("/%2e%2e/%2e%2e/etc/passwd"), std::string("/api/v1/fields/" + std::string(5000, 'a')),
        std::string("//etc/passwd"), std::string("/api/v1//fields")}) {
    const std::string answer =
        served.raw("GET " + path + " HTTP/1.1\r\nHost: " + served.own_host() + "\r\n\r\n");
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 4")) << path << "\n" << answer.substr(0, 200);
    EXPECT_EQ(answer.find("root:"), std::string::npos) << path;
  }
  std::filesystem::remove(folder.path().parent_path() / "tramline-outside.gpkg");
}

TEST(NewId, IsAnIdAndNeverTheSame) {
  std::set<std::string> seen;
  constexpr std::size_t kToTheMicrosecond = 20;
  std::string last;
  for (int i = 0; i < 1000; ++i) {
    const std::string id = new_id();
    EXPECT_TRUE(is_id(id)) << id;
    EXPECT_LE(last, id.substr(0, kToTheMicrosecond)) << "lists are in the order of ids";
    last = id.substr(0, kToTheMicrosecond);
    seen.insert(id);
  }
  EXPECT_EQ(seen.size(), 1000U);
  EXPECT_EQ(new_token().size(), 32U);
  EXPECT_NE(new_token(), new_token());
  for (const char* text : {"", "A", "a_b", "a.b", "../a", "a/b", "\xC3\xA4"})
    EXPECT_FALSE(is_id(text)) << text;
  EXPECT_FALSE(is_id(std::string(65, 'a')));
}

}  // namespace
}  // namespace tramline::server
