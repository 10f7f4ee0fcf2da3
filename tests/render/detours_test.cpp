// The picture of a plan whose tracks go round obstacles.

#include <gtest/gtest.h>

#include "detour_plan.h"
#include "tramline/model/detour_summary.h"
#include "tramline/model/palette.h"
#include "tramline/render/page/legend_content.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::render {
namespace {

const LegendRow* row_of(const std::vector<LegendBlock>& blocks, const std::string& text) {
  for (const LegendBlock& block : blocks)
    for (const LegendRow& row : block.rows)
      if (row.text == text) return &row;
  return nullptr;
}

/// Is there a pixel of the detours' colour within a pixel of the place?
bool detour_at(const Pixels& pixels, Point page) {
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      if (pixels.at(page + Point{x, y}) == kDetourHex) return true;
  return false;
}

TEST(Detours, AreSummed) {
  const DetourSummary summary = summary_of_detours(detour_plan());
  EXPECT_EQ(summary.left, 0);
  EXPECT_EQ(summary.right, 2);
  EXPECT_NEAR(summary.smallest_radius_m, 6, 1e-12);
  EXPECT_EQ(summary_of_detours(sample_plan()).count(), 0);
}

TEST(Detours, AreDrawnAlongTheirArcs) {
  const Folder folder;
  const Plan plan = detour_plan();
  draw_plan(plan, folder / "plan.png");
  const Pixels pixels(folder / "plan.png");
  const MapView view = layout_of(plan).view;
  for (const TrackPiece& piece : plan.pieces)
    for (const Detour& detour : piece.detours)
      for (const Point on_it : chords(detour.path, 0.01))
        EXPECT_TRUE(detour_at(pixels, view.to_page(on_it))) << on_it.x << ' ' << on_it.y;
  EXPECT_FALSE(detour_at(pixels, view.to_page({60, 33}))) << "the line the track has left";
  EXPECT_FALSE(detour_at(pixels, view.to_page({20, 33}))) << "before the detour";
}

TEST(Detours, HaveRowsInTheLegendWhereThereAreAny) {
  const auto with = legend_of(detour_plan()), without = legend_of(sample_plan());
  ASSERT_NE(row_of(with, "detour round an obstacle"), nullptr);
  EXPECT_EQ(row_of(with, "detour round an obstacle")->symbol, Symbol::kDetour);
  ASSERT_NE(row_of(with, "detours"), nullptr);
  EXPECT_EQ(row_of(with, "detours")->value, "2");
  EXPECT_EQ(row_of(without, "detour round an obstacle"), nullptr);
  EXPECT_EQ(row_of(without, "detours"), nullptr);
}

TEST(Detours, WidenThePageWhereTheyLeaveTheField) {
  Plan plan = detour_plan();
  TrackPiece& last = plan.pieces.back();
  last.detours.push_back({reversed(sidestep_round(60, 57, 20, 11, 4)), Passing::kRight, {0}});
  EXPECT_NEAR(drawn_box(plan).max_y, 57 + 20 + 3, 0.02);
}

}  // namespace
}  // namespace tramline::render
