#include "tramline/io/export/column_names.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tramline/io/export/utf8_prefix.h"

namespace tramline::io {
namespace {

TEST(ColumnNames, LongOnesAreShortenedAndShortOnesStay) {
  EXPECT_EQ(shapefile_name("smallest_radius_m"), "min_radius");
  EXPECT_EQ(shapefile_name("stop_at_start"), "stop_start");
  EXPECT_EQ(shapefile_name("stop_at_end"), "stop_end");
  EXPECT_EQ(shapefile_name("around_field"), "round_fld");
  EXPECT_EQ(shapefile_name("length_m"), "length_m");
  EXPECT_EQ(shapefile_name("cost_right"), "cost_right");
  EXPECT_EQ(shapefile_name("something_nobody_thought_of"), "something_");
}

TEST(ColumnNames, LayersHaveTitles) {
  EXPECT_EQ(title_of("tracks", 12), "Track 12");
  EXPECT_EQ(title_of("headland_passes", 2), "Headland pass 2");
  EXPECT_EQ(title_of("uncovered", 3), "Uncovered 3");
  EXPECT_EQ(title_of("route_legs", 4), "Leg 4");
}

TEST(Utf8Prefix, SplitsNoCharacter) {
  EXPECT_EQ(utf8_prefix("Grünland", 2), "Gr");
  EXPECT_EQ(utf8_prefix("Grünland", 3), "Gr");
  EXPECT_EQ(utf8_prefix("Grünland", 4), "Grü");
  EXPECT_EQ(utf8_prefix("Grünland", 9), "Grünland");
  EXPECT_EQ(utf8_prefix("ü", 1), "");
}

}  // namespace
}  // namespace tramline::io
