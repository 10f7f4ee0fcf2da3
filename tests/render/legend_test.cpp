#include <gtest/gtest.h>

#include <map>

#include "render/shows.h"
#include "sample_plan.h"
#include "tramline/render/page/legend_content.h"
#include "tramline/render/page/map_decorations.h"
#include "tramline/render/page/text.h"
#include "tramline/render/page/visible_faults.h"

namespace tramline::render {
namespace {

std::map<std::string, std::string> values(const Plan& plan) {
  std::map<std::string, std::string> out;
  for (const LegendBlock& block : legend_of(plan))
    for (const LegendRow& row : block.rows)
      if (row.symbol == Symbol::kNone) out[row.text] = row.value;
  return out;
}

TEST(Legend, NumbersHaveTheirUnits) {
  const auto value = values(sample_plan());
  EXPECT_EQ(value.at("field"), "0.59 ha");  // without the obstacle
  EXPECT_EQ(value.at("body"), "0.59 ha");
  EXPECT_EQ(value.at("working width"), "10 m");
  EXPECT_EQ(value.at("tracks"), "10");
  EXPECT_EQ(value.at("turns"), "9");
  EXPECT_EQ(value.at("stops"), "2");
  EXPECT_EQ(value.at("track length"), "530 m");
  EXPECT_EQ(value.at("overlap"), "240 m² · 4.07 %");
  EXPECT_EQ(value.at("uncovered"), "360 m² · 6.10 %");
  EXPECT_EQ(value.at("cost"), "59.65");
}

TEST(Legend, ShowsOnlyTheSymbolsThatOccur) {
  Plan plan = sample_plan();
  EXPECT_TRUE(shows(plan, Symbol::kObstacle));
  EXPECT_TRUE(shows(plan, Symbol::kStop));
  EXPECT_FALSE(shows(plan, Symbol::kPassable));
  EXPECT_FALSE(shows(plan, Symbol::kDropped));
  plan.field.obstacles[0].kind = ObstacleKind::kPassable;
  plan.uncovered.clear();
  EXPECT_FALSE(shows(plan, Symbol::kObstacle));
  EXPECT_TRUE(shows(plan, Symbol::kPassable));
  EXPECT_FALSE(shows(plan, Symbol::kUncovered));
}

// Only ways with the work off are drawn.
TEST(Legend, ShowsWaysWithoutRoomWhereTheyAreDrawn) {
  Plan plan = sample_plan();
  plan.route.legs.resize(2);
  plan.route.legs[0].kind = LegKind::kHeadland;
  plan.route.legs[0].work = true;
  plan.route.legs[0].missing_m = 0.4;
  plan.route.legs[1].kind = LegKind::kTransit;
  EXPECT_FALSE(shows(plan, Symbol::kNoRoom));
  plan.route.legs[1].missing_m = 0.4;
  EXPECT_TRUE(shows(plan, Symbol::kNoRoom));
}

TEST(Legend, ManySubfieldsAreCounted) {
  Plan plan = sample_plan();
  plan.subfields.assign(40, plan.subfields[0]);
  const LegendBlock block = legend_of(plan).back();
  EXPECT_EQ(block.rows.size(), 12u);
  EXPECT_EQ(block.rows.back().text, "and 29 more");
}

TEST(Legend, UnitsSuitTheSize) {
  EXPECT_EQ(area_text(0), "0 m²");
  EXPECT_EQ(area_text(0.44), "0.4 m²");
  EXPECT_EQ(area_text(840), "840 m²");
  EXPECT_EQ(area_text(123456), "12.35 ha");
  EXPECT_EQ(length_text(840), "840 m");
  EXPECT_EQ(length_text(17010), "17.01 km");
}

TEST(ScaleBar, HasARoundLength) {
  EXPECT_EQ(round_length(1), 1);
  EXPECT_EQ(round_length(4.99), 2);
  EXPECT_EQ(round_length(70), 50);
  EXPECT_EQ(round_length(350), 200);
  EXPECT_DOUBLE_EQ(round_length(0.3), 0.2);
}

TEST(VisibleFaults, LeavesOutWhatIsThinnerThanAMillimetre) {
  EXPECT_TRUE(visible_faults({{box(0, 0, 100, 5e-6), {}}}).empty());
  EXPECT_EQ(visible_faults({{box(0, 0, 100, 0.01), {}}}).size(), 1u);
  // A real fault of 2 m × 1 m with a tail of 90 m that rounding left.
  const Ring with_tail{{0, 0}, {2, 0}, {2, 0.5}, {92, 0.5}, {92, 0.500002}, {2, 0.500002}, {2, 1}, {0, 1}};
  const Region shown = visible_faults({{with_tail, {}}});
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_NEAR(bounds(shown).max_x, 2, 1e-6);
  EXPECT_NEAR(area(shown), 2, 1e-4);
  EXPECT_TRUE(visible_faults({}).empty());
}

TEST(Text, IsMadePrintable) {
  EXPECT_EQ(printable("Grüne Au 3"), "Grüne Au 3");
  EXPECT_EQ(printable("a\xff\n"), "a??");
  EXPECT_EQ(printable("\xC0\x80"), "??") << "an overlong zero";
  EXPECT_EQ(printable("\xE2\x82"), "??") << "cut short";
  EXPECT_EQ(printable("\xED\xA0\x80"), "???") << "half of a surrogate pair";
}

}  // namespace
}  // namespace tramline::render
