#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tramline/check/bands.h"
#include "tramline/check/comparison.h"
#include "tramline/check/doubled_ground.h"
#include "tramline/check/rules.h"
#include "tramline/geometry/boolean.h"

namespace tramline::check {
namespace {

constexpr const char* kRule = "tally";

/// How finely curved pieces are looked at: whole fields of arcs, which overlays of more chords would take
/// minutes for.
constexpr double kCurveSagitta_m = kLayerSagitta;

/// What chords may take from the ground of arcs, or add to it. Of detours: the sagitta along both edges,
/// which together are twice as long as the path. Curved pieces lie side by side and share their edges; and
/// what a chord takes along the outer edge of a piece that lies alone the one along its inner edge adds.
/// Their detours may lie over them with either edge. The tally is that of the arcs.
double chord_tolerance_m2(const Plan& plan, double sagitta_m) {
  double detours_m = 0, curves_m = 0;
  for (const TrackPiece& piece : plan.pieces) {
    if (piece.curve.empty()) {
      detours_m += arcs_m(centre_line(piece));
      continue;
    }
    curves_m += arcs_m(piece.curve);
    for (const Detour& detour : piece.detours) curves_m += arcs_m(detour.path);
  }
  return sagitta_m * 2 * detours_m + kCurveSagitta_m * curves_m;
}

Tally recomputed(const Case& c, int stops) {
  Tally tally;
  for (const TrackPiece& piece : c.plan.pieces) {
    tally.track_length_m += length(piece);
    if (piece.after_crossing) ++tally.crossings;
  }
  tally.worked_m2 = c.plan.machine.width_m * tally.track_length_m;
  tally.overlap_m2 = tally.worked_m2 - c.worked.covered_m2;
  tally.uncovered_m2 = area(c.plan.body) - c.worked.covered_m2;
  tally.pieces = static_cast<int>(c.plan.pieces.size());
  tally.turns = std::max(0, tally.pieces - 1 - tally.crossings);
  tally.stops = stops;
  return tally;
}

/// Body that no swath works.
Region uncovered_land(const Case& c) {
  Region swaths;
  for (const WorkedPart& part : c.parts) swaths.insert(swaths.end(), part.ground.begin(), part.ground.end());
  return difference(c.plan.body, unite(swaths));
}

void compare_tallies(const Case& c, const Tally& found, double tolerance, Violations& out) {
  const Tally& stored = c.plan.tally;
  Comparison compare("the tracks", c.plan.field.outer.front(), out);
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
  LayersOfLand(const Case& c, Violations& out)
      : c_(c), tolerance_m2_(c.area_tolerance_m2 + chord_tolerance_m2(c.plan, kLayerSagitta)), out_(out) {}

  void compare() {
    const Region uncovered = once(c_.plan.uncovered, "uncovered"), overlap = once(c_.plan.overlap, "overlap");
    compare_uncovered(uncovered);
    Region parts = doubled_ground(parts_between_detours(c_.plan), c_.plan.machine.width_m);
    parts.insert(parts.end(), c_.worked.beyond.begin(), c_.worked.beyond.end());
    const Region twice = unite(parts);
    // What is too thin to be shown may be left out of the layer along all edges.
    const double thin_m2 = kThinnestShown_m * perimeter_m(twice);
    report(difference(twice, overlap), tolerance_m2_ + thin_m2,
           "the layer overlap falls short of what is worked twice or beyond the body");
    report(difference(overlap, twice), tolerance_m2_ + thin_m2,
           "the layer overlap goes beyond what is worked twice or beyond the body");
  }

 private:
  /// What two regions have one of is the sum of both less twice what they have in common. So the land itself,
  /// an overlay of all swaths, is only made to say where it differs.
  void compare_uncovered(const Region& layer) {
    const double left_m2 = area(c_.plan.body) - c_.worked.covered_m2;
    const double off_m2 = area(layer) + left_m2 - 2 * left_within_m2(layer, c_.plan.body, c_.parts);
    if (off_m2 <= tolerance_m2_) return;
    out_.push_back(
        {kRule, fmt::format("the layer uncovered differs from the body less the swaths by {:.3f} m²", off_m2),
         place_on_largest(symmetric_difference(layer, uncovered_land(c_))), off_m2});
  }

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
  double tolerance_m2_;
  Violations& out_;
};

}  // namespace

Tally check_tally(const Case& c, int stops, Violations& out) {
  const Tally found = recomputed(c, stops);
  compare_tallies(c, found, c.area_tolerance_m2 + chord_tolerance_m2(c.plan, kChordSagitta), out);
  LayersOfLand(c, out).compare();
  return found;
}

}  // namespace tramline::check
