// The picture of a plan with a headland and curved tracks.

#include "curved_plan.h"
#include "render/shows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/model/palette.h"
#include "tramline/render/close_up/close_up.h"
#include "tramline/render/close_up/close_up_content.h"
#include "tramline/render/page/labels.h"
#include "tramline/render/page/legend_content.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::render {
namespace {

std::map<std::string, std::string> rows(const std::vector<LegendBlock>& blocks) {
  std::map<std::string, std::string> out;
  for (const LegendBlock& block : blocks)
    for (const LegendRow& row : block.rows) out[row.text] = row.value;
  return out;
}

/// The pixels within so many of the place that are nearer to this colour than `most` in every channel.
int count_near(const Pixels& pixels, Point page, int reach, std::uint32_t colour, int most) {
  int out = 0;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y) {
      const std::uint32_t found = pixels.at(page + Point{1.0 * x, 1.0 * y});
      int off = 0;
      for (const int shift : {0, 8, 16})
        off = std::max(off, std::abs(static_cast<int>((found >> shift) & 0xff) -
                                     static_cast<int>((colour >> shift) & 0xff)));
      out += off <= most ? 1 : 0;
    }
  return out;
}

class CurvedPlan : public testing::Test {
 protected:
  CurvedPlan() : plan_(curved_plan()) {
    draw_plan(plan_, folder_ / "plan.png");
    pixels_ = std::make_unique<Pixels>(folder_ / "plan.png");
    view_ = layout_of(plan_).view;
  }
  Plan plan_;
  Folder folder_;
  std::unique_ptr<Pixels> pixels_;
  MapView view_;
};

TEST_F(CurvedPlan, TracksAreDrawnAlongTheirArcs) {
  int arcs = 0;
  for (const TrackPiece& piece : plan_.pieces) {
    for (const PathSegment& segment : piece.curve) {
      if (segment.straight()) continue;
      ++arcs;
      // The badge of the subfield hides what is under it, and arrow heads are as good as lines.
      int hits = 0, places = 0;
      for (const Point on_it : chords({segment}, 0.01)) {
        ++places;
        hits += count_near(*pixels_, view_.to_page(on_it), 1, kTrackHex, 0x60) > 0 ? 1 : 0;
      }
      EXPECT_GT(hits, 0.8 * places) << piece.track;
    }
  }
  EXPECT_GT(arcs, 20);
}

TEST_F(CurvedPlan, HeadlandIsTintedAndItsPassesAreDrawn) {
  // Between the lines of both passes, where neither is a shade darker.
  EXPECT_GT(count_near(*pixels_, view_.to_page({100, 5}), 2, 0xDEDACF, 3), 10);
  for (const HeadlandPass& pass : plan_.headland.passes) {
    int hits = 0, places = 0;
    for (const Point on_it : chords(pass.path, 1e-3)) {
      ++places;
      hits += count_near(*pixels_, view_.to_page(on_it), 1, kHeadlandPassHex, 0x50) > 0 ? 1 : 0;
    }
    // Dashes take two thirds of the line.
    EXPECT_GT(hits, places / 3) << pass.number;
  }
}

TEST_F(CurvedPlan, UnworkedHeadlandHasTheColourOfUncoveredLand) {
  // Outside the arc of a corner, 3.7 m of it along the diagonal: filled, not just outlined.
  const Point corner{1.3, 1.3};
  EXPECT_EQ(pixels_->at(view_.to_page(corner)), kUncoveredHex);
  plan_.figures = PlanFigures::kTracks;
  plan_.uncovered = intersection(plan_.uncovered, plan_.body);
  draw_plan(plan_, folder_ / "older.png");
  EXPECT_EQ(Pixels(folder_ / "older.png").at(view_.to_page(corner)), kUncoveredHex)
      << "a plan whose figures are those of its tracks";
}

