#include "report/plan_summary.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tramline/planner/warnings.h"

namespace tramline::app {
namespace {

/// 100 m by 60 m with a pond of 10 m by 10 m: 5,900 m² to work, 1,200 m² of it headland.
Plan plan() {
  Plan out;
  out.field.id = "mill";
  out.field.outer = {{0, 0}, {100, 0}, {100, 60}, {0, 60}};
  out.field.obstacles = {{{{{40, 30}, {50, 30}, {50, 40}, {40, 40}}, {}}, ObstacleKind::kObstacle, "hole 1"}};
  out.machine.width_m = 12;
  out.body = {{{{0, 12}, {100, 12}, {100, 60}, {0, 60}}, {{{40, 30}, {40, 40}, {50, 40}, {50, 30}}}}};
  out.headland.ground = {{{{0, 0}, {100, 0}, {100, 12}, {0, 12}}, {}}};
  out.headland.passes = {{{{{0, 6}, {100, 6}, 0}}, 1, true, {}}};
  out.subfields = {{out.body[0], Direction::clockwise_from_north(Angle::degrees(90))}};
  out.pieces = {{{0, 18}, {100, 18}, 0, 0}, {{100, 30}, {0, 30}, 0, 1}, {{0, 54}, {100, 54}, 0, 2}};
  out.tally.overlap_m2 = 59;
  out.tally.uncovered_m2 = 88.5;
  out.tally.turns = 2;
  out.tally.stops = 1;
  out.warnings = {kConnectionsUnplanned};
  return out;
}

TEST(PlanSummary, IsSixLinesByHand) {
  // 1 % is worked twice, 1.5 % missed; 3 tracks of 100 m and a pass of 100 m.
  EXPECT_EQ(plan_summary(plan(), {}),
            "to work      0.5900 ha, field mill without its 1 obstacle\n"
            "passes       4, each 12 m wide: 3 tracks at 90.00° and 1 headland pass; 2 turns, 1 stop\n"
            "distance     0.400 km at work\n"
            "worked twice 59.0 m² (1.00 %)\n"
            "missed       88.5 m² (1.50 %)\n"
            "note         nothing unusual\n");
}

TEST(PlanSummary, SaysWhatIsOddAndHowMuchMoreThereIs) {
  Plan odd = plan();
  odd.tally.uncovered_m2 = 590;
  odd.warnings = warnings_about(odd);
  odd.field.repairs.resize(2);
  const std::string text = plan_summary(odd, {{"layer", "x", "y"}});
  EXPECT_NE(text.find("note         10.0 % of the land, 590 m², stays unworked (and 2 more notes: "
                      "--explain)\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 6);
}

TEST(PlanSummary, TwoPercentOfTheLandAreTheBorder) {
  Plan border = plan();
  border.tally.uncovered_m2 = 0.02 * 5900;
  EXPECT_EQ(unworked_land_warning(border), "");
  border.tally.uncovered_m2 += 0.01;
  EXPECT_EQ(unworked_land_warning(border), "2.0 % of the land, 118 m², stays unworked");
}

TEST(PlanSummary, OfManyFieldsIsOneLineThatSaysMuchUnworkedLand) {
  EXPECT_EQ(plan_line(plan(), 0.25),
            "mill: 0.5900 ha, 4 passes, 0.400 km, worked twice 59.0 m² (1.00 %), missed 88.5 m² (1.50 %), 2 "
            "turns, 1 stop, 0.250 s\n");
  Plan odd = plan();
  odd.tally.uncovered_m2 = 590;
  EXPECT_NE(plan_line(odd, 0.25).find("; 10.0 % of the land, 590 m², stays unworked"), std::string::npos);
}

}  // namespace
}  // namespace tramline::app
