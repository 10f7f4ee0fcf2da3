#include <algorithm>
#include <set>

#include "server/openapi.h"
#include "server/routes/routes.h"
#include "server/served.h"

namespace tramline::server {
namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

TEST_F(ServerTest, SaysWhatItIs) {
  const Got about = served.get("/");
  EXPECT_EQ(about.status, 200);
  EXPECT_EQ(about.json["name"], "tramline");
  EXPECT_TRUE(about.json["tiles"].is_null());
  EXPECT_EQ(about.json["limits"]["upload_bytes"], 268435456);
}

TEST_F(ServerTest, AnswersArePackedOnceAndFast) {
  const Got plain = served.get("/openapi.json");
  ASSERT_GT(plain.text.size(), 10'000U);
  httplib::Client client("127.0.0.1", served.port());
  client.set_decompress(false);
  const auto packed = client.Get("/api/v1/openapi.json", {{"Accept-Encoding", "gzip, deflate, br"}});
  ASSERT_TRUE(packed);
  // Brotli at its full effort takes a minute for a register.
  EXPECT_EQ(packed->get_header_value("Content-Encoding"), "gzip");
  EXPECT_EQ(packed->get_header_value("Content-Type"), "application/json");
  EXPECT_EQ(packed->get_header_value_count("Content-Type"), 1U);
  EXPECT_LT(packed->body.size(), plain.text.size() / 4);
  client.set_decompress(true);
  const auto unpacked = client.Get("/api/v1/openapi.json", {{"Accept-Encoding", "gzip"}});
  ASSERT_TRUE(unpacked);
  EXPECT_EQ(unpacked->body, plain.text);
}

TEST_F(ServerTest, NothingIsAtOtherAddresses) {
  EXPECT_EQ(served.get("/nothing").status, 404);
  EXPECT_EQ(served.get("/nothing").code(), "not_found");
  const Got wrong = served.remove("/fields");
  EXPECT_EQ(wrong.status, 405);
  EXPECT_NE(wrong.message().find("GET, POST"), std::string::npos) << wrong.message();
}

TEST(Openapi, NamesEveryRouteAndNoOther) {
  const testing_support::TemporaryFolder folder;
  ServerSettings settings;
  settings.folder = folder.path();
  App app(settings);
  Router router;
  add_routes(router, app);
  std::set<std::string> registered, described;
  for (const Route& route : router.routes())
    if (route.pattern.starts_with(api("/"))) registered.insert(route.method + " " + route.pattern);
  const ordered_json document = ordered_json::parse(openapi());
  for (const auto& [path, operations] : document["paths"].items())
    for (const auto& [method, operation] : operations.items()) {
      described.insert(upper(method) + " " + api(path));
      EXPECT_TRUE(operation.contains("summary")) << path;
      EXPECT_TRUE(operation.contains("responses")) << path;
    }
  EXPECT_EQ(registered, described);
}

TEST(Openapi, RefersToWhatIsThere) {
  const ordered_json document = ordered_json::parse(openapi());
  const std::string text(openapi());
  const std::string mark = "\"#/components/schemas/";
  int references = 0;
  for (std::size_t at = text.find(mark); at != std::string::npos;
       at = text.find(mark, at + 1), ++references) {
    const std::size_t from = at + mark.size();
    const std::string name = text.substr(from, text.find('"', from) - from);
    EXPECT_TRUE(document["components"]["schemas"].contains(name)) << name;
  }
  EXPECT_GT(references, 10);
}

TEST_F(ServerTest, ServesItsDescription) {
  const Got document = served.get("/openapi.json");
  EXPECT_EQ(document.status, 200);
  EXPECT_EQ(document.json["info"]["title"], "tramline");
}

}  // namespace
}  // namespace tramline::server
