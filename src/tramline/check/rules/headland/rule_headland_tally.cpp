#include <fmt/format.h>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/comparison.h"
#include "tramline/check/measure/overlay_cells.h"
#include "tramline/check/measure/worked_parts.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The areas that the passes work.
struct HeadlandWork {
  double worked_m2 = 0;
  double covered_m2 = 0;  ///< of the headland
  double left_m2 = 0;     ///< of the headland
  double drawn_wrong_m2 = 0;
  Point drawn_wrong_at;
  double arcs_m = 0;
};

/// On passables the work is interrupted: the area there is deducted as often as it is driven over.
HeadlandWork work(const Case& c) {
  enum Over : std::size_t { kHeadland, kUnworkedLayer, kPassables, kFirstPart };
  HeadlandWork out;
  OverlayEdges overlay;
  overlay.add(c.plan.headland.ground, kHeadland);
  overlay.add(c.plan.headland.unworked, kUnworkedLayer);
  for (const BoundedPolygon& land : c.passables) overlay.add(*land.shape, kPassables);
  std::size_t parts = kFirstPart;
  for (const HeadlandPass& pass : c.plan.headland.passes) {
    out.worked_m2 += c.plan.machine.width_m * length(pass.path);
    out.arcs_m += arcs_m(pass.path);
    for (const Polygon& band : pass_bands(c.plan, pass, kChordSagitta)) overlay.add(band, parts++);
  }
  double largest_m2 = 0;
  each_cell(overlay, [&](const OverlayCell& cell) {
    bool headland = false, drawn = false, passable = false;
    std::size_t bands = 0;
    for (const Cover& cover : cell.covers) {
      headland = headland || cover.shape == kHeadland;
      drawn = drawn || cover.shape == kUnworkedLayer;
      passable = passable || cover.shape == kPassables;
      bands += cover.shape >= kFirstPart ? 1 : 0;
    }
    if (passable) out.worked_m2 -= static_cast<double>(bands) * cell.area_m2;
    const bool left = headland && bands == 0;
    if (headland) (left ? out.left_m2 : out.covered_m2) += cell.area_m2;
    if (left == drawn) return;
    out.drawn_wrong_m2 += cell.area_m2;
    if (cell.area_m2 <= largest_m2) return;
    largest_m2 = cell.area_m2;
    out.drawn_wrong_at = cell.middle;
  });
  return out;
}

}  // namespace

void check_headland_tally(const Case& c, Violations& out) {
  const Headland& stored = c.plan.headland;
  const HeadlandWork found = work(c);
  const double ground_m2 = area(stored.ground);
  const double tolerance_m2 = c.area_tolerance_m2 + kChordSagitta * 2 * found.arcs_m;
  Comparison compare("the headland's passes", c.plan.field.outer.front(), out);
  compare.number("worked area of the headland", " m²", stored.worked_m2, found.worked_m2, tolerance_m2);
  compare.number("overlap in the headland", " m²", stored.overlap_m2, found.worked_m2 - found.covered_m2,
                 tolerance_m2);
  compare.number("uncovered area of the headland", " m²", stored.uncovered_m2, found.left_m2, tolerance_m2);
  compare.number("worked area of the headland, as ground less uncovered plus overlap,", " m²",
                 ground_m2 - stored.uncovered_m2 + stored.overlap_m2, found.worked_m2, tolerance_m2);

  if (found.drawn_wrong_m2 > c.area_tolerance_m2 + kRoundEdge_m * 2 * found.arcs_m)
    out.push_back({Rule::kTally,
                   fmt::format("the layer of land that headland passes leave is wrong by {:.3f} m²",
                               found.drawn_wrong_m2),
                   found.drawn_wrong_at, found.drawn_wrong_m2});
}

}  // namespace tramline::check
