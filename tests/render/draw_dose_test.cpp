#include "tramline/render/dose/draw_dose.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "sample_plan.h"
#include "support/refusals.h"
#include "tramline/model/palette.h"
#include "tramline/render/dose/dose_colours.h"

namespace tramline::render {
namespace {

/// 40 m by 30 m in cells of 1 m, 200 l/ha; nothing left of x = 10, twice as much right of x = 30.
DoseMap three_strips() {
  DoseMap map;
  map.unit = std::string("l");
  map.width_m = 10;
  map.field = {{{{0, 0}, {40, 0}, {40, 30}, {0, 30}}, {}}};
  map.field_id = std::string("strips");
  map.grid = {{0, 0}, 1, 40, 30};
  for (int row = 0; row < map.grid.rows; ++row)
    for (int column = 0; column < map.grid.columns; ++column) {
      const double per_ha = column < 10 ? 0 : column < 30 ? 200 : 400;
      map.amount.push_back(per_ha / 1e4);
      map.on_ground.push_back(static_cast<float>(per_ha / 1e4));
      map.ground.push_back(1);
    }
  map.figures.reference_per_ha = 200;
  map.figures.ground_m2 = map.figures.counted_m2 = 1200;
  map.figures.histogram = {{0, 10, 300}, {10, 30, 900}};
  return map;
}

int channel(std::uint32_t colour, int shift) { return static_cast<int>(colour >> shift & 0xff); }

TEST(DrawDose, EachRateHasItsColourWhereItLies) {
  const Folder folder;
  const DoseMap map = three_strips();
  draw_dose(map, folder / "map.png");
  const Pixels pixels(folder / "map.png");
  const MapView view = layout_of(map).view;
  const auto at = [&](Point p) { return pixels.at(view.to_page(p)) & 0xffffff; };
  EXPECT_EQ(at({5.5, 15.5}), kUncoveredHex);
  EXPECT_EQ(at({35.5, 15.5}), kOverlapHex);
  const std::uint32_t right = at({20.5, 15.5});  // pale, and more green than anything else
  EXPECT_GT(channel(right, 8), channel(right, 16));
  EXPECT_GT(channel(right, 8), channel(right, 0));
  EXPECT_GT(channel(right, 0), 0xb0);
  EXPECT_EQ(at({20.5, 31}), kBackgroundHex);  // north of the field; north is up
}

TEST(DrawDose, LittleBeyondTheGroundIsPale) {
  DoseMap map = three_strips();
  map.field = {{{{10, 0}, {40, 0}, {40, 30}, {10, 30}}, {}}};
  for (std::size_t i = 0; i < map.grid.size(); ++i)
    if (i % 40 < 10) {
      map.amount[i] = 6 / 1e4;
      map.ground[i] = 0;
      map.on_ground[i] = 0;
    }
  const Folder folder;
  draw_dose(map, folder / "map.png");
  const Pixels pixels(folder / "map.png");
  const std::uint32_t colour = pixels.at(layout_of(map).view.to_page({5.5, 15.5}));
  EXPECT_GT(channel(colour, 16), 0x80);  // far from the blue of ground that got nothing, and not white
  EXPECT_LT(channel(colour, 16), 0xf8);
}

TEST(DrawDose, ColoursGoFromBlueToBrownWithoutAJump) {
  Colour before = dose_colour(0);
  for (double multiple = 0.01; multiple < 3; multiple += 0.01) {
    const Colour now = dose_colour(multiple);
    EXPECT_NEAR(now.red, before.red, 0.03) << multiple;
    EXPECT_NEAR(now.green, before.green, 0.03) << multiple;
    EXPECT_NEAR(now.blue, before.blue, 0.06) << multiple;
    before = now;
  }
  EXPECT_GT(dose_colour(0.5).blue, dose_colour(0.5).red);
  EXPECT_GT(dose_colour(1.5).red, dose_colour(1.5).blue);
}

TEST(DrawDose, RefusesOtherNamesAndEmptyMaps) {
  using testing_support::mentions;
  using testing_support::refusal_of;
  EXPECT_TRUE(mentions(refusal_of([] { draw_dose(three_strips(), "map.bmp"); }), ".png"));
  DoseMap empty;
  empty.log = std::string("drive.csv");
  EXPECT_TRUE(mentions(refusal_of([&] { draw_dose(empty, "map.png"); }), "nothing to draw"));
}

}  // namespace
}  // namespace tramline::render
