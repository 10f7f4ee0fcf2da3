#include "tramline/cost/bound/boundary_windows.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "tramline/cost/tolerances.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// The sums over a window's parts that show what they form.
void describe(BoundaryWindow& window, double width_m, double margin_m) {
  double across = 0, along = 0, total_along = 0;
  bool odd = false;
  window.least_slope = std::numeric_limits<double>::infinity();
  for (const BoundaryPart& part : window.parts) {
    const double dx = part.to.x - part.from.x, dy = part.to.y - part.from.y;
    across += dx;
    along += dy;
    window.across_m += std::abs(dx);
    total_along += std::abs(dy);
    odd ^= (part.from.x > 0.5 * width_m) != (part.to.x > 0.5 * width_m);
    if (dx == 0 && dy == 0) continue;
    const double slope = dx == 0 ? std::numeric_limits<double>::infinity() : std::abs(dy / dx);
    window.least_slope = std::min(window.least_slope, slope);
    window.most_slope = std::max(window.most_slope, slope);
  }
  const double whole = width_m + 2 * margin_m, rounding = kRounding_share * (whole + total_along);
  window.passes = std::abs(window.across_m - whole) <= rounding &&
                  std::abs(std::abs(across) - whole) <= rounding && total_along - std::abs(along) <= rounding;
  window.begins = across > 0;
  window.inside_after = odd;
}

}  // namespace

void gather_windows(std::span<BoundaryPart> parts, double width_m, double margin_m, double apart_m,
                    std::vector<BoundaryWindow>& out) {
  out.clear();
  std::sort(parts.begin(), parts.end(),
            [](const BoundaryPart& a, const BoundaryPart& b) { return a.lowest() < b.lowest(); });
  bool inside = false;
  for (std::size_t first = 0, last = 0; first < parts.size(); first = last) {
    BoundaryWindow window;
    window.lowest = parts[first].lowest();
    window.highest = parts[first].highest();
    for (last = first + 1; last < parts.size() && parts[last].lowest() - window.highest <= apart_m; ++last)
      window.highest = std::max(window.highest, parts[last].highest());
    window.parts = parts.subspan(first, last - first);
    describe(window, width_m, margin_m);
    inside ^= window.inside_after;
    window.inside_after = inside;
    out.push_back(window);
  }
}

double passage_cost(const BoundaryWindow& window, double width_m, double over_price, double under_price) {
  assert(window.passes);
  if (over_price + under_price <= 0) return 0;
  const double left_m = width_m * over_price / (over_price + under_price);
  double along = 0;
  for (const BoundaryPart& part : window.parts) along += part.to.y - part.from.y;
  const bool rises = window.begins ? along > 0 : along < 0;  // to the right
  const bool narrow_left = window.begins == rises;
  const double split = narrow_left ? left_m : width_m - left_m;
  double end = 0;
  for (const BoundaryPart& part : window.parts) {
    const double low = std::min(part.from.x, part.to.x), high = std::max(part.from.x, part.to.x);
    if (split < low || split > high) continue;
    end = low == high
              ? part.from.y
              : part.from.y + (part.to.y - part.from.y) * ((split - part.from.x) / (part.to.x - part.from.x));
    break;
  }
  double before = 0, beyond = 0;  // m² on either side of the split, between the passage and the end
  for (const BoundaryPart& part : window.parts) {
    if (part.from.x == part.to.x) continue;
    const double slope = (part.to.y - part.from.y) / (part.to.x - part.from.x);
    const auto area = [&](double from, double to) {
      from = std::max(from, std::min(part.from.x, part.to.x));
      to = std::min(to, std::max(part.from.x, part.to.x));
      if (from >= to) return 0.0;
      return std::abs(part.from.y + slope * (0.5 * (from + to) - part.from.x) - end) * (to - from);
    };
    before += area(0, split);
    beyond += area(split, width_m);
  }
  return narrow_left ? under_price * before + over_price * beyond
                     : over_price * before + under_price * beyond;
}

}  // namespace tramline
