#include "page/page_asset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "page/page_policy.h"

namespace tramline::app {
namespace {

TEST(PageAssets, AreSortedByPathAndEachIsFound) {
  const auto all = page_assets();
  EXPECT_TRUE(std::ranges::is_sorted(all, {}, &Asset::path));
  for (const Asset& asset : all) {
    const auto found = page_asset(asset.path);
    ASSERT_TRUE(found) << asset.path;
    EXPECT_EQ(found->content, asset.content);
    EXPECT_FALSE(asset.content.empty()) << asset.path;
    EXPECT_EQ(asset.etag.front(), '"');
    if (!asset.gzip.empty()) {
      EXPECT_LT(asset.gzip.size(), asset.content.size()) << asset.path;
      EXPECT_EQ(asset.gzip.substr(0, 2), "\x1f\x8b") << asset.path;
    }
  }
}

TEST(PageAssets, TheRootIsTheIndex) {
  const auto root = page_asset("/");
  ASSERT_TRUE(root);
  EXPECT_EQ(root->path, "/index.html");
  EXPECT_EQ(root->content_type, "text/html; charset=utf-8");
  EXPECT_FALSE(root->lasting) << "a browser has to ask for it again after an update";
}

TEST(PageAssets, ThereIsNothingBesides) {
  EXPECT_FALSE(page_asset(""));
  EXPECT_FALSE(page_asset("/index"));
  EXPECT_FALSE(page_asset("/../etc/passwd"));
  EXPECT_FALSE(page_asset("/zzz"));
}

TEST(PagePolicy, LetsInNothingFromElsewhere) {
  const std::string policy = page_policy("");
  EXPECT_NE(policy.find("default-src 'none'"), std::string::npos);
  EXPECT_NE(policy.find("script-src 'self';"), std::string::npos);
  EXPECT_EQ(policy.find("http"), std::string::npos);
  EXPECT_EQ(policy.find("unsafe"), std::string::npos);
}

TEST(PagePolicy, LetsInTheHostOfTilesAlone) {
  const std::string policy = page_policy("https://tile.example.org:8443/{z}/{x}/{y}.png?key=1");
  EXPECT_NE(policy.find("img-src 'self' data: blob: https://tile.example.org:8443;"), std::string::npos)
      << policy;
  EXPECT_EQ(policy.find("{z}"), std::string::npos);
  EXPECT_EQ(policy.find("script-src 'self' http"), std::string::npos);
}

TEST(PagePolicy, AnAddressThatIsNoneLetsInNothing) {
  for (const char* address : {"tile.example.org/{z}", "ftp://tile.example.org/", "https://", "https://a b/",
                              "https://a;script-src *", "javascript:alert(1)", "https://*.org/"})
    EXPECT_EQ(page_policy(address), page_policy("")) << address;
}

}  // namespace
}  // namespace tramline::app
