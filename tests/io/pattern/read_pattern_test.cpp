// Tables of transverse patterns, in the ways people write them, and what is none.

#include "tramline/io/pattern/read_pattern.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <string>

#include "support/refusals.h"
#include "support/temporary_folder.h"

namespace tramline::io {
namespace {

using testing_support::mentions;
using testing_support::refusal_of;

class Patterns : public ::testing::Test {
 protected:
  std::string file(const std::string& text) {
    const std::string path = (folder_.path() / "boom.csv").string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  std::string refusal(const std::string& text) {
    return refusal_of([&] { read_pattern(file(text)); });
  }

 private:
  testing_support::TemporaryFolder folder_;
};

TEST_F(Patterns, CommasSemicolonsTabsAndBlanks) {
  for (const char* text :
       {"offset_m,rate\n-6,0.5\n0,1\n6.5,0.25\n", "-6;0,5\n0;1\n6,5;0,25",
        "# measured\r\n-6\t0,5\r\n\r\n0\t1\r\n6,5\t0,25\r\n", "\xEF\xBB\xBF-6 0.5\n0   1\n  6.5  0.25\n"}) {
    const SprayPattern pattern = read_pattern(file(text));
    ASSERT_EQ(pattern.size(), 3U) << text;
    EXPECT_EQ(pattern[0].offset_m, -6);
    EXPECT_EQ(pattern[0].rate, 0.5);
    EXPECT_EQ(pattern[2].offset_m, 6.5);
    EXPECT_EQ(pattern[2].rate, 0.25);
  }
}

TEST_F(Patterns, WhatIsNoPatternIsRefusedWithItsLine) {
  EXPECT_TRUE(mentions(refusal(""), "no rows"));
  EXPECT_TRUE(mentions(refusal("offset,rate\n"), "no rows"));
  EXPECT_TRUE(mentions(refusal("-6,0.5\n0,nan\n"), "line 2"));
  EXPECT_TRUE(mentions(refusal("-6,0.5\n0,inf\n"), "line 2"));
  EXPECT_TRUE(mentions(refusal("-6,0.5\n0,1\n\n6,-1\n"), "line 4"));
  EXPECT_TRUE(mentions(refusal("-6,0.5,3\n"), "not two numbers"));
  EXPECT_TRUE(mentions(refusal("a,b\nc,d\n"), "line 2"));
  EXPECT_TRUE(mentions(refusal("{\"type\": \"FeatureCollection\"}"), "no rows"));
  EXPECT_TRUE(mentions(refusal_of([] { read_pattern("no-such-pattern.csv"); }), "no-such-pattern.csv"));
}

TEST_F(Patterns, DamagedTablesAreReadOrRefused) {
  const unsigned seed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  int read = 0, refused = 0;
  for (int i = 0; i < 400; ++i) {
    try {
      for (const PatternPoint& point :
           read_pattern(file(testing_support::damaged("-6,0.5\n0,1\n6.5,0.25\n", 2, random)))) {
        EXPECT_TRUE(point.rate >= 0);
        EXPECT_EQ(point.offset_m, point.offset_m);
      }
      ++read;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(read, 5);
  EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace tramline::io
