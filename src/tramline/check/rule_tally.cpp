#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
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

/// Of passes: the same, along both edges.
double pass_arcs_m(const Case& c) {
  double sum = 0;
  if (c.with_passes)
    for (const HeadlandPass& pass : c.plan.headland.passes) sum += arcs_m(pass.path);
  return sum;
}

int worked_subfields(const Plan& plan) {
  std::set<int> worked;
  for (const TrackPiece& piece : plan.pieces) worked.insert(piece.subfield);
  return is_repair(plan) ? std::min<int>(1, static_cast<int>(worked.size()))
                         : static_cast<int>(worked.size());
}

Tally recomputed(const Case& c, int stops) {
  Tally tally;
  for (const TrackPiece& piece : c.plan.pieces) {
    tally.track_length_m += length(piece);
    if (piece.after_crossing) ++tally.crossings;
  }
  tally.worked_m2 =
      c.plan.machine.width_m * tally.track_length_m + (c.with_passes ? c.with_passes->passes_m2 : 0);
  tally.overlap_m2 = tally.worked_m2 - counted_work(c).covered_m2;
  tally.uncovered_m2 = area(counted_land(c)) - counted_work(c).covered_m2;
  tally.pieces = static_cast<int>(c.plan.pieces.size());
  tally.subfields = worked_subfields(c.plan);
  tally.turns = std::max(0, tally.pieces - 1 - tally.crossings);
  tally.stops = stops;
  return tally;
}

/// Land that nothing works.
Region uncovered_land(const Case& c) {
  Region swaths;
  for (const WorkedPart& part : counted_parts(c))
    swaths.insert(swaths.end(), part.ground.begin(), part.ground.end());
  return difference(counted_land(c), unite(swaths));
}

void compare_tallies(const Case& c, const Tally& found, double tolerance, Violations& out) {
  const Tally& stored = c.plan.tally;
  Comparison compare(c.with_passes ? "the tracks and headland passes" : "the tracks",
                     c.plan.field.outer.front(), out);
  compare.number("worked area", " m²", stored.worked_m2, found.worked_m2, tolerance);
  compare.number("overlap", " m²", stored.overlap_m2, found.overlap_m2, tolerance);
  compare.number("uncovered area", " m²", stored.uncovered_m2, found.uncovered_m2, tolerance);
  compare.number("track length", " m", stored.track_length_m, found.track_length_m,
                 rounding_of(found.track_length_m));
  compare.count("pieces", stored.pieces, found.pieces);
  compare.count("crossings", stored.crossings, found.crossings);
  compare.count("turns", stored.turns, found.turns);
  compare.count("stops", stored.stops, found.stops);
  if (c.plan.figures == PlanFigures::kTracksAndPasses)
    compare.count("subfields", stored.subfields, found.subfields);
  // The tally is compared above, so the cost only has to follow from it.
  const double expected = cost(c.plan.objective, stored);
  compare.number("cost", "", c.plan.cost, expected, rounding_of(expected));
  // Σ w·L = land − u + o on the stored figures, whatever they are.
  compare.number("worked area, as land less uncovered plus overlap,", " m²",
                 area(counted_land(c)) - stored.uncovered_m2 + stored.overlap_m2, found.worked_m2, tolerance);
}

/// The areas of the tracks alone; counts and lengths are the same.
Tally of_tracks_alone(const Case& c, Tally whole) {
  whole.worked_m2 = c.plan.machine.width_m * whole.track_length_m;
  whole.overlap_m2 = whole.worked_m2 - c.worked.covered_m2;
  whole.uncovered_m2 = area(c.plan.body) - c.worked.covered_m2;
  return whole;
}

void compare_track_areas(const Case& c, const Tally& found, double tolerance, Violations& out) {
  const Tally& stored = c.plan.track_tally;
  Comparison compare("the tracks alone", c.plan.field.outer.front(), out);
  compare.number("worked area of the tracks", " m²", stored.worked_m2, found.worked_m2, tolerance);
  compare.number("overlap of the tracks", " m²", stored.overlap_m2, found.overlap_m2, tolerance);
  compare.number("uncovered area of the body", " m²", stored.uncovered_m2, found.uncovered_m2, tolerance);
}

/// The stored layers against the land that the swaths leave out, work twice or work beyond the body.
class LayersOfLand {
 public:
  LayersOfLand(const Case& c, Violations& out)
      : c_(c),
        tolerance_m2_(c.area_tolerance_m2 + chord_tolerance_m2(c.plan, kLayerSagitta) +
                      kLayerSagitta * 2 * pass_arcs_m(c)),
        out_(out) {}

  void compare() {
    const Region uncovered = once(c_.plan.uncovered, "uncovered"), overlap = once(c_.plan.overlap, "overlap");
    compare_uncovered(uncovered);
    std::vector<WorkedPart> all = parts_between_detours(c_.plan);
    if (c_.with_passes)
      for (WorkedPart& part : pass_parts(c_.plan)) all.push_back(std::move(part));
    Region parts = doubled_ground(all, c_.plan.machine.width_m);
    const Region& beyond = counted_work(c_).beyond;
    parts.insert(parts.end(), beyond.begin(), beyond.end());
    const Region twice = unite(parts);
    // What is too thin to be shown may be left out of the layer along all edges.
    const double thin_m2 = kThinnestShown_m * perimeter_m(twice);
    report(difference(twice, overlap), tolerance_m2_ + thin_m2,
           "the layer overlap falls short of what is worked twice or beyond the land");
    report(difference(overlap, twice), tolerance_m2_ + thin_m2,
           "the layer overlap goes beyond what is worked twice or beyond the land");
  }

 private:
  /// What two regions have one of is the sum of both less twice what they have in common. So the land itself,
  /// an overlay of all swaths, is only made to say where it differs.
  void compare_uncovered(const Region& layer) {
    const double left_m2 = area(counted_land(c_)) - counted_work(c_).covered_m2;
    const double off_m2 =
        area(layer) + left_m2 - 2 * left_within_m2(layer, counted_land(c_), counted_parts(c_));
    if (off_m2 <= tolerance_m2_) return;
    out_.push_back(
        {kRule, fmt::format("the layer uncovered differs from the land less the swaths by {:.3f} m²", off_m2),
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

Tallies check_tally(const Case& c, int stops, Violations& out) {
  const Tally whole = recomputed(c, stops), tracks = of_tracks_alone(c, whole);
  const double of_tracks_m2 = c.area_tolerance_m2 + chord_tolerance_m2(c.plan, kChordSagitta);
  compare_tallies(c, whole, of_tracks_m2 + kChordSagitta * 2 * pass_arcs_m(c), out);
  compare_track_areas(c, tracks, of_tracks_m2, out);
  LayersOfLand(c, out).compare();
  return {whole, tracks};
}

}  // namespace tramline::check
