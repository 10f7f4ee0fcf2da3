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

namespace tramline::check {
namespace {

constexpr const char* kRule = "swath overlap";

/// A swath as polygons that only touch, and how far chords may be off its area.
struct SwathGround {
  Path line;
  Region parts;
  Box box;
  double area_m2 = 0;
  double tolerance_m2 = 0;
};

SwathGround ground_of(const TrackPiece& piece, double width_m) {
  SwathGround out;
  out.line = centre_line(piece);
  if (piece.curve.empty())
    append_ground(swath(piece, width_m), !piece.detours.empty(), out.parts);
  else
    out.parts = bands_along(piece.curve, width_m, kLayerSagitta);
  out.box = bounds(out.parts);
  const double length_m = length(piece);
  out.area_m2 = width_m * length_m;
  out.tolerance_m2 = kAreaShare * out.area_m2 + kThinnestShown_m * 2 * (length_m + width_m) +
                     kLayerSagitta * 2 * arcs_m(out.line);
  return out;
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

}  // namespace

void check_swath_overlaps(const Case& c, Violations& out) {
  const double width_m = c.plan.machine.width_m;
  const Body body(c.plan.body);
  std::vector<SwathGround> before;
  double sum_m2 = 0;
  bool whole = true;
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    SwathGround own = ground_of(piece, width_m);
    Region useful = body.of(own.parts);
    for (const SwathGround& other : before)
      if (intersects(other.box, own.box) &&
          distance_between(other.line, own.line) < width_m - kThinnestShown_m)
        useful = difference(unite(useful), unite(other.parts));
    const double found_m2 = own.area_m2 - area(useful);
    if (piece.overlap_m2 && !(std::abs(*piece.overlap_m2 - found_m2) <= own.tolerance_m2))
      out.push_back({kRule,
                     fmt::format("the swath of {} is said to overlap by {:.3f} m², its shape gives {:.3f} m²",
                                 piece_name(i), *piece.overlap_m2, found_m2),
                     midpoint(piece.start, piece.end), *piece.overlap_m2 - found_m2});
    whole = whole && piece.overlap_m2.has_value();
    sum_m2 += piece.overlap_m2.value_or(0);
    before.push_back(std::move(own));
  }
  const double off_m2 = sum_m2 - c.plan.tally.overlap_m2;
  if (whole && !(std::abs(off_m2) <= c.area_tolerance_m2))
    out.push_back({kRule,
                   fmt::format("the swaths overlap by {:.3f} m² together, the plan by {:.3f} m²", sum_m2,
                               c.plan.tally.overlap_m2),
                   c.plan.field.outer.front(), off_m2});
}

}  // namespace tramline::check
