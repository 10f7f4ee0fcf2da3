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
#include "tramline/geometry/kinked_line.h"

namespace tramline::check {
namespace {

constexpr const char* kRule = "tally";

/// The land worked, and the tally it amounts to.
struct Worked {
  Region land;       ///< union of the swaths
  Region uncovered;  ///< body less that
  Tally tally;
};

/// How finely curved pieces are looked at: whole fields of arcs, which overlays of more chords would take
/// minutes for.
constexpr double kCurveSagitta_m = kLayerSagitta;

Region worked_ground(const Plan& plan) {
  Region out;
  for (const TrackPiece& piece : plan.pieces) {
    if (piece.curve.empty())
      append_ground(swath(piece, plan.machine.width_m), !piece.detours.empty(), out);
    else
      for (Polygon& part : bands_along(piece.curve, plan.machine.width_m, kCurveSagitta_m))
        out.push_back(std::move(part));
  }
  return out;
}

/// The same in parts that only touch, as finely as layers of land are drawn.
class WorkedParts {
 public:
  explicit WorkedParts(const Plan& plan) : width_m_(plan.machine.width_m), reach_m_(width_m_) {
    for (const TrackPiece& piece : plan.pieces) {
      if (has_kinks(piece.curve)) {
        reach_m_ = 2 * width_m_;  // a mitre reaches as far from its track as the swath is wide
        const Region cells = bands_along(piece.curve, width_m_);
        for (std::size_t i = 0; i < cells.size(); ++i) add(cells[i], {piece.curve[i]});
        continue;
      }
      for (const PathSegment& segment : piece.curve)
        for (Polygon& part : bands_along({segment}, width_m_, kLayerSagitta)) add(std::move(part), {segment});
      if (!piece.curve.empty()) continue;
      for (const PathSegment& part : straight_parts(piece)) add({part});
      for (const Detour& detour : piece.detours) add(detour.path);
    }
  }
  Region doubled() const { return doubled_ground(ground_, lines_, reach_m_); }

 private:
  void add(Polygon part, const Path& path) {
    ground_.push_back(std::move(part));
    lines_.push_back(path);
  }
  void add(const Path& path) {
    append_ground(band(path, width_m_, kLayerSagitta), std::isfinite(smallest_radius(path)), ground_);
    lines_.resize(ground_.size(), path);
  }

  double width_m_;
  double reach_m_;  ///< between two lines, beyond which their parts have nothing in common
  Region ground_;
  std::vector<Path> lines_;  ///< of each part of the ground
};

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
  const double covered = area(plan.body) - area(out.uncovered);
  tally.overlap_m2 = tally.worked_m2 - covered;
  tally.uncovered_m2 = area(plan.body) - covered;
  tally.pieces = static_cast<int>(plan.pieces.size());
  tally.turns = std::max(0, tally.pieces - 1 - tally.crossings);
  tally.stops = stops;
  return out;
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
  LayersOfLand(const Case& c, const Worked& found, Violations& out)
      : c_(c),
        found_(found),
        tolerance_m2_(c.area_tolerance_m2 + chord_tolerance_m2(c.plan, kLayerSagitta)),
        out_(out) {}

  void compare() {
    const Region uncovered = once(c_.plan.uncovered, "uncovered"), overlap = once(c_.plan.overlap, "overlap");
    report(symmetric_difference(uncovered, found_.uncovered), tolerance_m2_,
           "the layer uncovered differs from the body less the swaths");
    Region parts = WorkedParts(c_.plan).doubled();
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
