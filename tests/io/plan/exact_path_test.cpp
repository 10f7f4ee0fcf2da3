#include "tramline/io/plan/exact_path.h"

#include <gtest/gtest.h>

#include "tramline/io/plan/path_text.h"

namespace tramline::io {
namespace {

const Path kPath{{{0.1, -2}, {1.0 / 3, 40}, 0}, {{1.0 / 3, 40}, {10, 45}, -1.0 / 9}};

TEST(ExactPath, OfAGeodeticFrameComesBackToTheLastBit) {
  LocalFrame frame;
  frame.geodetic = true;
  frame.origin_lon_deg = 13.2541234;
  frame.origin_lat_deg = -53.5562001;
  const std::string text = exact_path_text(frame, 0.02, path_text(kPath, {}));
  EXPECT_TRUE(text.starts_with("tmerc 13.2541234 -53.5562001 within 0.02: 0.1 -2; 0.3333333333333333 40 0; "))
      << text;
  const std::optional<ExactPath> back = exact_path_from_text(text);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->frame, frame);
  EXPECT_EQ(back->within_m, 0.02);
  EXPECT_EQ(back->path, kPath);
}

TEST(ExactPath, InPlainMetresLiesInThePlaneOfTheFile) {
  LocalFrame frame;
  frame.origin_x_m = 1000;
  const std::optional<ExactPath> back =
      exact_path_from_text(exact_path_text(frame, 0.5, path_text(kPath, {1000, 0})));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->frame, LocalFrame{});
  EXPECT_NEAR(back->path.front().from.x, 1000.1, 1e-12);
}

TEST(ExactPath, OtherTextsAreNone) {
  LocalFrame frame;
  frame.geodetic = true;
  const std::string whole = exact_path_text(frame, 0.02, path_text(kPath, {}));
  ASSERT_TRUE(exact_path_from_text(whole));
  for (const std::string& text :
       {std::string(), std::string("note: see page 3"), std::string("metres within -1: 0 0; 1 1 0"),
        std::string("metres within 0.02 0 0; 1 1 0"), std::string("tmerc 200 0 within 0.02: 0 0; 1 1 0"),
        std::string("tmerc 0 0 within nan: 0 0; 1 1 0"), std::string("metres within 0.02: 0 0"),
        std::string("metres within 0.02: 0 0; 1 1 5"), std::string("metres within 0.02: 0 0; 1 inf 0"),
        whole.substr(0, 20), whole.substr(0, whole.size() - 25), "x" + whole, whole + " "})
    EXPECT_FALSE(exact_path_from_text(text)) << text;
}

}  // namespace
}  // namespace tramline::io
