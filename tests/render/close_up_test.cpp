#include "tramline/render/close_up/close_up.h"

#include <gtest/gtest.h>

#include "detour_plan.h"
#include "tramline/geometry/error.h"
#include "tramline/model/palette.h"
#include "tramline/render/close_up/close_up_content.h"
#include "tramline/render/close_up/close_up_layers.h"
#include "tramline/render/close_up/close_up_window.h"
#include "tramline/render/close_up/encounter_table.h"

namespace tramline::render {
namespace {

bool contains(const Box& outer, const Box& inner) {
  return inner.min_x >= outer.min_x && inner.max_x <= outer.max_x && inner.min_y >= outer.min_y &&
         inner.max_y <= outer.max_y;
}

bool has(const std::vector<LegendBlock>& blocks, Symbol symbol) {
  for (const LegendBlock& block : blocks)
    for (const LegendRow& row : block.rows)
      if (row.symbol == symbol) return true;
  return false;
}

ErrorKind kind_thrown(std::size_t obstacle, const std::filesystem::path& path,
                      const PictureOptions& options = {}) {
  try {
    draw_close_up(detour_plan(), obstacle, path, options);
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return ErrorKind::kFailure;
}

TEST(CloseUp, HasTheSizeOfItsLayoutInEveryFormat) {
  const Folder folder;
  const Plan plan = detour_plan();
  for (const int width : {600, 1000, 1600, 4000}) {
    const CloseUpLayout layout = close_up_layout(plan, 0, {width});
    draw_close_up(plan, 0, folder / "one.png", {width});
    const Pixels pixels(folder / "one.png");
    EXPECT_EQ(pixels.width(), width);
    EXPECT_EQ(pixels.height(), layout.page.height_px);
    EXPECT_GE(layout.table.min_y, std::max(layout.page.panel.max_y, layout.page.scale_strip.max_y));
    EXPECT_LE(layout.table.max_y, layout.page.height_px);
  }
  for (const std::string extension : {".png", ".svg", ".pdf"}) {
    draw_close_up(plan, 1, folder / ("a" + extension));
    draw_close_up(plan, 1, folder / ("b" + extension));
    EXPECT_EQ(bytes_of(folder / ("a" + extension)), bytes_of(folder / ("b" + extension))) << extension;
  }
}

TEST(CloseUp, ShowsWholeDetoursAndThreeWidthsRound) {
  const Plan plan = detour_plan();
  const Box window = close_up_window(plan, 0);
  EXPECT_TRUE(contains(window, bounds(plan.field.obstacles[0].shape).grown(18)));
  for (const TrackPiece& piece : plan.pieces)
    for (const Detour& detour : piece.detours) EXPECT_TRUE(contains(window, box_of(detour.path)));
  const CloseUpLayout layout = close_up_layout(plan, 0);
  EXPECT_TRUE(contains(layout.seen, window));
  EXPECT_TRUE(contains(
      layout.page.map,
      Box{layout.page.view.to_page({window.min_x, 0}).x, layout.page.view.to_page({0, window.max_y}).y,
          layout.page.view.to_page({window.max_x, 0}).x, layout.page.view.to_page({0, window.min_y}).y}));
}

TEST(CloseUp, StaysInTheFieldAtItsEdge) {
  const Plan plan = detour_plan();
  EXPECT_TRUE(contains(drawn_box(plan), close_up_window(plan, 1)));
  EXPECT_EQ(close_up_window(plan, 1).max_y, 60);
}

TEST(CloseUp, ColoursWhatItShowsWhereItLies) {
  const Folder folder;
  const Plan plan = detour_plan();
  draw_close_up(plan, 0, folder / "one.png");
  const Pixels pixels(folder / "one.png");
  const MapView view = close_up_layout(plan, 0).page.view;
  EXPECT_EQ(pixels.at(view.to_page({56.4, 31})), kUncoveredHex);
  EXPECT_EQ(pixels.at(view.to_page({60.9, 38.2})), kOverlapHex);
  EXPECT_EQ(pixels.at(view.to_page({60, 37})), kDetourHex);
  EXPECT_EQ(pixels.at(view.to_page({60, 26})), kDetourHex);
}

TEST(CloseUp, NamesTheObstacleByNumberAndPlace) {
  EXPECT_EQ(close_up_title(detour_plan(), 1), "obstacle 2 (hole 2)");
  Plan plan = detour_plan();
  plan.field.obstacles[1].origin.clear();
  EXPECT_EQ(close_up_title(plan, 1), "obstacle 2");
}

TEST(CloseUp, ListsWhatWasDecided) {
  Plan plan = detour_plan();
  plan.encounters[1].obstacles = {0, 1};
  const auto rows = encounter_rows(plan, 0);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].track, "5");
  EXPECT_EQ(rows[0].chosen, "right");
  EXPECT_EQ(rows[0].left, "no: detour would leave the body");
  EXPECT_EQ(rows[0].right, "−14.30");
  EXPECT_EQ(rows[1].chosen, "right (with 2)");
  EXPECT_EQ(rows[1].left, "+2.50");
  EXPECT_EQ(encounter_rows(plan, 1).size(), 3u);
  EXPECT_TRUE(encounter_rows(plan, 2).empty());
}

TEST(CloseUp, CountsTheMeetingsItDoesNotList) {
  Plan plan = detour_plan();
  plan.encounters.assign(100, plan.encounters[0]);
  const auto rows = encounter_rows(plan, 0);
  ASSERT_EQ(rows.size(), 24u);
  EXPECT_EQ(rows.back().track, "and 77 more");
}

TEST(CloseUp, CountsThemInFull) {
  const Box narrow{20, 0, 580, 800};
  Canvas canvas(PictureFormat::kPng, 600, 800);
  Plan plan = detour_plan();
  for (const std::size_t meetings : {30u, 1000u, 1000000u}) {
    plan.encounters.assign(meetings, plan.encounters[0]);
    plan.pieces.clear();
    const EncounterRow last = encounter_rows(plan, 0).back();
    EXPECT_EQ(cells_of(canvas, narrow, last, {})[0], "and " + std::to_string(meetings - 23) + " more");
  }
}

// One detour of track 5 passes two meetings, and another track has a detour of its own.
TEST(CloseUp, TellsTheCostOfAJointDetourOnce) {
  Plan plan = detour_plan();
  Encounter second = plan.encounters[0];
  second.at.x += 1;
  plan.encounters.insert(plan.encounters.begin() + 1, second);
  const auto rows = encounter_rows(plan, 0);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].right, "−14.30, joint for 2 meetings");
  EXPECT_EQ(rows[1].right, "joint, counted above");
  EXPECT_EQ(rows[2].right, "−8.05");
  EXPECT_EQ(rows[2].left, "+2.50");
}

