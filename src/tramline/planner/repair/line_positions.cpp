#include "tramline/planner/repair/line_positions.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/tolerances.h"
#include "tramline/planner/tolerances.h"
#include "tramline/tracks/strip_origin.h"

namespace tramline {
namespace {

/// Left edges of strips flush with either edge of the gap, and of rows of strips side by side from there or
/// about its middle.
void append_rows(const Box& gap, double width_m, std::vector<double>& out) {
  const double rows = std::max(1.0, std::ceil(gap.width() / width_m - kRounding_share));
  const double middle_m = 0.5 * (gap.min_x + gap.max_x);
  for (double k = 0; k < rows; ++k) {
    out.push_back(gap.min_x + k * width_m);
    out.push_back(gap.max_x - (k + 1) * width_m);
    out.push_back(middle_m + (k - 0.5 * rows) * width_m);
  }
}

/// Every eighth of a width, at the same positions whatever the gap.
void append_phases(const Box& gap, double width_m, std::vector<double>& out) {
  const double step_m = width_m / 8;
  for (double k = std::ceil((gap.min_x - width_m) / step_m); k * step_m < gap.max_x; ++k)
    out.push_back(k * step_m);
}

/// Flush with parallel edges that must not be crossed.
void append_flush(const Region& turned_free, const Box& gaps, double width_m, std::vector<double>& out) {
  for (const Ring& ring : rings_of(turned_free))
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      const bool parallel = std::abs(b.x - a.x) <= kParallelRadians * std::abs(b.y - a.y);
      const double x = 0.5 * (a.x + b.x);
      if (!parallel || std::abs(b.y - a.y) <= 0.25 * width_m || x < gaps.min_x - width_m ||
          x > gaps.max_x + width_m)
        continue;
      out.push_back(x);
      out.push_back(x - width_m);
    }
}

void keep_each_once(std::vector<double>& positions) {
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end(),
                              [](double a, double b) { return b - a < kSameStrip_m; }),
                  positions.end());
}

std::vector<double> places_in(std::size_t direction, const std::vector<std::size_t>& gaps,
                              const RepairGround& ground) {
  const double width_m = ground.terms().machine.width_m;
  const TrackFrame& frame = ground.frame(direction);
  std::vector<double> out;
  Box all;
  for (const std::size_t i : gaps) {
    const Box box = bounds(frame.to_track(ground.gap(i).outer));
    append_rows(box, width_m, out);
    append_phases(box, width_m, out);
    all.extend(box);
  }
  if (!gaps.empty()) append_flush(frame.to_track(ground.free()), all, width_m, out);
  keep_each_once(out);
  return out;
}

}  // namespace

std::vector<LinePosition> line_positions(const RepairGround& ground) {
  std::vector<LinePosition> out;
  for (std::size_t d = 0; d < ground.directions(); ++d)
    for (const double left_m : places_in(d, ground.gaps_in(d), ground)) out.push_back({d, left_m});
  return out;
}

std::vector<LinePosition> line_positions_over(std::size_t gap, const RepairGround& ground) {
  std::vector<LinePosition> out;
  for (std::size_t d = 0; d < ground.directions(); ++d) {
    const std::vector<std::size_t>& gaps = ground.gaps_in(d);
    if (!std::binary_search(gaps.begin(), gaps.end(), gap)) continue;
    for (const double left_m : places_in(d, {gap}, ground)) out.push_back({d, left_m});
  }
  return out;
}

}  // namespace tramline
