#include "tramline/cost/cost_causes.h"

#include <algorithm>

#include "tramline/cost/tolerances.h"
#include "tramline/cost/worked/border_overrun.h"
#include "tramline/cost/worked/detour_cover.h"
#include "tramline/cost/worked/worked_ground.h"

namespace tramline {
namespace {

using Parts = std::array<CausePart, kCauseCount>;

CausePart& part(Parts& parts, Cause cause) { return parts[static_cast<std::size_t>(cause)]; }

double area_over(const StripProfile& profile, const Intervals& rows) {
  double sum = 0;
  for (const Interval& stretch : rows) sum += area_between(profile, stretch.from, stretch.to);
  return sum;
}

double length_of(const Intervals& rows) {
  double sum = 0;
  for (const Interval& stretch : rows) sum += stretch.length();
  return sum;
}

/// The stretches in which a boundary passes through a strip from full rows to empty ones.
Intervals passages(const StripProfile& subfield, double width_m) {
  const Intervals full = where_at_least(subfield, width_m - kWidthTolerance);
  const auto begins_full = [&](double at) {
    return std::any_of(full.begin(), full.end(), [at](const Interval& part) { return part.from == at; });
  };
  const auto ends_full = [&](double at) {
    return std::any_of(full.begin(), full.end(), [at](const Interval& part) { return part.to == at; });
  };
  Intervals out;
  for (const Interval& partly : without(where_at_least(subfield, kWidthTolerance), full))
    if (ends_full(partly.from) != begins_full(partly.to) && partly.length() <= kLongestRowEnd * width_m)
      out.push_back(partly);
  return out;
}

/// The rows of one strip by what happens in them.
struct StripRows {
  Intervals driven;  ///< straight
  Intervals in_detours;
  Intervals in_short_pieces;
};

std::vector<StripRows> rows_by_strip(const TrackFamily& family, const LaidTracks& tracks) {
  std::vector<StripRows> out(family.tracks.size());
  const auto rows_of = [&](const LaidPiece& piece) -> StripRows& {
    return out[static_cast<std::size_t>(piece.track - family.tracks.front().index)];
  };
  for (const LaidPiece& piece : tracks.pieces) {
    StripRows& rows = rows_of(piece);
    for (const Interval& straight : parts_on_track(piece)) rows.driven.push_back(straight);
    for (const TrackDetour& detour : piece.detours) rows.in_detours.push_back({detour.from, detour.to});
  }
  for (const LaidPiece& piece : tracks.dropped)
    rows_of(piece).in_short_pieces.push_back({piece.from, piece.to});
  return out;
}

/// One subfield in the plane of its grid.
class SubfieldAccount {
 public:
  SubfieldAccount(const LaidPlan& plan, std::size_t subfield, const WorkedGround& worked)
      : subfield_(subfield), family_(plan.families[subfield]), worked_(worked) {
    const TrackFrame& frame = family_.grid.frame;
    shape_ = rings_of(frame.to_track(Region{plan.subfields[subfield].shape}));
    passable_ = rings_of(frame.to_track(plan.passable));
    if (family_.tracks.empty()) return;
    Region others;
    for (std::size_t i = 0; i < plan.subfields.size(); ++i)
      if (i != subfield) others.push_back(plan.subfields[i].shape);
    others_ = cross_sections(frame.to_track(others), family_.grid,
                             {family_.tracks.front().index, family_.tracks.back().index});
    rows_ = rows_by_strip(family_, plan.tracks[subfield]);
  }

  void add_to(Parts& parts) const {
    for (std::size_t i = 0; i < family_.tracks.size(); ++i) {
      add_overlap(i, parts);
      add_uncovered(i, parts);
    }
  }

 private:
  /// The area that straight swaths work outside the subfield; all of it within others.
  void add_overlap(std::size_t i, Parts& parts) const {
    const StripProfile &own = family_.tracks[i].subfield.straight(), &others = others_[i];
    const Intervals& driven = rows_[i].driven;
    const auto beyond = [&](const Intervals& rows) {
      return family_.grid.width_m * length_of(rows) - area_over(own, rows) - area_over(others, rows);
    };
    const Intervals ends = passages(own, family_.grid.width_m);
    part(parts, Cause::kRowEnds).overlap_m2 += beyond(common(driven, ends));
    part(parts, Cause::kSides).overlap_m2 += beyond(without(driven, ends));
    part(parts, Cause::kSeams).overlap_m2 += area_over(others, driven);
  }

