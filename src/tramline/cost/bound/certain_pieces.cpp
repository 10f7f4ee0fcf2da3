#include "tramline/cost/bound/certain_pieces.h"

#include <algorithm>
#include <limits>

#include "tramline/cost/bound/joined_intervals.h"
#include "tramline/cost/tolerances.h"

namespace tramline {

/// Sets crossings_: the parts of the boundary in the sub-strip, from low to high.
void CertainPieces::list_crossings(std::span<const BoundaryWindow> windows, Interval across) {
  const auto [left, right] = across;
  const double middle = 0.5 * (left + right);
  const std::span parts(windows.front().parts.data(),
                        windows.back().parts.data() + windows.back().parts.size());
  crossings_.clear();
  for (const BoundaryPart& part : parts) {  // from low to high
    double low = part.from.y, high = part.to.y;
    if (std::max(part.from.x, part.to.x) < left || std::min(part.from.x, part.to.x) > right) continue;
    if (part.from.x != part.to.x) {
      const double slope = (high - low) / (part.to.x - part.from.x);
      low = part.from.y + slope * (std::clamp(part.from.x, left, right) - part.from.x);
      high = part.from.y + slope * (std::clamp(part.to.x, left, right) - part.from.x);
    }
    crossings_.push_back(
        {std::min(low, high), std::max(low, high), (part.from.x > middle) != (part.to.x > middle)});
  }
  std::sort(crossings_.begin(), crossings_.end(),
            [](const Crossing& a, const Crossing& b) { return a.lowest < b.lowest; });
}

/// Calls visit(from, to) for every stretch over which the sub-strip lies inside in the middle grid, until it
/// returns true, and returns whether it did.
template <class Visit>
bool CertainPieces::any_stretch(std::span<const BoundaryWindow> windows, Interval across,
                                const Visit& visit) {
  list_crossings(windows, across);
  bool inside = false;
  double free_from = -std::numeric_limits<double>::infinity();
  for (const Crossing& crossing : crossings_) {
    if (inside && visit(free_from, crossing.lowest)) return true;
    inside ^= crossing.passes_middle;
    free_from = std::max(free_from, crossing.highest);
  }
  return false;
}

/// Whether the sub-strip lies inside over a stretch as long as a piece and clear of obstacles.
bool CertainPieces::holds_piece(std::span<const BoundaryWindow> windows, Interval across,
                                const Intervals& blocked) {
  const double least_m = terms_.shortest_m + 2 * terms_.shear_m;
  return any_stretch(windows, across, [&](double from, double to) {
    if (to - from < least_m) return false;
    if (blocked.empty()) return true;
    const Intervals free = without({{from, to}}, blocked);
    return std::any_of(free.begin(), free.end(),
                       [least_m](const Interval& stretch) { return stretch.length() >= least_m; });
  });
}

bool CertainPieces::any_in(std::span<const BoundaryWindow> windows, const Intervals& blocked) {
  const double width_m = terms_.width_m, shift_m = terms_.shift_m;
  const auto lies_in = [&](double left, double right) {
    return holds_piece(windows, {left, right}, blocked);
  };
  if (lies_in(-shift_m, width_m + shift_m)) return true;
  if (terms_.rule.by_centre_line)
    return 2 * shift_m < width_m && lies_in(0.5 * width_m - shift_m, 0.5 * width_m + shift_m);
  const double least_m = terms_.least_width_m + shift_m;
  return least_m <= width_m && (lies_in(0, least_m) || lies_in(width_m - least_m, width_m));
}

/// Appends the stretches in which the sub-strip lies inside for certain.
void CertainPieces::append_stretches(std::span<const BoundaryWindow> windows, Interval across,
                                     Intervals& out) {
  any_stretch(windows, across, [&](double from, double to) {
    if (to - from > 2 * terms_.shear_m) out.push_back({from + terms_.shear_m, to - terms_.shear_m});
    return false;
  });
}

Intervals CertainPieces::rows_of(std::span<const BoundaryWindow> windows) {
  const double width_m = terms_.width_m, shift_m = terms_.shift_m;
  Intervals out;
  append_stretches(windows, {-shift_m, width_m + shift_m}, out);
  if (terms_.rule.by_centre_line) {
    if (2 * shift_m < width_m)
      append_stretches(windows, {0.5 * width_m - shift_m, 0.5 * width_m + shift_m}, out);
  } else if (const double least_m = terms_.least_width_m + shift_m + kWidthTolerance; least_m <= width_m) {
    append_stretches(windows, {0, least_m}, out);
    append_stretches(windows, {width_m - least_m, width_m}, out);
  }
  return joined(std::move(out));
}

}  // namespace tramline
