#include "tramline/render/page/picture_file.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace tramline::render {
namespace {

TEST(PictureFile, FormatFollowsTheExtension) {
  EXPECT_EQ(format_of("a.b/plan.png"), PictureFormat::kPng);
  EXPECT_EQ(format_of("plan.Svg"), PictureFormat::kSvg);
  EXPECT_EQ(format_of("plan.PDF"), PictureFormat::kPdf);
}

TEST(PictureFile, DateFollowsSourceDateEpoch) {
  ::setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  EXPECT_EQ(picture_date(), "2023-11-14T22:13:20Z");
  for (const char* nonsense : {"", "soon", "-5", "17x", "99999999999999999999"}) {
    ::setenv("SOURCE_DATE_EPOCH", nonsense, 1);
    EXPECT_EQ(picture_date(), "1970-01-01T00:00:00Z") << nonsense;
  }
  ::unsetenv("SOURCE_DATE_EPOCH");
  EXPECT_EQ(picture_date(), "1970-01-01T00:00:00Z");
}

}  // namespace
}  // namespace tramline::render
