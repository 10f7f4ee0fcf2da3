#include <fmt/format.h>

#include <string>
#include <vector>

#include "tramline/check/measure/swath_core.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// With headlands the boundary is always hard: the headland is driven on, and there is no land beyond it.
bool boundary_is_hard(const Plan& plan) {
  return plan.settings.boundary == EdgeKind::kHard || plan.settings.headlands > 0;
}

void check_clear(const SwathCore& core, const BoundedRegion& land, const char* of_what, std::size_t index,
                 Violations& out) {
  const Clipped entered = core.part_on(land);
  if (entered.area_m2 > kTouch_m2 + core.slivers_m2())
    out.push_back(
        {Rule::kSwaths,
         fmt::format("the swath of {} works {:.6f} m² of {}", piece_name(index), entered.area_m2, of_what),
         entered.at, entered.area_m2});
}

void check_inside(const SwathCore& core, const Ring& outer, std::size_t index, Violations& out) {
  const Clipped beyond = core.part_beyond(outer);
  if (beyond.area_m2 > kTouch_m2)
    out.push_back({Rule::kSwaths,
                   fmt::format("the swath of {} works {:.6f} m² beyond the hard boundary", piece_name(index),
                               beyond.area_m2),
                   beyond.at, beyond.area_m2});
}

void check_core(const Case& c, const Path& path, std::size_t index, Violations& out, Violations& beyond) {
  const SwathCore core(path, c.plan.machine.width_m);
  check_clear(core, c.obstacles, "an obstacle", index, out);
  check_clear(core, c.passables, "a passable obstacle", index, out);
  check_clear(core, c.given_up, "land given up", index, out);
  if (boundary_is_hard(c.plan)) check_inside(core, c.plan.field.outer, index, beyond);
}

void check_within_boundary(const Case& c, const SwathClearance& swath, const std::string& name,
                           Violations& out) {
  if (!boundary_is_hard(c.plan)) return;
  const Approach found = swath.to_ring(c.plan.field.outer, 0);
  if (found.gap_m < -kLengthTolerance_m)
    out.push_back(
        {Rule::kSwaths,
         fmt::format("the swath of {} reaches {:.4f} m beyond the hard boundary", name, -found.gap_m),
         found.at, -found.gap_m});
}

}  // namespace

void check_line_within_field(const Case& c, const SwathClearance& line, const std::string& name,
                             Violations& out) {
  if (const auto point = line.point_pushed_outside(c.plan.field.outer))
    out.push_back({Rule::kSwaths, name + " leaves the field", *point, 0});
  else
    check_within_boundary(c, line, name, out);
}

void check_swaths(const Case& c, Violations& out, Violations& beyond) {
  const double half = 0.5 * c.plan.machine.width_m;
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    const bool curved = !piece.curve.empty();
    // The detours of a curved piece are parts of its curve.
    for (const Path& path : curved ? std::vector<Path>{piece.curve} : parts_on_track(piece))
      check_core(c, path, i, out, beyond);
    for (std::size_t k = 0; k < piece.detours.size(); ++k) {
      const Path& path = piece.detours[k].path;
      const SwathClearance swath(frame_of_detour(piece, path), path, half);
      if (const auto point = swath.point_outside(c.plan.field.outer))
        out.push_back({Rule::kSwaths, detour_name(i, k) + " leaves the field", *point, 0});
      else if (!curved)
        check_within_boundary(c, swath, detour_name(i, k), out);
    }
  }
}

}  // namespace tramline::check
