#include "tramline/admission/remove_spikes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/admission/tolerances.h"

namespace tramline {
namespace {

/// Edges a-tip and tip-b fold onto each other: the nearer of a and b lies on the other edge.
bool is_spike(Point a, Point tip, Point b) {
  const Point back = a - tip, on = b - tip;
  if (dot(back, on) <= 0) return false;
  const double longer = std::max(length(back), length(on)), shorter = std::min(length(back), length(on));
  if (longer <= 0) return false;
  const double width = std::abs(cross(back, on)) / longer;
  // The second test keeps needle-sharp corners whose sides are short but distinct.
  return width <= kSamePlace_m && shorter > 0;
}

}  // namespace

void remove_spikes(WorkRing& ring, RepairLog& repair_log) {
  std::size_t since_last = 0, i = 0;
  while (ring.points.size() >= 3 && since_last < ring.points.size()) {
    const std::size_t n = ring.points.size();
    i %= n;
    const Point before = ring.points[(i + n - 1) % n], tip = ring.points[i], after = ring.points[(i + 1) % n];
    if (!is_spike(before, tip, after)) {
      ++i;
      ++since_last;
      continue;
    }
    repair_log.repair(fmt::format("{} had a spike without width {:.3f} m long; it was removed", ring.name,
                                  std::min(distance(before, tip), distance(tip, after))),
                      ring.place(i), tip, 0);
    ring.erase(i);
    // The foot of the spike may now be there twice.
    const std::size_t m = ring.points.size();
    i = i % m;
    if (m >= 2 && distance(ring.points[(i + m - 1) % m], ring.points[i]) <= kSamePlace_m) ring.erase(i);
    i = (i + 2 * ring.points.size() - 2) % std::max<std::size_t>(1, ring.points.size());
    since_last = 0;
  }
}

}  // namespace tramline