TEST_F(CurvedPlan, TheReferenceEndsBesideTheField) {
  const Plan without = [&] {
    Plan out = plan_;
    for (Subfield& subfield : out.subfields) subfield.reference.clear();
    return out;
  }();
  EXPECT_EQ(drawn_box(without).max_x, drawn_box(plan_).max_x) << "it makes no page wider";
  EXPECT_GT(count_near(*pixels_, view_.to_page({60, 60}), 8, 0x00695C, 0x20), 0);
  EXPECT_EQ(count_near(*pixels_, view_.to_page({-20, 60}), 4, 0x00695C, 0x20), 0);
}

TEST_F(CurvedPlan, NumbersStandBehindTheStartAlongTheCurve) {
  const auto labels = place_track_labels(plan_, view_, 1, {});
  const auto found =
      std::find_if(labels.begin(), labels.end(), [](const TrackLabel& label) { return label.text == "10"; });
  ASSERT_NE(found, labels.end());
  const TrackPiece& piece = plan_.pieces[9];
  const Point behind = found->centre - view_.to_page(piece.start);
  const Point start = direction_at_start(piece.curve.front());
  EXPECT_NEAR(cross(behind, {start.x, -start.y}), 0, 1e-6);
  EXPECT_LT(dot(behind, {start.x, -start.y}), 0);
}

TEST_F(CurvedPlan, TheLegendSaysSo) {
  const auto with = rows(legend_of(plan_)), without = rows(legend_of(sample_plan()));
  for (const char* text : {"headland", "headland pass", "line that tracks follow", "kind of tracks",
                           "smallest radius", "passes", "length of passes", "left unworked"}) {
    EXPECT_EQ(with.count(text), 1u) << text;
    EXPECT_EQ(without.count(text), 0u) << text;
  }
  EXPECT_EQ(with.at("kind of tracks"), "curved");
  EXPECT_EQ(with.at("passes"), "3");
  double smallest_m = 1e9;
  for (const TrackPiece& piece : plan_.pieces)
    smallest_m = std::min(smallest_m, smallest_radius(piece.curve));
  EXPECT_NEAR(std::stod(with.at("smallest radius")), smallest_m, 0.051);
  EXPECT_EQ(with.count("about 75.0° from north"), 1u);
}

TEST_F(CurvedPlan, UnworkedHeadlandIsUncoveredInTheLegend) {
  plan_.uncovered.clear();
  EXPECT_TRUE(shows(plan_, Symbol::kUncovered));
  plan_.headland.unworked.clear();
  EXPECT_FALSE(shows(plan_, Symbol::kUncovered));
}

TEST_F(CurvedPlan, CloseUpsShowItToo) {
  draw_close_up(plan_, 0, folder_ / "close.png");
  const Pixels close(folder_ / "close.png");
  const MapView view = close_up_layout(plan_, 0).page.view;
  EXPECT_GT(count_near(close, view.to_page({86, 81}), 9, kHeadlandPassHex, 0x50), 0);
  EXPECT_EQ(rows(legend_of_close_up(plan_, 0, {60, 60, 110, 110})).count("headland pass"), 1u);
  const auto elsewhere = rows(legend_of_close_up(plan_, 0, {130, 40, 150, 70}));
  for (const char* text : {"headland", "headland pass"}) EXPECT_EQ(elsewhere.count(text), 0u) << text;
  EXPECT_EQ(elsewhere.count("line that tracks follow"), 1u);
  EXPECT_EQ(rows(legend_of_close_up(plan_, 0, {60, 70, 110, 110})).count("line that tracks follow"), 0u);
  EXPECT_EQ(rows(legend_of_close_up(sample_plan(), 0, {0, 0, 50, 50})).count("headland pass"), 0u);
}

TEST_F(CurvedPlan, VectorPicturesAreTheSameEveryTime) {
  for (const std::string extension : {".svg", ".pdf"}) {
    draw_plan(plan_, folder_ / ("a" + extension));
    draw_plan(plan_, folder_ / ("b" + extension));
    EXPECT_EQ(bytes_of(folder_ / ("a" + extension)), bytes_of(folder_ / ("b" + extension)));
  }
}

}  // namespace
}  // namespace tramline::render
