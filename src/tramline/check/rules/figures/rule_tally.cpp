#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/comparison.h"
#include "tramline/check/measure/overlay_cells.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The sagitta for curved pieces: whole fields of arcs, for which overlays with more chords would take
/// minutes.
constexpr double kCurveSagitta_m = kLayerSagitta;

/// The possible difference in area between chords and arcs. For detours: the sagitta along both edges, which
/// together are twice as long as the path. Curved pieces lie side by side and share their edges; and the area
/// lost by a chord along the outer edge of an isolated piece is gained by the one along its inner edge. Their
/// detours may lie over them with either edge. The tally is that of the arcs.
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

/// For passes the same, along both edges.
double pass_arcs_m(const Case& c) {
  double sum = 0;
  if (c.with_passes)
    for (const HeadlandPass& pass : c.plan.headland.passes) sum += arcs_m(pass.path);
  return sum;
}

int worked_subfields(const Plan& plan) {
  std::set<std::size_t> worked;
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

/// Land in cells, by the shapes that cover it.
enum TalliedShape : std::size_t { kLand, kLayer, kFirstPart };

/// An area of land, and the middle of its largest cell.
class Amount {
 public:
  void add(const OverlayCell& cell) {
    sum_m2_ += cell.area_m2;
    if (cell.area_m2 <= largest_m2_) return;
    largest_m2_ = cell.area_m2;
    at_ = cell.middle;
  }
  double m2() const { return sum_m2_; }
  Point at() const { return at_; }

 private:
  double sum_m2_ = 0, largest_m2_ = 0;
  Point at_;
};

/// Compares the stored layers with the land that the swaths leave uncovered, work twice or work beyond the
/// body.
class LayersOfLand {
 public:
  LayersOfLand(const Case& c, Violations& out)
      : c_(c),
        parts_(parts_between_detours(c.plan)),
        tolerance_m2_(c.area_tolerance_m2 + chord_tolerance_m2(c.plan, kLayerSagitta) +
                      kLayerSagitta * 2 * pass_arcs_m(c)),
        out_(out) {
    if (!c.with_passes) return;
    for (WorkedPart& part : pass_parts(c.plan, kLayerSagitta)) parts_.push_back(std::move(part));
  }

  void compare() {
    look_at_uncovered();
    look_at_overlap();
    report(overlap_repeats_, tolerance_m2_, "the layer overlap repeats itself");
    report(uncovered_repeats_, tolerance_m2_, "the layer uncovered repeats itself");
    report(uncovered_off_, tolerance_m2_, "the layer uncovered differs from the land less the swaths");
    // Land too thin to be shown may be missing in the layer along all its edges.
    const double thin_m2 = kThinnestShown_m * perimeter_m(c_.plan.overlap);
    report(overlap_lacks_, tolerance_m2_ + thin_m2,
           "the layer overlap falls short of what is worked twice or beyond the land");
    report(overlap_exceeds_, tolerance_m2_ + thin_m2,
           "the layer overlap goes beyond what is worked twice or beyond the land");
  }

 private:
  void look_at_uncovered() {
    OverlayEdges overlay;
    overlay.add(counted_land(c_), kLand);
    overlay.add(c_.plan.uncovered, kLayer);
    for (const WorkedPart& part : counted_parts(c_)) overlay.add(part.ground, kFirstPart);
    each_cell(overlay, [this](const OverlayCell& cell) {
      const Cover& last = cell.covers.back();
      const bool land = cell.covers.front().shape == kLand, worked = last.shape == kFirstPart;
      int times = 0;
      for (const Cover& cover : cell.covers)
        if (cover.shape == kLayer) times = cover.times;
      if (times > 1) uncovered_repeats_.add(cell);
      if ((times > 0) != (land && !worked)) uncovered_off_.add(cell);
    });
  }

  void look_at_overlap() {
    OverlayEdges overlay;
    overlay.add(counted_land(c_), kLand);
    overlay.add(c_.plan.overlap, kLayer);
    for (std::size_t i = 0; i < parts_.size(); ++i) overlay.add(parts_[i].ground, kFirstPart + i);
    each_cell(overlay, [this](const OverlayCell& cell) {
      int times = 0;
      bool land = false, twice = false;
      const Cover* first = nullptr;
      for (const Cover& cover : cell.covers) {
        if (cover.shape == kLand) land = true;
        if (cover.shape == kLayer) times = cover.times;
        if (cover.shape < kFirstPart) continue;
        twice = twice || (first != nullptr && !follow_one_another(*first, cover));
        if (first == nullptr) first = &cover;
      }
      const bool over = twice || (first != nullptr && !land);
      if (times > 1) overlap_repeats_.add(cell);
      if (over && times == 0) overlap_lacks_.add(cell);
      if (!over && times > 0) overlap_exceeds_.add(cell);
    });
  }

  /// Whether may_meet() rules out an overlap of two parts of one swath.
  bool follow_one_another(const Cover& a, const Cover& b) const {
    const WorkedPart &one = parts_[a.shape - kFirstPart], &other = parts_[b.shape - kFirstPart];
    return one.piece == other.piece && !may_meet(one, other, c_.plan.machine.width_m);
  }

  void report(const Amount& off, double tolerance_m2, const char* what) {
    if (off.m2() > tolerance_m2)
      out_.push_back({Rule::kTally, fmt::format("{} by {:.3f} m²", what, off.m2()), off.at(), off.m2()});
  }

  static double perimeter_m(const Region& region) {
    double sum = 0;
    for (const Ring& ring : rings_of(region)) sum += perimeter(ring);
    return sum;
  }

  const Case& c_;
  std::vector<WorkedPart> parts_;
  double tolerance_m2_;
  Amount overlap_repeats_, uncovered_repeats_, uncovered_off_, overlap_lacks_, overlap_exceeds_;
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
