#include "tramline/cost/bound/pooled_land.h"

#include <algorithm>
#include <utility>

#include "tramline/cost/bound/joined_intervals.h"
#include "tramline/cost/bound/part_rows.h"

namespace tramline {
namespace {

/// Rows that parts of the boundary pass.
void subtract_row(const PartRow& row, const RowBoundTerms& moving, RowBounds& from) {
  const double over = moving.over_price, width_m = moving.width_m;
  const double length = row.to - row.from, shift = most_shift(row.from, row.to, moving);
  const double middle = 0.5 * (row.inside_from + row.inside_to);
  from.apart -= over * length * std::min(width_m, middle + shift);
  const bool alone = row.parts.size() == 1;
  const int sense = alone && rises(*row.parts.front()) ? 1 : -1;
  const auto [low, high] = std::minmax(row.inside_from, row.inside_to);
  if (!alone || low <= shift || high >= width_m) {
    from.together.constant -= over * length * std::min(width_m, middle + shift);
    return;
  }
  from.together -= {over * length * middle, over * sense * length,
                    over * sense * length * (0.5 * (row.from + row.to) - moving.pivot_along)};
}

}  // namespace

bool reaches_between(const Intervals& zones, double low, double high) {
  return std::any_of(zones.begin(), zones.end(),
                     [&](const Interval& zone) { return zone.from < high && low < zone.to; });
}

Intervals pooled_rows(const std::vector<BoundaryWindow>& windows, const Intervals& zones, double shear_m) {
  Intervals all = zones;
  for (const BoundaryWindow& window : windows)
    if (reaches_between(zones, window.lowest, window.highest))
      all.push_back({window.lowest - shear_m, window.highest + shear_m});
  return joined(std::move(all));
}

void subtract_land(const std::vector<BoundaryWindow>& windows, const Intervals& zones,
                   const Intervals& pooled, const RowBoundTerms& moving, RowBounds& from) {
  const double over = moving.over_price, width_m = moving.width_m;
  const auto subtract = [&](double land_m2) {
    from.apart -= over * land_m2;
    from.together.constant -= over * land_m2;
  };
  thread_local PartRows rows;
  bool inside = false;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const BoundaryWindow& window = windows[i];
    if (reaches_between(zones, window.lowest, window.highest)) {
      double at = window.lowest;
      rows.for_each(window.parts, width_m, {}, [&](const PartRow& row) {
        if (row.from > at) subtract(width_m * (row.from - at));
        at = row.to;
        subtract_row(row, moving, from);
      });
      if (window.highest > at) subtract(width_m * (window.highest - at));
    }
    inside = window.inside_after;
    if (!inside || i + 1 >= windows.size()) continue;
    for (const Interval& full : common({{window.highest, windows[i + 1].lowest}}, pooled))
      subtract(width_m * full.length());
  }
}

}  // namespace tramline
