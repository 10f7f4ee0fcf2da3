#include "tramline/cost/bound/undriven_rows.h"

#include <cmath>

#include "tramline/cost/bound/part_rows.h"
#include "tramline/cost/tolerances.h"
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

/// Sum of the parts' extents across per metre along.
double flatness(const PartRow& row) {
  double sum = 0;
  for (const BoundaryPart* part : row.parts)
    sum += std::abs((part->to.x - part->from.x) / (part->to.y - part->from.y));
  return sum;
}

/// The part of the rows too narrow to be driven wherever the boundary moves; nothing where to < from.
Interval barred_part(const PartRow& row, const RowBoundTerms& moving, const DrivenTerms& driven) {
  const double limit = driven.least_width_m - kWidthTolerance - most_shift(row.from, row.to, moving);
  if (std::min(row.inside_from, row.inside_to) >= limit) return {row.to, row.from};
  const Interval narrow = narrow_part(row, limit - 2 * driven.shear_m * flatness(row));
  // Nearer to its ends other parts may reach into the row.
  return {std::max(narrow.from, row.from + driven.shear_m), std::min(narrow.to, row.to - driven.shear_m)};
}

}  // namespace

void find_undriven_rows(std::span<const BoundaryWindow> run, const RowBoundTerms& moving,
                        const DrivenTerms& driven, Intervals& out) {
  out.clear();
  double drivable_from = run.front().lowest - driven.shear_m;
  const auto see = [&](const Interval& barred) {
    const bool too_short = barred.from - drivable_from < driven.shortest_m;
    append_joining(out, {too_short ? drivable_from : barred.from, barred.to});
    drivable_from = barred.to;
  };
  const std::span parts(run.front().parts.data(), run.back().parts.data() + run.back().parts.size());
  thread_local PartRows rows;
  rows.for_each(parts, moving.width_m, {}, [&](const PartRow& row) {
    const Interval barred = barred_part(row, moving, driven);
    if (barred.from < barred.to) see(barred);
  });
  const double end = run.back().highest + driven.shear_m;
  see({end, end});
}

}  // namespace tramline
