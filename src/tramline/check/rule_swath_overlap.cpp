#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "tramline/check/bands.h"
#include "tramline/check/doubled_ground.h"
#include "tramline/check/path_distance.h"
#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/boolean.h"
#include "tramline/geometry/box_grid.h"
#include "tramline/geometry/convex_clip.h"
#include "tramline/geometry/kinked_line.h"

namespace tramline::check {
namespace {

constexpr const char* kRule = "swath overlap";

/// Ground worked along one line: a straight swath with its detours, or one segment of a curved one.
struct Part {
  std::size_t piece = 0;
  Path line;
  Region ground;
  bool kinked = false;  ///< one of the cells between kinks
};

/// All swaths, by piece.
std::vector<Part> parts_of(const Plan& plan) {
  std::vector<Part> out;
  const double width_m = plan.machine.width_m;
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    const TrackPiece& piece = plan.pieces[i];
    if (has_kinks(piece.curve)) {
      const Region cells = bands_along(piece.curve, width_m);
      for (std::size_t k = 0; k < cells.size(); ++k) out.push_back({i, {piece.curve[k]}, {cells[k]}, true});
      continue;
    }
    for (const PathSegment& segment : piece.curve)
      out.push_back({i, {segment}, bands_along({segment}, width_m, kLayerSagitta)});
    if (!piece.curve.empty()) continue;
    out.push_back({i, centre_line(piece), {}});
    append_ground(swath(piece, width_m), !piece.detours.empty(), out.back().ground);
  }
  return out;
}

/// What chords and grids may be off the area of a swath.
double tolerance_m2(const TrackPiece& piece, double width_m) {
  const double length_m = length(piece);
  return kAreaShare * width_m * length_m + kThinnestShown_m * 2 * (length_m + width_m) +
         kLayerSagitta * 2 * arcs_m(centre_line(piece));
}

/// The body, ready to be laid over one polygon after another.
class Body {
 public:
  explicit Body(const Region& body) : body_(body), rings_(rings_of(body)) {}

  /// What of the parts lies in it. Most are met by no edge, and need no overlay.
  Region of(const Region& parts) const {
    Region out;
    for (const Polygon& part : parts) {
      if (is_met(bounds(part))) {
        for (Polygon& inside : intersection({part}, body_)) out.push_back(std::move(inside));
      } else if (contains(body_, part.outer.front())) {
        out.push_back(part);
      }
    }
    return out;
  }

 private:
  bool is_met(const Box& box) const {
    for (const Ring& ring : rings_)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        Box edge;
        edge.extend(ring[i]);
        edge.extend(ring[i + 1 < ring.size() ? i + 1 : 0]);
        if (intersects(edge, box)) return true;
      }
    return false;
  }

  const Region& body_;
  std::vector<Ring> rings_;
};

/// May the two have ground in common? Cells between kinks are convex, and mostly lie side by side. Other
/// parts of one swath touch where one follows upon the other.
bool may_meet(const Part& earlier, const Part& later, bool next_to_each_other, double width_m) {
  if (earlier.kinked && later.kinked) {
    const Ring both = convex_intersection(earlier.ground.front().outer, later.ground.front().outer);
    return std::abs(signed_area(both)) > kThinnestShown_m * perimeter(both);
  }
  if (next_to_each_other && earlier.piece == later.piece) return false;
  const double reach_m = earlier.kinked || later.kinked ? 2 * width_m : width_m;  // mitres are longer
  return distance_between(earlier.line, later.line) < reach_m - kThinnestShown_m;
}

/// What of each piece's swath is body that neither it nor a piece before it has worked yet, m².
std::vector<double> useful_m2(const Plan& plan) {
  const Body body(plan.body);
  const std::vector<Part> parts = parts_of(plan);
  std::vector<Box> boxes;
  for (const Part& part : parts) boxes.push_back(bounds(part.ground));
  const BoxGrid index(boxes);
  std::vector<double> out(plan.pieces.size(), 0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Region useful = body.of(parts[i].ground);
    Region before;
    index.each_meeting(boxes[i], [&](std::size_t k) {
      if (k < i && may_meet(parts[k], parts[i], k + 1 == i, plan.machine.width_m))
        before.insert(before.end(), parts[k].ground.begin(), parts[k].ground.end());
    });
    if (!before.empty()) useful = difference(unite(useful), unite(before));
    out[parts[i].piece] += area(useful);
  }
  return out;
}

}  // namespace

void check_swath_overlaps(const Case& c, Violations& out) {
  const double width_m = c.plan.machine.width_m;
  const std::vector<double> useful = useful_m2(c.plan);
  double sum_m2 = 0;
  bool whole = true;
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    const double found_m2 = width_m * length(piece) - useful[i];
    if (piece.overlap_m2 && !(std::abs(*piece.overlap_m2 - found_m2) <= tolerance_m2(piece, width_m)))
      out.push_back({kRule,
                     fmt::format("the swath of {} is said to overlap by {:.3f} m², its shape gives {:.3f} m²",
                                 piece_name(i), *piece.overlap_m2, found_m2),
                     midpoint(piece.start, piece.end), *piece.overlap_m2 - found_m2});
    whole = whole && piece.overlap_m2.has_value();
    sum_m2 += piece.overlap_m2.value_or(0);
  }
  const double off_m2 = sum_m2 - c.plan.tally.overlap_m2;
  if (whole && !(std::abs(off_m2) <= c.area_tolerance_m2))
    out.push_back({kRule,
                   fmt::format("the swaths overlap by {:.3f} m² together, the plan by {:.3f} m²", sum_m2,
                               c.plan.tally.overlap_m2),
                   c.plan.field.outer.front(), off_m2});
}

}  // namespace tramline::check