  void add_uncovered(std::size_t i, Parts& parts) const {
    const Track& strip = family_.tracks[i];
    if (strip.subfield.empty()) return;
    const StripProfile& profile = strip.subfield.straight();
    Intervals left = without({{profile.slabs.front().from, profile.slabs.back().to}}, rows_[i].driven);
    const auto take = [&](Cause cause, const Intervals& rows) {
      part(parts, cause).uncovered_m2 += bare_m2(strip, common(left, rows));
      left = without(left, rows);
    };
    take(Cause::kDetours, rows_[i].in_detours);
    take(Cause::kStops, strip.hard_stretches);
    take(Cause::kShortPieces, rows_[i].in_short_pieces);
    take(Cause::kRowEnds, strip.passable_stretches);
    take(Cause::kSeams, where_at_least(others_[i], kWidthTolerance));
    take(Cause::kRowEnds, passages(profile, family_.grid.width_m));
    part(parts, Cause::kSides).uncovered_m2 += bare_m2(strip, left);
  }

  /// The area of the subfield in these rows of a strip that no swath covers, passable obstacles apart.
  double bare_m2(const Track& strip, const Intervals& rows) const {
    double sum = 0;
    for (const Interval& stretch : rows) {
      if (strip.subfield.area_between(stretch.from, stretch.to) == 0) continue;
      const Box box = swath_box(family_.grid, strip, stretch);
      RisingCurves curves;
      for (const Ring& ring : shape_) append_ring(ring, Layer::kBody, box, curves);
      for (const Ring& ring : passable_) append_ring(ring, Layer::kCovered, box, curves);
      worked_.append_covered(subfield_, box, {box}, {}, curves);
      append_box(box, Layer::kNew, box, curves);
      sum += newly_covered_area(curves);
    }
    return sum;
  }

  std::size_t subfield_;
  const TrackFamily& family_;
  const WorkedGround& worked_;
  std::vector<Ring> shape_, passable_;
  std::vector<StripProfile> others_;  ///< the other subfields, by strip
  std::vector<StripRows> rows_;       ///< by strip
};

double worked_by_detours_m2(const std::vector<LaidTracks>& tracks) {
  double sum = 0;
  for (const LaidTracks& subfield : tracks)
    for (const LaidPiece& piece : subfield.pieces)
      for (const TrackDetour& detour : piece.detours) sum += subfield.grid.width_m * detour.length_m;
  return sum;
}

/// Differences of areas that ought to be equal count as 0, of either sign.
double without_rounding(double area_m2) { return area_m2 < kNoDifference_m2 ? 0 : area_m2; }

Parts parts_by_cause(const LaidPlan& plan) {
  Parts parts{};
  const WorkedGround worked = worked_by(plan.families, plan.tracks);
  for (std::size_t i = 0; i < plan.subfields.size(); ++i) SubfieldAccount(plan, i, worked).add_to(parts);
  part(parts, Cause::kSeams).overlap_m2 -= covered_by_neighbours_m2(plan.subfields, plan.tracks);
  part(parts, Cause::kDetours).overlap_m2 =
      worked_by_detours_m2(plan.tracks) - covered_by_detours_m2(plan.body, plan.families, plan.tracks);
  part(parts, Cause::kGivenUp).uncovered_m2 = area(plan.given_up);
  part(parts, Cause::kTurns).count = plan.tally.turns;
  part(parts, Cause::kStops).count = plan.tally.stops;
  part(parts, Cause::kSubfields).count = further_subfields(plan.tally);
  for (CausePart& each : parts) {
    each.overlap_m2 = without_rounding(each.overlap_m2);
    each.uncovered_m2 = without_rounding(each.uncovered_m2);
  }
  return parts;
}

/// Makes the parts sum to the tally's area by changing the largest of them. Returns what was missing.
double sum_to(Parts& parts, double CausePart::*area_m2, double tally_m2) {
  double missing_m2 = tally_m2;
  CausePart* largest = &parts.front();
  for (CausePart& each : parts) {
    missing_m2 -= each.*area_m2;
    if (each.*area_m2 > largest->*area_m2) largest = &each;
  }
  largest->*area_m2 += missing_m2;
  return missing_m2;
}

}  // namespace

CostCauses causes_of(const LaidPlan& plan, const Objective& objective) {
  CostCauses out{parts_by_cause(plan), 0, 0};
  out.overlap_rounding_m2 = sum_to(out.parts, &CausePart::overlap_m2, plan.tally.overlap_m2);
  out.uncovered_rounding_m2 = sum_to(out.parts, &CausePart::uncovered_m2, plan.tally.uncovered_m2);
  for (CausePart& each : out.parts)
    each.cost = objective.overlap * each.overlap_m2 + objective.uncovered * each.uncovered_m2;
  part(out.parts, Cause::kTurns).cost += objective.turn * plan.tally.turns;
  part(out.parts, Cause::kStops).cost += objective.stop * plan.tally.stops;
  part(out.parts, Cause::kSubfields).cost += objective.subfield * further_subfields(plan.tally);
  return out;
}

}  // namespace tramline
