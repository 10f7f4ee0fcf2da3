// The quickest way from beginnings that the machine backs to: words lead from far ones only near by.

#include "tramline/route/connection/way_search.h"

#include <gtest/gtest.h>

namespace tramline {
namespace {

/// Open land without lines, 2 km by 2 km, and a bar of 6 m that turns in circles of 6 m.
struct OpenLand {
  Field field = [] {
    Field out;
    out.id = "open land";
    out.outer = {{-1000, -1000}, {1000, -1000}, {1000, 1000}, {-1000, 1000}};
    return out;
  }();
  Region tracks{};
  AllowedLand land{Region{{field.outer, {}}}};
  DrivingGround ground{land, field, Machine{"", 6, 6, -1}, tracks};
  RoadmapWays ways{Roadmap{{}, 4}, ground};

  static Pose east(double x) { return {{x, 0}, Heading::clockwise_from_north(Angle::degrees(90))}; }

  /// From where the machine has backed so far, straight on to a place that lies ahead of it by so much.
  std::optional<FoundWay> quickest(double backed_m, double ahead_m) {
    WayEnd begin{east(0)};
    if (backed_m > 0) begin.path = {arc_from(east(backed_m), backed_m, 0, Gear::kReverse)};
    return quickest_way({begin}, {{east(ahead_m)}}, ways, ground);
  }
};

TEST(QuickestWay, IsAWordOfAnyLengthWhereTheMachineLeavesItsWork) {
  OpenLand on;
  const double ahead_m = on.ways.longest_word_m() + 20;
  const auto way = on.quickest(0, ahead_m);
  ASSERT_TRUE(way);
  EXPECT_NEAR(length(way->path), ahead_m, 1e-6);
}

TEST(QuickestWay, IsAWordOfAnyLengthFromAPlaceBackedToNearBy) {
  OpenLand on;
  const double longest_m = on.ways.longest_word_m();
  const auto way = on.quickest(longest_m - 5, longest_m + 20);
  ASSERT_TRUE(way);
  EXPECT_NEAR(length(way->path), 2 * longest_m + 15, 1e-6);
}

TEST(QuickestWay, IsAShortWordOnlyFromAPlaceBackedToFarAway) {
  OpenLand on;
  const double longest_m = on.ways.longest_word_m();
  EXPECT_FALSE(on.quickest(longest_m + 5, longest_m + 20));
  const auto way = on.quickest(longest_m + 5, longest_m - 20);
  ASSERT_TRUE(way);
  EXPECT_NEAR(length(way->path), 2 * longest_m - 15, 1e-6);
}

// Lines lead on where no word is long enough. What searches reach on them tells how long they take.
TEST(QuickestWay, CountsThePosesThatItReachesOnLines) {
  OpenLand on;
  const double longest_m = on.ways.longest_word_m();
  const SteeredPath line{arc_from(OpenLand::east(5), longest_m + 10, 0, Gear::kForward)};
  RoadmapWays along{Roadmap{{{line}}, 4}, on.ground};
  ASSERT_EQ(along.reached(), 0U);
  WayEnd begin{OpenLand::east(0)};
  begin.path = {arc_from(OpenLand::east(longest_m + 5), longest_m + 5, 0, Gear::kReverse)};
  ASSERT_TRUE(quickest_way({begin}, {{OpenLand::east(longest_m + 20)}}, along, on.ground));
  const std::size_t reached = along.reached();
  EXPECT_GT(reached, 0U);
  EXPECT_LE(reached, along.roadmap().poses().size());
  ASSERT_TRUE(quickest_way({begin}, {{OpenLand::east(longest_m + 20)}}, along, on.ground));
  EXPECT_EQ(along.reached(), 2 * reached);
}

}  // namespace
}  // namespace tramline
