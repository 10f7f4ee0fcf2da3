#include "server/http/gate.h"
#include "support/refusals.h"

#include "server/served.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

std::string get_with(const Served& served, const std::string& headers,
                     const std::string& path = "/api/v1/fields") {
  return served.raw("GET " + path + " HTTP/1.1\r\n" + headers + "\r\n\r\n");
}

TEST_F(ServerTest, IsKnownByItsOwnNamesOnly) {
  const std::string port = std::to_string(served.port());
  for (const std::string& host :
       {"127.0.0.1:" + port, "localhost:" + port, "LOCALHOST:" + port, "[::1]:" + port})
    EXPECT_TRUE(get_with(served, "Host: " + host).starts_with("HTTP/1.1 200 ")) << host;
  for (const std::string& host :
       {std::string("evil.example"), "evil.example:" + port, std::string("127.0.0.1"),
        std::string("localhost:1"), "127.0.0.1.evil.example:" + port, std::string()})
    EXPECT_TRUE(get_with(served, "Host: " + host).starts_with("HTTP/1.1 403 ")) << host;
  EXPECT_TRUE(get_with(served, "Accept: */*").starts_with("HTTP/1.1 403 ")) << "without a Host";
  EXPECT_TRUE(get_with(served, "Host: evil.example", "/").starts_with("HTTP/1.1 403 ")) << "the page too";
}

TEST_F(ServerTest, OtherPagesMayNotUseIt) {
  const std::string host = "Host: " + served.own_host();
  EXPECT_TRUE(
      get_with(served, host + "\r\nOrigin: http://" + served.own_host()).starts_with("HTTP/1.1 200 "));
  for (const std::string& origin :
       {std::string("http://evil.example"), std::string("null"), "https://" + served.own_host(),
        "http://localhost:" + std::to_string(served.port()), std::string("http://127.0.0.1:1")})
    EXPECT_TRUE(get_with(served, host + "\r\nOrigin: " + origin).starts_with("HTTP/1.1 403 ")) << origin;
  const std::string body = R"({"name":"a","width_m":3,"radius_m":6})";
  const std::string posted =
      served.raw("POST /api/v1/machines HTTP/1.1\r\n" + host +
                 "\r\nOrigin: http://evil.example\r\nContent-Length: " + std::to_string(body.size()) +
                 "\r\n\r\n" + body);
  EXPECT_TRUE(posted.starts_with("HTTP/1.1 403 ")) << posted;
  EXPECT_EQ(served.get("/machines").json.size(), 0U);
}

TEST(Token, IsAskedForByEverythingButThePage) {
  const testing_support::TemporaryFolder folder;
  ServerSettings settings;
  settings.token = "a-secret-of-ours";
  Served served(folder.path(), settings);
  EXPECT_EQ(served.get("/").status, 403);
  EXPECT_EQ(served.get("/fields").code(), "forbidden");
  EXPECT_EQ(served.upload("a.csv", "lon,lat\n").status, 403);
  EXPECT_TRUE(get_with(served, "Host: " + served.own_host(), "/").starts_with("HTTP/1.1 200 "));

  served.headers = {{"Authorization", "Bearer a-secret-of-theirs"}};
  EXPECT_EQ(served.get("/").status, 403);
  served.headers = {{"Authorization", "Bearer a-secret-of-ours"}};
  EXPECT_EQ(served.get("/").status, 200);

  served.headers = {};
  EXPECT_EQ(served.post("/session", {{"token", "a-secret-of-theirs"}}).status, 403);
  const Got session = served.post("/session", {{"token", "a-secret-of-ours"}});
  EXPECT_EQ(session.status, 200);
  const std::string cookie = session.headers.find("Set-Cookie")->second;
  EXPECT_NE(cookie.find("HttpOnly"), std::string::npos);
  EXPECT_NE(cookie.find("SameSite=Strict"), std::string::npos);
  served.headers = {{"Cookie", "other=1; " + cookie.substr(0, cookie.find(';'))}};
  EXPECT_EQ(served.get("/").status, 200);
  EXPECT_EQ(served.server().addresses(),
            std::vector<std::string>{"http://" + served.own_host() + "/#token=a-secret-of-ours"});
}

TEST(Token, OtherHostsAreNotServedWithoutOne) {
  const testing_support::TemporaryFolder folder;
  ServerSettings settings;
  settings.folder = folder.path();
  settings.host = "0.0.0.0";
  EXPECT_REFUSED(Server server(settings));
}

// Every address that is printed opens the page: tried with the address as the Host, over the address itself.
TEST(Token, AServerOnAllAddressesNamesThoseThatCanBeOpened) {
  const testing_support::TemporaryFolder folder;
  for (const char* host : {"0.0.0.0", "::"}) {
    SCOPED_TRACE(host);
    ServerSettings settings;
    settings.host = host;
    settings.token = "a-secret-of-ours";
    const Served served(folder.path(), settings);
    const std::vector<std::string> addresses = served.server().addresses();
    ASSERT_FALSE(addresses.empty());
    EXPECT_EQ(addresses.back(), "http://" + served.own_host() + "/#token=a-secret-of-ours");
    for (const std::string& address : addresses) {
      EXPECT_TRUE(address.ends_with("/#token=a-secret-of-ours")) << address;
      EXPECT_EQ(address.find("0.0.0.0"), std::string::npos) << address;
      EXPECT_EQ(address.find("[::]"), std::string::npos) << address;
      const std::size_t from = std::string("http://").size(), port = address.rfind(':');
      std::string name = address.substr(from, port - from);
      if (name.starts_with('[')) name = name.substr(1, name.size() - 2);
      httplib::Client client(name, served.port());
      const auto page = client.Get("/");
      ASSERT_TRUE(page) << address;
      EXPECT_EQ(page->status, 200) << address;
      const auto fields =
          client.Get("/api/v1/fields", httplib::Headers{{"Authorization", "Bearer a-secret-of-ours"}});
      ASSERT_TRUE(fields) << address;
      EXPECT_EQ(fields->status, 200) << address;
    }
  }
}

TEST(Gate, TellsLoopbackFromTheRest) {
  for (const char* host : {"127.0.0.1", "127.1.2.3", "localhost", "::1"})
    EXPECT_TRUE(is_loopback(host)) << host;
  for (const char* host : {"0.0.0.0", "::", "192.168.1.5", "127.evil.example", "farm.local", ""})
    EXPECT_FALSE(is_loopback(host)) << host;
}

TEST(Gate, ComparesSecretsWhole) {
  EXPECT_TRUE(same_secret("abc", "abc"));
  for (const char* wrong : {"abd", "ab", "abca", "abcabc", ""})
    EXPECT_FALSE(same_secret(wrong, "abc")) << wrong;
  EXPECT_FALSE(same_secret("a", ""));
}

}  // namespace
}  // namespace tramline::server
