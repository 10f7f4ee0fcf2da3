#include <fmt/format.h>

#include <cmath>

#include "tramline/check/measure/bands.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The tolerance for the area of a swath due to chords and the grid.
double tolerance_m2(const TrackPiece& piece, double width_m) {
  const double length_m = length(piece);
  return kAreaShare * width_m * length_m + kThinnestShown_m * 2 * (length_m + width_m) +
         kLayerSagitta * 2 * arcs_m(centre_line(piece));
}

}  // namespace

void check_swath_overlaps(const Case& c, Violations& out) {
  const double width_m = c.plan.machine.width_m;
  double sum_m2 = 0;
  bool whole = true;
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    const double found_m2 = width_m * length(piece) - c.worked.useful_m2[i];
    if (piece.overlap_m2 && !(std::abs(*piece.overlap_m2 - found_m2) <= tolerance_m2(piece, width_m)))
      out.push_back({Rule::kSwathOverlap,
                     fmt::format("the swath of {} is said to overlap by {:.3f} m², its shape gives {:.3f} m²",
                                 piece_name(i), *piece.overlap_m2, found_m2),
                     midpoint(piece.start, piece.end), *piece.overlap_m2 - found_m2});
    whole = whole && piece.overlap_m2.has_value();
    sum_m2 += piece.overlap_m2.value_or(0);
  }
  const double off_m2 = sum_m2 - c.plan.track_tally.overlap_m2;
  if (whole && !(std::abs(off_m2) <= c.area_tolerance_m2))
    out.push_back({Rule::kSwathOverlap,
                   fmt::format("the swaths overlap by {:.3f} m² together, the plan by {:.3f} m²", sum_m2,
                               c.plan.track_tally.overlap_m2),
                   c.plan.field.outer.front(), off_m2});
}

}  // namespace tramline::check
