#include "tramline/cost/undriven_rows.h"

#include <cmath>

#include "tramline/cost/part_rows.h"
#include "tramline/tracks/end_rule.h"

namespace tramline {
namespace {

/// The part of some rows in which less than `limit` lies inside, each row's share changing evenly.
Interval narrow_part(const PartRow& row, double limit) {
  const double from = row.inside_from, to = row.inside_to;
  if (from >= limit && to >= limit) return {row.from, row.from};
  if (from < limit && to < limit) return {row.from, row.to};
  const double at = row.from + (row.to - row.from) * (limit - from) / (to - from);
  return from < limit ? Interval{row.from, at} : Interval{at, row.to};
}

/// Rows too narrow to be driven wherever the boundary moves.
Intervals barred_rows(std::span<const BoundaryPart> parts, const MovingTerms& moving,
                      const DrivenTerms& driven) {
  thread_local PartRows rows;
  Intervals out;
  rows.for_each(parts, moving.width_m, {}, [&](const PartRow& row) {
    double flat = 0;  // how far across the parts go for each metre along
    for (const BoundaryPart* part : row.parts)
      flat += std::abs((part->to.x - part->from.x) / (part->to.y - part->from.y));
    const double limit = driven.least_width_m - kWidthTolerance - most_shift(row.from, row.to, moving) -
                         2 * driven.shear_m * flat;
    Interval narrow = narrow_part(row, limit);
    // Nearer to its ends other parts may come into the row.
    narrow.from = std::max(narrow.from, row.from + driven.shear_m);
    narrow.to = std::min(narrow.to, row.to - driven.shear_m);
    if (narrow.from < narrow.to) append_joining(out, narrow);
  });
  return out;
}

}  // namespace

Intervals undriven_rows(std::span<const BoundaryWindow> run, const MovingTerms& moving,
                        const DrivenTerms& driven) {
  const std::span parts(run.front().parts.data(), run.back().parts.data() + run.back().parts.size());
  const Interval whole{run.front().lowest - driven.shear_m, run.back().highest + driven.shear_m};
  Intervals out;
  double drivable_from = whole.from;
  const auto see = [&](const Interval& barred) {
    const bool too_short = barred.from - drivable_from < driven.shortest_m;
    append_joining(out, {too_short ? drivable_from : barred.from, barred.to});
    drivable_from = barred.to;
  };
  for (const Interval& barred : barred_rows(parts, moving, driven)) see(barred);
  see({whole.to, whole.to});
  return out;
}

}  // namespace tramline
