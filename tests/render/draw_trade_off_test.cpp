#include "tramline/render/trade_off/draw_trade_off.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "sample_plan.h"
#include "tramline/geometry/error.h"
#include "tramline/render/trade_off/front_chart.h"

namespace tramline::render {
namespace {

Front sample_front() {
  Front out;
  for (const auto& [overlap, uncovered, turns] :
       {std::tuple{0.0, 900.0, 30}, {100.0, 400.0, 20}, {250.0, 120.0, 22}, {900.0, 0.0, 40}}) {
    FrontPoint point;
    point.tally.overlap_m2 = overlap;
    point.tally.uncovered_m2 = uncovered;
    point.tally.turns = turns;
    out.points.push_back(point);
  }
  out.marks = {0, 3, 1, 1, 2};
  return out;
}

std::vector<Plan> plans_of(const Front& front) {
  return std::vector<Plan>(marked_points(front).size(), sample_plan());
}

bool shows(const Pixels& pixels, std::uint32_t colour) {
  for (int y = 0; y < pixels.height(); ++y)
    for (int x = 0; x < pixels.width(); ++x)
      if (pixels.at({static_cast<double>(x), static_cast<double>(y)}) == colour) return true;
  return false;
}

TEST(DrawTradeOff, ShowsPlansWithTheirFaultsAndIsTheSameTwice) {
  const Folder folder;
  const Front front = sample_front();
  draw_trade_off(front, plans_of(front), folder / "front.png");
  const Pixels pixels(folder / "front.png");
  EXPECT_EQ(pixels.width(), 1600);
  EXPECT_GT(pixels.height(), 800);
  EXPECT_TRUE(shows(pixels, kOverlapHex));
  EXPECT_TRUE(shows(pixels, kUncoveredHex));
  draw_trade_off(front, plans_of(front), folder / "again.png");
  EXPECT_EQ(bytes_of(folder / "front.png"), bytes_of(folder / "again.png"));
}

TEST(DrawTradeOff, MakesVectorPicturesToo) {
  const Folder folder;
  const Front front = sample_front();
  draw_trade_off(front, plans_of(front), folder / "front.svg");
  draw_trade_off(front, plans_of(front), folder / "front.pdf", {3200});
  EXPECT_NE(bytes_of(folder / "front.svg").find("<svg"), std::string::npos);
  EXPECT_TRUE(bytes_of(folder / "front.pdf").starts_with("%PDF"));
}

TEST(DrawTradeOff, OfOnePlanIsDrawn) {
  const Folder folder;
  Front front;
  front.points.resize(1);
  draw_trade_off(front, {sample_plan()}, folder / "one.png");
  EXPECT_GT(Pixels(folder / "one.png").height(), 800);
}

TEST(DrawTradeOff, RefusesWhatItCannotDraw) {
  const Folder folder;
  const Front front = sample_front();
  EXPECT_REFUSED(draw_trade_off({}, {}, folder / "none.png"));
  EXPECT_REFUSED(draw_trade_off(front, plans_of(front), folder / "front.bmp"));
  EXPECT_REFUSED(draw_trade_off(front, plans_of(front), folder / "front.png", {10}));
  EXPECT_EQ(folder.entries(), 0);
}

// At 25 m² of 100 m² an axis with square roots is half way.
TEST(FrontAxis, FollowsTheSquareRoot) {
  const FrontAxis axis{100, 10, 210};
  EXPECT_DOUBLE_EQ(axis.to_page(0), 10);
  EXPECT_DOUBLE_EQ(axis.to_page(25), 110);
  EXPECT_DOUBLE_EQ(axis.to_page(100), 210);
  // 100 at 210, 50 at 151.4; 20 at 99.4; 10 at 73.2 is too near to it, and 5 at 54.7 to the origin.
  EXPECT_EQ(ticks_of(axis, 50), (std::vector<double>{0, 20, 50, 100}));
}

TEST(FrontAxis, TicksStandApartOnAxesThatRiseAndFall) {
  for (const FrontAxis& axis : {FrontAxis{6019, 0, 900}, FrontAxis{6019, 500, 20}, FrontAxis{1, 0, 900}}) {
    const std::vector<double> ticks = ticks_of(axis, 40);
    ASSERT_GE(ticks.size(), 3u);
    EXPECT_EQ(ticks.front(), 0);
    for (std::size_t i = 1; i < ticks.size(); ++i) {
      EXPECT_GT(ticks[i], ticks[i - 1]);
      EXPECT_GE(std::abs(axis.to_page(ticks[i]) - axis.to_page(ticks[i - 1])), 40);
      EXPECT_LE(ticks[i], axis.most);
    }
  }
}

TEST(FrontBadges, KeepOffOneAnotherAndTheirPoints) {
  const Box room{0, 0, 400, 300};
  const std::vector<Point> points{{100, 100}, {100, 100}, {104, 98}, {398, 2}, {2, 298}};
  const std::vector<Point> badges = place_badges_at(points, {}, 13, room);
  ASSERT_EQ(badges.size(), points.size());
  for (std::size_t i = 0; i < badges.size(); ++i) {
    EXPECT_TRUE(badges[i].x >= 13 && badges[i].x <= 387 && badges[i].y >= 13 && badges[i].y <= 287);
    for (const Point point : points) EXPECT_GE(distance(badges[i], point), 1.8 * 13);
    for (std::size_t j = 0; j < i; ++j) EXPECT_GE(distance(badges[i], badges[j]), 2 * 13);
  }
}

// The place first thought of is to the upper right, where another point lies.
TEST(FrontBadges, HideNoPointWithoutNeed) {
  const Box room{0, 0, 400, 300};
  const Point point{100, 100}, free_side = place_badges_at({point}, {}, 13, room).front();
  EXPECT_GT(free_side.x, point.x);
  EXPECT_LT(free_side.y, point.y);
  EXPECT_GT(distance(place_badges_at({point}, {free_side}, 13, room).front(), free_side), 1.3 * 13);
}

}  // namespace
}  // namespace tramline::render
