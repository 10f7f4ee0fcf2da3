#include "tramline/render/page/page_layout.h"

#include <gtest/gtest.h>

#include "sample_plan.h"

namespace tramline::render {
namespace {

const std::vector<double> kBlocks{250, 320, 100};

bool inside(const Box& inner, const Box& outer) {
  return inner.min_x >= outer.min_x && inner.max_x <= outer.max_x && inner.min_y >= outer.min_y &&
         inner.max_y <= outer.max_y;
}

TEST(PageLayout, PartsKeepApartAndOnThePage) {
  for (const int width : {600, 1000, 1600, 4000}) {
    for (const double shape : {0.01, 0.3, 1.0, 3.0, 100.0}) {
      const PageLayout page = lay_out_page({0, 0, 100, 100 * shape}, width, kBlocks);
      const Box whole{0, 0, static_cast<double>(page.width_px), static_cast<double>(page.height_px)};
      for (const Box& part : {page.title, page.map, page.scale_strip, page.panel})
        EXPECT_TRUE(inside(part, whole));
      EXPECT_FALSE(intersects(page.map.grown(-1), page.panel));
      EXPECT_FALSE(intersects(page.scale_strip.grown(-1), page.panel));
      EXPECT_LE(page.height_px, 3 * width);
    }
  }
}

TEST(PageLayout, FieldFitsTheMapWithNorthUp) {
  for (const double shape : {0.01, 0.3, 1.0, 3.0, 100.0}) {
    const Box field{500, -200, 600, -200 + 100 * shape};
    const PageLayout page = lay_out_page(field, 1600, kBlocks);
    const Point north_west = page.view.to_page({field.min_x, field.max_y});
    const Point south_east = page.view.to_page({field.max_x, field.min_y});
    EXPECT_LT(north_west.y, south_east.y);
    EXPECT_LT(north_west.x, south_east.x);
    EXPECT_TRUE(inside({north_west.x, north_west.y, south_east.x, south_east.y}, page.map));
  }
}

TEST(PageLayout, WideFieldsHaveTheirLegendBelow) {
  const PageLayout wide = lay_out_page({0, 0, 400, 100}, 1600, kBlocks);
  EXPECT_GT(wide.panel.min_y, wide.map.max_y);
  const PageLayout compact = lay_out_page({0, 0, 100, 100}, 1600, kBlocks);
  EXPECT_GT(compact.panel.min_x, compact.map.max_x);
}

TEST(PageLayout, BlocksGoToTheShortestColumn) {
  EXPECT_EQ(columns_of_blocks({10, 20, 5, 5}, 2), (std::vector<int>{0, 1, 0, 0}));
  EXPECT_EQ(columns_of_blocks({10, 20}, 1), (std::vector<int>{0, 0}));
}

TEST(DrawnBox, HoldsSwathsThatRunPastTheEdge) {
  Plan plan = sample_plan();
  plan.pieces.push_back({{0, -7}, {0, 66}, 0, 9});
  const Box box = drawn_box(plan);
  EXPECT_EQ(box.min_x, -5);
  EXPECT_EQ(box.min_y, -7);
  EXPECT_EQ(box.max_y, 66);
}

}  // namespace
}  // namespace tramline::render
