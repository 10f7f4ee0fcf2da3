#include <fmt/format.h>

#include <algorithm>

#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

void check_clear(const BoxedRegion& land, const char* of_what, const PieceFrame& frame, const Box& core,
                 std::size_t index, Violations& out) {
  // Land thinner than the precision grid, along the whole piece, is no land.
  constexpr double kThinnest_m = 1e-7;
  const Clipped entered = clipped(land, frame, core);
  if (entered.area_m2 > kTouch_m2 + kThinnest_m * core.height())
    out.push_back(
        {"swaths",
         fmt::format("the swath of {} works {:.6f} m² of {}", piece_name(index), entered.area_m2, of_what),
         entered.at, entered.area_m2});
}

/// A vertex of the core that lies outside, or its middle where only an edge bulges.
Point place_outside(const Ring& outer, const PieceFrame& frame, const Box& core) {
  for (const double x : {core.min_x, core.max_x})
    for (const double y : {core.min_y, core.max_y})
      if (!contains(outer, frame.to_field({x, y}))) return frame.to_field({x, y});
  return frame.to_field(core.centre());
}

void check_inside(const Ring& outer, const PieceFrame& frame, const Box& core, std::size_t index,
                  Violations& out) {
  const double whole = core.width() * core.height();
  const double outside = whole - clipped(Polygon{outer, {}}, frame, core).area_m2;
  // A difference of large areas: rounding grows with them.
  if (outside > std::max(kTouch_m2, 1e-12 * whole))
    out.push_back(
        {"swaths",
         fmt::format("the swath of {} works {:.6f} m² beyond the hard boundary", piece_name(index), outside),
         place_outside(outer, frame, core), outside});
}

void check_straight_part(const Case& c, const PathSegment& part, std::size_t index, Violations& out) {
  const double half = 0.5 * c.plan.machine.width_m;
  const PieceFrame frame(part.from, part.to);
  const Box core = Box{-half, 0, half, frame.length()}.grown(-kLengthTolerance_m);
  if (core.width() <= 0 || core.height() <= 0) return;
  check_clear(c.obstacles, "an obstacle", frame, core, index, out);
  check_clear(c.passables, "a passable obstacle", frame, core, index, out);
  check_clear(c.given_up, "land given up", frame, core, index, out);
  if (c.plan.settings.boundary == EdgeKind::kHard) check_inside(c.plan.field.outer, frame, core, index, out);
}

void check_within_boundary(const Case& c, const Lane& lane, const std::string& name, Violations& out) {
  if (c.plan.settings.boundary == EdgeKind::kSoft) return;
  const Approach found = lane.to_ring(c.plan.field.outer, 0);
  if (found.gap_m < -kLengthTolerance_m)
    out.push_back(
        {"swaths",
         fmt::format("the swath of {} reaches {:.4f} m beyond the hard boundary", name, -found.gap_m),
         found.at, -found.gap_m});
}

void check_detour(const Case& c, const Lane& lane, const std::string& name, Violations& out) {
  if (const auto place = lane.place_outside(c.plan.field.outer))
    out.push_back({"swaths", name + " leaves the field", *place, 0});
  else
    check_within_boundary(c, lane, name, out);
}

}  // namespace

void check_line_within_field(const Case& c, const Lane& line, const std::string& name, Violations& out) {
  if (const auto place = line.place_pushed_outside(c.plan.field.outer))
    out.push_back({"swaths", name + " leaves the field", *place, 0});
  else
    check_within_boundary(c, line, name, out);
}

void check_swaths(const Case& c, Violations& out) {
  const double half = 0.5 * c.plan.machine.width_m;
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    for (const PathSegment& part : straight_parts(piece)) check_straight_part(c, part, i, out);
    if (piece.detours.empty()) continue;
    const PieceFrame frame(piece);
    for (std::size_t k = 0; k < piece.detours.size(); ++k)
      check_detour(c, Lane(frame, piece.detours[k].path, half), detour_name(i, k), out);
  }
}

}  // namespace tramline::check
