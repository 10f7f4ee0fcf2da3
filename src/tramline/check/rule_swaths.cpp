#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tramline/check/bands.h"
#include "tramline/check/rule_names.h"
#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/boolean.h"

namespace tramline::check {
namespace {

/// The ground behind a body's edge is driven on, and there is none behind that.
bool boundary_is_hard(const Plan& plan) {
  return plan.settings.boundary == EdgeKind::kHard || plan.settings.headlands > 0;
}

void check_clear(const BoxedRegion& land, const char* of_what, const PieceFrame& frame, const Box& core,
                 std::size_t index, Violations& out) {
  // Land thinner than the precision grid, along the whole piece, is no land.
  constexpr double kThinnest_m = 1e-7;
  const Clipped entered = clipped(land, frame, core);
  if (entered.area_m2 > kTouch_m2 + kThinnest_m * core.height())
    out.push_back(
        {rule::kSwaths,
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
        {rule::kSwaths,
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
  if (boundary_is_hard(c.plan)) check_inside(c.plan.field.outer, frame, core, index, out);
}

void check_within_boundary(const Case& c, const Lane& lane, const std::string& name, Violations& out) {
  if (!boundary_is_hard(c.plan)) return;
  const Approach found = lane.to_ring(c.plan.field.outer, 0);
  if (found.gap_m < -kLengthTolerance_m)
    out.push_back(
        {rule::kSwaths,
         fmt::format("the swath of {} reaches {:.4f} m beyond the hard boundary", name, -found.gap_m),
         found.at, -found.gap_m});
}

void check_detour(const Case& c, const Lane& lane, const std::string& name, Violations& out) {
  if (const auto place = lane.place_outside(c.plan.field.outer))
    out.push_back({rule::kSwaths, name + " leaves the field", *place, 0});
  else
    check_within_boundary(c, lane, name, out);
}

/// A curved swath but for a millimetre all round, against land and boundary. By polygons: chords are within
/// the millimetre.
class CurvedSwath {
 public:
  CurvedSwath(const Case& c, const TrackPiece& piece, std::string name) : name_(std::move(name)) {
    const double width_m = c.plan.machine.width_m - 2 * kLengthTolerance_m;
    if (width_m > 0) core_ = bands_along(shortened(piece.curve, kLengthTolerance_m), width_m);
    for (const Polygon& part : core_) boxes_.push_back(bounds(part));
  }

  void check_clear(const BoxedRegion& land, const char* of_what, Violations& out) const {
    Region entered;
    for (const Boxed& polygon : land)
      for (std::size_t i = 0; i < core_.size(); ++i)
        if (intersects(boxes_[i], polygon.box))
          for (Polygon& part : intersection({core_[i]}, {*polygon.shape})) entered.push_back(std::move(part));
    if (const double amount = area(entered); amount > kTouch_m2)
      out.push_back({rule::kSwaths,
                     fmt::format("the swath of {} works {:.6f} m² of {}", name_, amount, of_what),
                     place_on_largest(entered), amount});
  }

  void check_inside(const Ring& outer, Violations& out) const {
    Region beyond;
    for (std::size_t i = 0; i < core_.size(); ++i)
      if (!contains(outer, core_[i].outer.front()) || is_met(outer, boxes_[i]))
        for (Polygon& part : difference({core_[i]}, {{outer, {}}})) beyond.push_back(std::move(part));
    if (const double amount = area(beyond); amount > kTouch_m2)
      out.push_back({rule::kSwaths,
                     fmt::format("the swath of {} works {:.6f} m² beyond the hard boundary", name_, amount),
                     place_on_largest(beyond), amount});
  }

 private:
  static bool is_met(const Ring& ring, const Box& box) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (intersects(bounds(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]), box)) return true;
    }
    return false;
  }

  std::string name_;
  Region core_;
  std::vector<Box> boxes_;
};

void check_curved(const Case& c, std::size_t index, Violations& out) {
  const CurvedSwath swath(c, c.plan.pieces[index], piece_name(index));
  swath.check_clear(c.obstacles, "an obstacle", out);
  swath.check_clear(c.passables, "a passable obstacle", out);
  swath.check_clear(c.given_up, "land given up", out);
  if (boundary_is_hard(c.plan)) swath.check_inside(c.plan.field.outer, out);
}

}  // namespace

void check_line_within_field(const Case& c, const Lane& line, const std::string& name, Violations& out) {
  if (const auto place = line.place_pushed_outside(c.plan.field.outer))
    out.push_back({rule::kSwaths, name + " leaves the field", *place, 0});
  else
    check_within_boundary(c, line, name, out);
}

void check_swaths(const Case& c, Violations& out) {
  const double half = 0.5 * c.plan.machine.width_m;
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    if (!piece.curve.empty()) {
      check_curved(c, i, out);
      for (std::size_t k = 0; k < piece.detours.size(); ++k) {
        const Path& path = piece.detours[k].path;
        const Lane lane(PieceFrame(path.front().from, path.back().to), path, half);
        if (const auto place = lane.place_outside(c.plan.field.outer))
          out.push_back({rule::kSwaths, detour_name(i, k) + " leaves the field", *place, 0});
      }
      continue;
    }
    for (const PathSegment& part : straight_parts(piece)) check_straight_part(c, part, i, out);
    if (piece.detours.empty()) continue;
    const PieceFrame frame(piece);
    for (std::size_t k = 0; k < piece.detours.size(); ++k)
      check_detour(c, Lane(frame, piece.detours[k].path, half), detour_name(i, k), out);
  }
}

}  // namespace tramline::check
