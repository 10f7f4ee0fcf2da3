#include <fmt/format.h>
#include <zlib.h>

#include <fstream>

#include "server/served.h"

namespace tramline::server {
namespace {

std::string gzipped(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

TEST_F(ServerTest, ListsTheFieldsOfAFile) {
  const Got sent = served.upload_example("two-farms.gpkg");
  EXPECT_EQ(sent.status, 201);
  EXPECT_EQ(sent.json["kind"], "fields");
  EXPECT_EQ(sent.json["features_total"], 4);
  EXPECT_EQ(sent.json["features"][0]["id"], "oak-field");
  EXPECT_EQ(sent.json["features"][0]["rings"]["type"], "MultiPolygon");
  EXPECT_GT(sent.json["features"][0]["area_m2"], 1000);
}

TEST_F(ServerTest, FeaturesWithoutAnIdAreCalledAfterTheUsersFile) {
  const std::string text = R"({"type":"Feature","properties":{},"geometry":)" + square().dump() + "}";
  const Got sent = served.upload("long%20meadow.geojson", text);
  ASSERT_EQ(sent.status, 201) << sent.text;
  EXPECT_EQ(sent.json["name"], "long meadow.geojson");
  EXPECT_EQ(sent.json["features"][0]["id"], "long meadow:0");
}

TEST_F(ServerTest, ListsAWholeRegisterByItsNumbersWithWhatGrowsThere) {
  constexpr int kMany = 600;  // more than are looked at one by one
  ordered_json features = ordered_json::array();
  for (int i = 0; i < kMany; ++i)
    features.push_back({{"type", "Feature"},
                        {"properties", {{"FLIK", fmt::format("DE{}", i)}, {"Kultur", "oats"}}},
                        {"geometry", square()}});
  const ordered_json triangle = {{{9, 50}, {9.002, 50}, {9, 50.002}, {9, 50}}};
  features[1]["geometry"] = {{"type", "Polygon"}, {"coordinates", triangle}};
  const Got sent = served.upload("register.geojson",
                                 ordered_json{{"type", "FeatureCollection"}, {"features", features}}.dump());
  ASSERT_EQ(sent.status, 201) << sent.text;
  ASSERT_EQ(sent.json["features"].size(), kMany);
  EXPECT_EQ(sent.json["features_total"], kMany);
  const ordered_json last = sent.json["features"].back();
  EXPECT_EQ(last["name"], "DE599");
  EXPECT_EQ(sent.json["features"][1]["rings"]["coordinates"][0], triangle) << "corners as they are, closed";
  for (const ordered_json& feature : sent.json["features"])
    for (const ordered_json& shape : feature["rings"]["coordinates"])
      EXPECT_EQ(shape[0].front(), shape[0].back()) << "GeoJSON has closed rings";
  EXPECT_EQ(last["crop"], "oats");
  EXPECT_EQ(last["attributes"]["FLIK"], "DE599");
  const Got one = served.upload(
      "one.geojson", ordered_json{{"type", "FeatureCollection"}, {"features", {features[0]}}}.dump());
  const double admitted_m2 = one.json["features"][0]["area_m2"];
  EXPECT_NEAR(last["area_m2"].get<double>(), admitted_m2, 0.005 * admitted_m2) << "about the area";
  EXPECT_EQ(one.json["features"][0]["name"], "DE0");
}

TEST_F(ServerTest, KnowsLogsAndPlans) {
  const Got log = served.upload_example("riverside-drive.csv");
  EXPECT_EQ(log.json["kind"], "log");
  EXPECT_EQ(log.json["logs"].size(), 1U);
  const std::string plan = served.planned(served.field_of("plain-metres.gpkg"));
  const Got file = served.get("/plans/" + plan + "/files/gpkg");
  EXPECT_EQ(served.upload("plan.gpkg", file.text).json["kind"], "plan");
}

TEST_F(ServerTest, SaysOfAnUnknownFileWhatWasTried) {
  const Got sent = served.upload("letter.txt", "Dear Sir or Madam\nall the best\n");
  EXPECT_EQ(sent.status, 201);
  EXPECT_EQ(sent.json["kind"], "unknown");
  const std::string message = sent.json["message"];
  EXPECT_NE(message.find("letter.txt"), std::string::npos) << message;
  EXPECT_EQ(message.find(folder.path().string()), std::string::npos)
      << "the server's own folder is nobody's business";
  EXPECT_EQ(message.find("--"), std::string::npos) << message;
}

TEST_F(ServerTest, RefusesAnEmptyFile) {
  const Got sent = served.upload("empty.geojson", "");
  EXPECT_EQ(sent.status, 400);
  EXPECT_NE(sent.message().find("empty.geojson"), std::string::npos) << sent.message();
}

TEST_F(ServerTest, ForgetsAnUpload) {
  const std::string id = served.upload_example("terrace.kml").json["id"];
  EXPECT_EQ(served.remove("/uploads/" + id).status, 200);
  EXPECT_EQ(served.remove("/uploads/" + id).status, 404);
  EXPECT_EQ(served.post("/fields", {{"upload", id}, {"fid", 1}}).status, 404);
}

TEST_F(ServerTest, NamesOfFilesLeadNowhere) {
  const std::string text = R"({"type":"Feature","properties":{},"geometry":)" + square().dump() + "}";
  for (const char* name : {"..%2F..%2Fescaped.geojson", "%2Fetc%2Fescaped.geojson", "..%5Cescaped.geojson",
                           "a%00escaped.geojson", ".."}) {
    const Got sent = served.upload(name, text);
    EXPECT_TRUE(sent.status == 201 || sent.status == 400) << sent.text;
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().string().find("escaped"), std::string::npos) << entry.path();
  EXPECT_FALSE(std::filesystem::exists(folder.path().parent_path() / "escaped.geojson"));
  EXPECT_FALSE(std::filesystem::exists("/etc/escaped.geojson"));
}

TEST_F(ServerTest, FilesThatLeadToOtherFilesAreNotFollowed) {
  const auto secret = folder / "secret.geojson";
  std::ofstream(secret) << R"({"type":"Feature","properties":{"id":"secret"},"geometry":)" << square().dump()
                        << "}";
  const std::string vrt = "<OGRVRTDataSource><OGRVRTLayer name=\"secret\"><SrcDataSource>" + secret.string() +
                          "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>";
  for (const char* name : {"lead.vrt", "lead.geojson", "lead.kml"}) {
    const Got sent = served.upload(name, vrt);
    EXPECT_EQ(sent.json.value("kind", "unknown"), "unknown") << sent.text;
  }
}

TEST_F(ServerTest, SaysWhereALogWasDrivenWhateverStraysFromIt) {
  // 200 fixes on a diagonal, and of each two in the middle a place that is none or lies elsewhere.
  std::string text = "time,lon,lat,width\n";
  for (int i = 0; i < 200; ++i) {
    const double lon = i == 100 ? -120 : 9 + i * 1e-5, lat = i == 50 ? 0 : 50 + i * 1e-5;
    text +=
        fmt::format("2026-05-06T08:{:02}:{:02}Z,{:.5f},{:.5f},6\n", i / 60, i % 60, i == 50 ? 0 : lon, lat);
  }
  const Got log = served.upload("log.csv", text);
  ASSERT_EQ(log.status, 201) << log.text;
  const ordered_json& box = log.json["logs"][0]["bbox"];
  ASSERT_EQ(box.size(), 4U) << log.text;
  const double expected[] = {9, 50, 9 + 199e-5, 50 + 199e-5};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(box[i], expected[i], 2.5e-5) << i;
  const ordered_json fields = served.upload_example("riverside.geojson").json;
  const std::string id = served.post("/fields", {{"upload", fields["id"]}, {"fid", 0}}).json["id"];
  const ordered_json listed = served.get("/fields").json;
  EXPECT_EQ(listed[0]["bbox"], served.get("/fields/" + id).json["bbox"]);
  // riverside lies about 9.15° east, 52.69° north.
  EXPECT_NEAR(listed[0]["bbox"][0], 9.15, 0.01);
  EXPECT_NEAR(listed[0]["bbox"][3], 52.695, 0.01);
}

TEST_F(ServerTest, ArchivesAreBounded) {
  // 1.2 GB of nothing, in members that are packed once: 1.2 MB.
  const std::string member = gzipped(std::string(std::size_t{100} << 20, '0'));
  std::string packed;
  for (int i = 0; i < 12; ++i) packed += member;
  const Got bomb = served.upload("log.csv.gz", packed);
  EXPECT_EQ(bomb.status, 400);
  EXPECT_NE(bomb.message().find("expands to more than"), std::string::npos) << bomb.text;
}

TEST(Limits, AnUploadThatIsTooLargeIsRefusedUnread) {
  const testing_support::TemporaryFolder folder;
  ServerSettings settings;
  settings.limits.upload_bytes = 1 << 20;
  const Served served(folder.path(), settings);
  // Nothing of the body is sent, so an answer shows that nobody waits for it.
  const std::string answer =
      served.raw("POST /api/v1/uploads?name=a.gpkg HTTP/1.1\r\nHost: " + served.own_host() +
                 "\r\nContent-Length: 1048577\r\n\r\n");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 413 ")) << answer;
  EXPECT_NE(answer.find("1 MB"), std::string::npos) << answer;
  const std::string asked =
      served.raw("POST /api/v1/uploads?name=a.gpkg HTTP/1.1\r\nHost: " + served.own_host() +
                 "\r\nContent-Length: 1048577\r\nExpect: 100-continue\r\n\r\n");
  EXPECT_TRUE(asked.starts_with("HTTP/1.1 413 ")) << asked;
  EXPECT_NE(asked.find("too_large"), std::string::npos) << asked;
}

TEST_F(ServerTest, ABodyInChunksIsBoundedToo) {
  std::string request = "POST /api/v1/machines HTTP/1.1\r\nHost: " + served.own_host() +
                        "\r\nTransfer-Encoding: chunked\r\n\r\n";
  const std::string chunk = "10000\r\n" + std::string(0x10000, ' ') + "\r\n";
  for (int i = 0; i < 66; ++i) request += chunk;
  const std::string answer = served.raw(request + "0\r\n\r\n");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 413 ")) << answer.substr(0, 200);
}

}  // namespace
}  // namespace tramline::server
