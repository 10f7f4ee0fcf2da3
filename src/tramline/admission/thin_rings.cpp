#include "tramline/admission/thin_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tramline/geometry/path/simplified_line.h"

namespace tramline {
namespace {

constexpr std::array<double, 4> kTolerances_m = {0.01, 0.02, 0.05, 0.1};

/// A ring is simplified in stretches of so many corners, whose ends stay: the time of one stretch may grow
/// with the square of its length.
constexpr std::size_t kStretch = 512;

std::size_t corners_of(const std::vector<WorkRing>& rings) {
  std::size_t out = 0;
  for (const WorkRing& ring : rings) out += ring.points.size();
  return out;
}

/// The corners that stay, as indices in increasing order.
std::vector<std::size_t> kept_corners(const Ring& ring, double tolerance_m) {
  std::vector<std::size_t> out;
  std::vector<Point> stretch;
  for (std::size_t first = 0; first < ring.size(); first += kStretch) {
    const std::size_t end = std::min(first + kStretch, ring.size());
    stretch.assign(ring.begin() + static_cast<std::ptrdiff_t>(first),
                   ring.begin() + static_cast<std::ptrdiff_t>(end));
    stretch.push_back(ring[end % ring.size()]);
    std::vector<std::size_t> kept = simplified_line(stretch, tolerance_m);
    // The end of a stretch is the beginning of the next one.
    kept.pop_back();
    for (const std::size_t i : kept) out.push_back(first + i);
  }
  return out;
}

WorkRing thinned(const WorkRing& ring, double tolerance_m) {
  // What has hardly any corners has none to spare.
  constexpr std::size_t kFewest = 16;
  if (ring.points.size() <= kFewest) return ring;
  WorkRing out;
  out.name = ring.name;
  for (const std::size_t i : kept_corners(ring.points, tolerance_m)) {
    out.points.push_back(ring.points[i]);
    out.vertex.push_back(ring.vertex[i]);
  }
  return out;
}

void note(const WorkRing& before, const WorkRing& after, bool is_hole, double tolerance_m,
          RepairLog& repair_log) {
  if (after.points.size() == before.points.size()) return;
  const double gain_m2 = std::abs(signed_area(after.points)) - std::abs(signed_area(before.points));
  repair_log.repair(fmt::format("{} had {} corners; {} were left out that lie within {:g} cm of the boundary "
                                "through the others",
                                before.name, before.points.size(), before.points.size() - after.points.size(),
                                100 * tolerance_m),
                    before.name, before.points.front(), is_hole ? -gain_m2 : gain_m2);
}

std::vector<WorkRing> thinned(const std::vector<WorkRing>& rings, double tolerance_m) {
  std::vector<WorkRing> out;
  for (const WorkRing& ring : rings) out.push_back(thinned(ring, tolerance_m));
  return out;
}

}  // namespace

void thin_rings(std::vector<WorkRing>& rings, RepairLog& repair_log) {
  const std::size_t drawn = corners_of(rings);
  if (drawn <= kManyCorners) return;
  std::vector<WorkRing> thin;
  double within_m = 0;
  for (const double tolerance_m : kTolerances_m) {
    within_m = tolerance_m;
    thin = thinned(rings, tolerance_m);
    if (corners_of(thin) <= kManyCorners) break;
  }
  if (corners_of(thin) > kMostCorners)
    throw repair_log.refusal(fmt::format(
        "the boundary has {} corners, and still {} where those are left out that lie within {:g} cm "
        "of the line through the others; simplify or smooth it to {} corners or fewer",
        drawn, corners_of(thin), 100 * within_m, kMostCorners));
  for (std::size_t r = 0; r < rings.size(); ++r) note(rings[r], thin[r], r > 0, within_m, repair_log);
  rings = std::move(thin);
}

}  // namespace tramline
