#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/overlay_cells.h"
#include "tramline/check/rules/rules.h"
#include "tramline/geometry/tolerances.h"

namespace tramline::check {
namespace {

/// Area worked again that counts as much as one unit of uncovered area.
constexpr double kMissed = 5;
/// The permitted useless work in one stretch, m² worked again: about the cost of two ends.
constexpr double kStretch_m2 = 500;

/// A short part of a pass.
struct Slice {
  std::size_t pass = 0;
  Path path;
  double worth_m2 = 0;  ///< what it is the first to work of the headland, kMissed times, less the rest
};

/// All passes in slices of half the width at most, in their order.
std::vector<Slice> slices_of(const Plan& plan) {
  std::vector<Slice> out;
  for (std::size_t i = 0; i < plan.headland.passes.size(); ++i)
    for (const PathSegment& segment : plan.headland.passes[i].path) {
      const double length_m = length(segment);
      const double count = std::max(1.0, std::ceil(length_m / (0.5 * plan.machine.width_m)));
      Point from = segment.from;
      for (double k = 1; k <= count; ++k) {
        const Point to = k < count ? point_on({segment}, length_m * k / count) : segment.to;
        out.push_back({i, {{from, to, segment.curvature}}, 0});
        from = to;
      }
    }
  return out;
}

void find_worths(const Case& c, std::vector<Slice>& slices) {
  enum Over : std::size_t { kHeadland, kPassables, kFirstSlice };
  const double width_m = c.plan.machine.width_m;
  OverlayEdges overlay;
  overlay.add(c.plan.headland.ground, kHeadland);
  for (const BoundedPolygon& land : c.passables) overlay.add(*land.shape, kPassables);
  for (std::size_t i = 0; i < slices.size(); ++i) {
    overlay.add(flat_bands_along(slices[i].path, width_m, kLayerSagitta), kFirstSlice + i);
    slices[i].worth_m2 = -width_m * length(slices[i].path);
  }
  each_cell(overlay, [&](const OverlayCell& cell) {
    bool headland = false, passable = false, first = true;
    for (const Cover& cover : cell.covers) {
      headland = headland || cover.shape == kHeadland;
      passable = passable || cover.shape == kPassables;
      if (cover.shape < kFirstSlice) continue;
      Slice& slice = slices[cover.shape - kFirstSlice];
      if (headland && first) slice.worth_m2 += (kMissed + 1) * cell.area_m2;
      if (passable) slice.worth_m2 += cell.area_m2;
      first = false;
    }
  });
}

/// The least sum of slices of one pass in a row, and where it begins. A closed pass goes on from its
/// beginning.
struct Worst {
  double worth_m2 = 0;
  std::size_t first = 0;
};

Worst worst_stretch(const std::vector<Slice>& slices, std::size_t first, std::size_t last, bool closed) {
  const std::size_t n = last - first;
  Worst worst, now;
  for (std::size_t k = 0; k < (closed ? 2 * n : n); ++k) {
    if (now.worth_m2 >= 0) now = {0, k};
    now.worth_m2 += slices[first + k % n].worth_m2;
    if (k - now.first >= n) break;
    if (now.worth_m2 < worst.worth_m2) worst = {now.worth_m2, first + now.first % n};
  }
  return worst;
}

}  // namespace

void check_worth(const Case& c, Violations& out) {
  if (c.plan.headland.construction == HeadlandConstruction::kPlain) return;
  std::vector<Slice> slices = slices_of(c.plan);
  find_worths(c, slices);
  const double width_m = c.plan.machine.width_m;
  // Slices that are only partly useless may lie on either side of the beginning and end of a stretch.
  const double most_m2 = kStretch_m2 + width_m * width_m;
  for (std::size_t first = 0, last = 0; first < slices.size(); first = last) {
    while (last < slices.size() && slices[last].pass == slices[first].pass) ++last;
    const std::size_t i = slices[first].pass;
    const Worst worst = worst_stretch(slices, first, last, is_closed(c.plan.headland.passes[i]));
    if (-worst.worth_m2 <= most_m2) continue;
    out.push_back({Rule::kHeadland,
                   fmt::format("a stretch of {}, which was not asked for, works {:.0f} m² again or beyond "
                               "the headland, more than what it works for the first time is worth",
                               pass_name(i), -worst.worth_m2),
                   slices[worst.first].path.front().from, -worst.worth_m2});
  }
}

}  // namespace tramline::check
