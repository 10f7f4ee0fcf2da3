// Areas between shapes laid over one another, against what can be said by hand and against GEOS.

#include "tramline/check/measure/overlay_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>

#include "check/plans.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

using check::Cover;
using check::OverlayCell;
using check::OverlayEdges;

/// The area of all cells that just these shapes hold.
std::map<std::vector<std::size_t>, double> areas_of(const OverlayEdges& overlay) {
  std::map<std::vector<std::size_t>, double> out;
  check::each_cell(overlay, [&out](const OverlayCell& cell) {
    std::vector<std::size_t> shapes;
    for (const Cover& cover : cell.covers) shapes.push_back(cover.shape);
    out[shapes] += cell.area_m2;
  });
  return out;
}

TEST(OverlayCells, SquaresThatShareACornerOfThemselves) {
  OverlayEdges overlay;
  overlay.add(Polygon{testing_plans::box(0, 0, 10, 10), {}}, 0);
  overlay.add(Polygon{testing_plans::box(6, 7, 16, 17), {testing_plans::box(7, 8, 8, 9)}}, 1);
  auto areas = areas_of(overlay);
  EXPECT_DOUBLE_EQ((areas[{0}]), 100 - 11);
  EXPECT_DOUBLE_EQ((areas[{0, 1}]), 4 * 3 - 1);
  EXPECT_DOUBLE_EQ((areas[{1}]), 100 - 12);
}

TEST(OverlayCells, AShapeThatLiesOverItselfCountsTwiceThere) {
  OverlayEdges overlay;
  overlay.add(Region{{testing_plans::box(0, 0, 4, 4), {}}, {{{2, 2}, {2, 6}, {6, 6}, {6, 2}}, {}}}, 5);
  double once_m2 = 0, twice_m2 = 0;
  check::each_cell(overlay, [&](const OverlayCell& cell) {
    ASSERT_EQ(cell.covers.size(), 1u);
    (cell.covers[0].times == 1 ? once_m2 : twice_m2) += cell.area_m2;
  });
  EXPECT_DOUBLE_EQ(once_m2, 24);
  EXPECT_DOUBLE_EQ(twice_m2, 4);
}

/// A slanting swath that is driven thirty times: no halving leaves one of its sides aside.
TEST(OverlayCells, ManyEdgesAlongOneLineAreNotHalvedForEver) {
  OverlayEdges overlay;
  const Ring swath{{0, 0}, {80, 60}, {78.2, 62.4}, {-1.8, 2.4}};
  for (std::size_t shape = 0; shape < 30; ++shape) overlay.add(Polygon{swath, {}}, shape);
  constexpr int kPlenty = 100000;
  int cells = 0;
  double sum_m2 = 0;
  const auto visit = [&](const OverlayCell& cell) {
    if (++cells > kPlenty) throw std::runtime_error("too many cells");
    EXPECT_EQ(cell.covers.size(), 30u);
    sum_m2 += cell.area_m2;
  };
  ASSERT_NO_THROW(check::each_cell(overlay, visit));
  EXPECT_NEAR(sum_m2, 300, 1e-9);
}

/// Stars of many corners over one another, so many that windows are halved often.
TEST(OverlayCells, AreasAreThoseOfOverlays) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(40, 100), shift(-60, 60);
  const auto star = [&](int corners) {
    const Point centre{shift(random), shift(random)};
    Ring out;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      out.push_back(centre + radius(random) * Point{std::cos(angle), std::sin(angle)});
    }
    return Region{{out, {}}};
  };
  for (const int corners : {5, 40, 700}) {
    const Region a = star(corners), b = star(corners), c = star(3 * corners);
    OverlayEdges overlay;
    overlay.add(a, 0);
    overlay.add(b, 1);
    overlay.add(c, 2);
    auto areas = areas_of(overlay);
    constexpr double kGrid_m2 = 0.1;  // the overlays': a micrometre along some 50 km of edges
    EXPECT_NEAR((areas[{0, 1, 2}]), area(intersection(intersection(a, b), c)), kGrid_m2);
    EXPECT_NEAR((areas[{0}]), area(difference(difference(a, b), c)), kGrid_m2);
    EXPECT_NEAR((areas[{1, 2}]), area(difference(intersection(b, c), a)), kGrid_m2);
    double all_m2 = 0;
    for (const auto& [shapes, area_m2] : areas) all_m2 += area_m2 * static_cast<double>(shapes.size());
    EXPECT_NEAR(all_m2, area(a) + area(b) + area(c), 1e-7);
  }
}

}  // namespace
}  // namespace tramline
