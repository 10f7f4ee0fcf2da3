#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/check/doubled_ground.h"
#include "tramline/check/rules.h"
#include "tramline/geometry/boolean.h"

namespace tramline::check {
namespace {

constexpr const char* kRule = "tally";

/// The land worked, and the tally it amounts to.
struct Worked {
  Region land;       ///< union of the swaths
  Region uncovered;  ///< body less that
  Tally tally;
};

/// Sums are rounded like any other: a comparison of sums allows for it.
double rounding_of(double value) { return 1e-9 * std::max(1.0, std::abs(value)); }

/// The ground of one piece or of a part of it. One whose path is too tight or has kinks folds over itself;
/// what it encloses counts.
void append_ground(Ring ring, bool may_fold, Region& out) {
  const Polygon ground{std::move(ring), {}};
  if (!may_fold || !find_invalidity(ground)) {
    out.push_back(ground);
    return;
  }
  for (Polygon& part : made_valid(ground)) out.push_back(std::move(part));
}

Region worked_ground(const Plan& plan) {
  Region out;
  for (const TrackPiece& piece : plan.pieces)
    append_ground(swath(piece, plan.machine.width_m), !piece.detours.empty(), out);
  return out;
}

/// The same in parts that only touch, as finely as layers of land are drawn.
Region worked_parts(const Plan& plan) {
  Region out;
  for (const TrackPiece& piece : plan.pieces)
    for (Ring& part : swath_parts(piece, plan.machine.width_m, kLayerSagitta))
      append_ground(std::move(part), !piece.detours.empty(), out);
  return out;
}

/// What chords may take from the ground of arcs, or add to it: the sagitta along both its edges, which
/// together are twice as long as the path. The tally is that of the arcs.
double chord_tolerance_m2(const Plan& plan, double sagitta_m) {
  double arcs_m = 0;
  for (const TrackPiece& piece : plan.pieces)
    for (const Detour& detour : piece.detours)
      for (const PathSegment& segment : detour.path)
        if (!segment.straight()) arcs_m += length(segment);
  return sagitta_m * 2 * arcs_m;
}

Worked recompute(const Plan& plan, int stops) {
  Worked out;
  out.land = unite(worked_ground(plan));
  out.uncovered = difference(plan.body, out.land);
  Tally& tally = out.tally;
  for (const TrackPiece& piece : plan.pieces) {
    tally.track_length_m += length(piece);
    if (piece.after_crossing) ++tally.crossings;
  }
  tally.worked_m2 = plan.machine.width_m * tally.track_length_m;
  const double covered = area(intersection(out.land, plan.body));
  tally.overlap_m2 = tally.worked_m2 - covered;
  tally.uncovered_m2 = area(plan.body) - covered;
  tally.pieces = static_cast<int>(plan.pieces.size());
  tally.turns = std::max(0, tally.pieces - 1 - tally.crossings);
  tally.stops = stops;
  return out;
}

class Comparison {
 public:
  Comparison(Point at, Violations& out) : at_(at), out_(out) {}
  void number(const char* what, const char* unit, double stored, double found, double tolerance) {
    // Written so that a stored NaN is a violation too.
    if (std::abs(stored - found) <= tolerance) return;
    out_.push_back({kRule,
                    fmt::format("the plan says {} {:.6f}{}, the tracks amount to {:.6f}{}", what, stored,
                                unit, found, unit),
                    at_, stored - found});
  }
  void count(const char* what, int stored, int found) {
    if (stored == found) return;
    out_.push_back({kRule, fmt::format("the plan counts {} {}, the tracks have {}", stored, what, found), at_,
                    static_cast<double>(stored - found)});
  }

 private:
  Point at_;
  Violations& out_;
};

void compare_tallies(const Case& c, const Tally& found, double tolerance, Violations& out) {
  const Tally& stored = c.plan.tally;
  Comparison compare(c.plan.field.outer.front(), out);
  compare.number("worked area", " m²", stored.worked_m2, found.worked_m2, tolerance);
  compare.number("overlap", " m²", stored.overlap_m2, found.overlap_m2, tolerance);
  compare.number("uncovered area", " m²", stored.uncovered_m2, found.uncovered_m2, tolerance);
  compare.number("track length", " m", stored.track_length_m, found.track_length_m,
                 rounding_of(found.track_length_m));
  compare.count("pieces", stored.pieces, found.pieces);
  compare.count("crossings", stored.crossings, found.crossings);
  compare.count("turns", stored.turns, found.turns);
  compare.count("stops", stored.stops, found.stops);
  // The tally is compared above, so the cost only has to follow from it.
  const double expected = cost(c.plan.objective, stored);
  compare.number("cost", "", c.plan.cost, expected, rounding_of(expected));
  // Σ w·L = body − u + o on the stored figures, whatever they are.
  compare.number("worked area, as body less uncovered plus overlap,", " m²",
                 area(c.plan.body) - stored.uncovered_m2 + stored.overlap_m2, found.worked_m2, tolerance);
}

/// The stored layers against the land that the swaths leave out, work twice or work beyond the body.
class LayersOfLand {
 public:
  LayersOfLand(const Case& c, const Worked& found, Violations& out)
      : c_(c),
        found_(found),
        tolerance_m2_(c.area_tolerance_m2 + chord_tolerance_m2(c.plan, kLayerSagitta)),
        out_(out) {}

  void compare() {
    const Region uncovered = once(c_.plan.uncovered, "uncovered"), overlap = once(c_.plan.overlap, "overlap");
    report(symmetric_difference(uncovered, found_.uncovered), tolerance_m2_,
           "the layer uncovered differs from the body less the swaths");
    Region parts = doubled_ground(worked_parts(c_.plan));
    for (Polygon& beyond : difference(found_.land, c_.plan.body)) parts.push_back(std::move(beyond));
    const Region twice = unite(parts);
    // What is too thin to be shown may be left out of the layer along all edges.
    const double thin_m2 = kThinnestShown_m * perimeter_m(twice);
    report(difference(twice, overlap), tolerance_m2_ + thin_m2,
           "the layer overlap falls short of what is worked twice or beyond the body");
    report(difference(overlap, twice), tolerance_m2_ + thin_m2,
           "the layer overlap goes beyond what is worked twice or beyond the body");
  }

 private:
  /// A layer as land. Its polygons must not lie over one another: their areas would not add up.
  Region once(const Region& layer, const char* name) {
    const Region repeated = doubled_ground(layer);
    if (repeated.empty()) return layer;
    if (const double amount = area(repeated); amount > tolerance_m2_)
      out_.push_back({kRule, fmt::format("the layer {} repeats itself by {:.3f} m²", name, amount),
                      place_on_largest(repeated), amount});
    return unite(layer);
  }

  void report(const Region& off, double tolerance_m2, const char* what) {
    const double amount = area(off);
    if (amount > tolerance_m2)
      out_.push_back({kRule, fmt::format("{} by {:.3f} m²", what, amount), place_on_largest(off), amount});
  }

  static double perimeter_m(const Region& region) {
    double sum = 0;
    for (const Ring& ring : rings_of(region)) sum += perimeter(ring);
    return sum;
  }

  const Case& c_;
  const Worked& found_;
  double tolerance_m2_;
  Violations& out_;
};

}  // namespace

Tally check_tally(const Case& c, int stops, Violations& out) {
  const Worked found = recompute(c.plan, stops);
  compare_tallies(c, found.tally, c.area_tolerance_m2 + chord_tolerance_m2(c.plan, kChordSagitta), out);
  LayersOfLand(c, found, out).compare();
  return found.tally;
}

}  // namespace tramline::check
