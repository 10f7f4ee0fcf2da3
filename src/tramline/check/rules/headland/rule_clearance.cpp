#include <fmt/format.h>

#include "tramline/check/measure/bands.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {
namespace {

void check_land(const BoundedRegion& land, const char* of_what, double clearance_m,
                const SwathClearance& swath, const std::string& name, Violations& out) {
  const double least_m = clearance_m - kLengthTolerance_m;
  const Box near = swath.field_box(least_m);
  for (const BoundedPolygon& polygon : land) {
    if (!intersects(polygon.box, near)) continue;
    const Approach found = swath.to_land(*polygon.shape, least_m);
    if (found.gap_m >= least_m) continue;
    out.push_back(
        {Rule::kClearance,
         fmt::format("{} comes {:.4f} m nearer to {} than it may", name, clearance_m - found.gap_m, of_what),
         found.at, clearance_m - found.gap_m});
  }
}

/// The clearance all round a curved swath, including its flat ends.
void check_curve(const Case& c, const TrackPiece& piece, const std::string& name, Violations& out) {
  const double least_m = c.plan.settings.clearance_m - kLengthTolerance_m;
  if (least_m <= 0) return;
  for (const Polygon& part : bands_along(piece.curve, c.plan.machine.width_m)) {
    const Box near = bounds(part).grown(least_m);
    for (const BoundedPolygon& obstacle : c.obstacles) {
      if (!intersects(obstacle.box, near)) continue;
      const double missing_m =
          c.plan.settings.clearance_m - tramline::distance_between({part}, {*obstacle.shape});
      if (missing_m <= kLengthTolerance_m) continue;
      out.push_back({Rule::kClearance,
                     fmt::format("{} comes {:.4f} m nearer to an obstacle than it may", name, missing_m),
                     bounds(part).centre(), missing_m});
      return;
    }
  }
}

}  // namespace

void check_clearance_of(const Case& c, const SwathClearance& swath, const std::string& name,
                        Violations& out) {
  check_land(c.obstacles, "an obstacle", c.plan.settings.clearance_m, swath, name, out);
  check_land(c.passables, "a passable obstacle", 0, swath, name, out);
  check_land(c.given_up, "land given up", 0, swath, name, out);
}

void check_clearance(const Case& c, Violations& out) {
  const double half = 0.5 * c.plan.machine.width_m, clearance_m = c.plan.settings.clearance_m;
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    const PieceFrame frame(piece);
    for (std::size_t k = 0; k < piece.detours.size(); ++k) {
      const Path& path = piece.detours[k].path;
      check_clearance_of(c, SwathClearance(frame_of_detour(piece, path), path, half), detour_name(i, k), out);
    }
    // Without a clearance the rule about swaths covers everything.
    if (clearance_m <= 0) continue;
    if (!piece.curve.empty()) {
      check_curve(c, piece, "the swath of " + piece_name(i), out);
      continue;
    }
    for (const PathSegment& part : straight_parts(piece))
      check_land(c.obstacles, "an obstacle", clearance_m, SwathClearance(frame, {part}, half),
                 "the swath of " + piece_name(i), out);
  }
}

}  // namespace tramline::check