TEST(CloseUp, TellsDifferentCostsOfAJointDetour) {
  Plan plan = detour_plan();
  Encounter second = plan.encounters[0];
  second.at.x += 1;
  second.right.cost = -9;
  plan.encounters.insert(plan.encounters.begin() + 1, second);
  const auto rows = encounter_rows(plan, 0);
  EXPECT_EQ(rows[0].right, "−14.30, joint for 2 meetings");
  EXPECT_EQ(rows[1].right, "−9.00, joint for 2 meetings");
}

TEST(CloseUp, NamesTheObstaclesOfAJointDetour) {
  Plan plan = detour_plan();
  Encounter second = plan.encounters[0];
  second.at.x += 1;
  second.obstacles = {1};
  plan.pieces[4].detours[0].obstacles = {0, 1};
  plan.encounters.insert(plan.encounters.begin() + 1, second);
  EXPECT_EQ(encounter_rows(plan, 0)[0].chosen, "right (with 2)");
  EXPECT_EQ(encounter_rows(plan, 0)[0].right, "−14.30, joint for 2 meetings");
  EXPECT_EQ(encounter_rows(plan, 1)[0].chosen, "right (with 1)");
  EXPECT_EQ(encounter_rows(plan, 1)[0].right, "−14.30, joint for 2 meetings");
}

TEST(CloseUp, CountsCutsOneByOne) {
  Plan plan = detour_plan();
  for (Encounter& encounter : plan.encounters) encounter.chosen = Passing::kCut;
  const auto rows = encounter_rows(plan, 0);
  EXPECT_EQ(rows[0].right, "−14.30");
  EXPECT_EQ(rows[1].right, "−8.05");
}

TEST(CloseUp, LegendNamesWhatIsInView) {
  const Plan plan = detour_plan();
  const auto first = legend_of_close_up(plan, 0, close_up_window(plan, 0));
  EXPECT_TRUE(has(first, Symbol::kDetour));
  EXPECT_TRUE(has(first, Symbol::kTightestArc));
  EXPECT_FALSE(has(first, Symbol::kStop));
  EXPECT_FALSE(has(first, Symbol::kPassable)) << "it is in another corner of the field";
  const auto second = legend_of_close_up(plan, 1, close_up_window(plan, 1));
  EXPECT_TRUE(has(second, Symbol::kStop));
  EXPECT_FALSE(has(second, Symbol::kTightestArc));
}

TEST(CloseUp, MarksTheTightestArcOfEachDetour) {
  Plan plan = detour_plan();
  const auto arcs = tightest_arcs(plan, 0);
  ASSERT_EQ(arcs.size(), 2u);
  EXPECT_NEAR(radius(arcs[0]), 8, 1e-9);
  EXPECT_NEAR(radius(arcs[1]), 6, 1e-9);
  EXPECT_NEAR(distance(middle_of_arc(arcs[0]), centre(arcs[0])), 8, 1e-9);
  EXPECT_NEAR(distance(middle_of_arc(arcs[0]), arcs[0].from), distance(middle_of_arc(arcs[0]), arcs[0].to),
              1e-9);
  EXPECT_LT(distance(middle_of_arc(arcs[0]), arcs[0].from), distance(arcs[0].from, arcs[0].to));
  EXPECT_TRUE(tightest_arcs(plan, 1).empty());
}

TEST(CloseUp, RefusesWhatItCannotDraw) {
  const Folder folder;
  EXPECT_EQ(kind_thrown(3, folder / "a.png"), ErrorKind::kBadInput);
  EXPECT_EQ(kind_thrown(-1, folder / "a.png"), ErrorKind::kBadInput);
  EXPECT_EQ(kind_thrown(0, folder / "a.jpg"), ErrorKind::kBadInput);
  EXPECT_EQ(kind_thrown(0, folder / "a.png", {10}), ErrorKind::kBadInput);
  EXPECT_EQ(kind_thrown(0, folder / "missing/a.png"), ErrorKind::kFailure);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace tramline::render
