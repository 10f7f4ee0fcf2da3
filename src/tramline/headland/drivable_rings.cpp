#include "tramline/headland/drivable_rings.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/offset/offset_curve.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

bool inside(const Path& path, const std::vector<OffsetBoundary>& offset_boundaries) {
  return std::all_of(
      offset_boundaries.begin(), offset_boundaries.end(), [&](const OffsetBoundary& offset_boundary) {
        return contains(offset_boundary.ring, path.front().from) == (signed_area(offset_boundary.ring) > 0);
      });
}

bool is_smooth(const Path& path) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const PathSegment& next = path[(i + 1) % path.size()];
    const Point before = direction_at_end(path[i]), after = direction_at_start(next);
    if (!(std::abs(std::atan2(cross(before, after), dot(before, after))) < kKink_rad)) return false;
  }
  return true;
}

OffsetCurve curve_of(const PathSegment& segment) {
  if (segment.straight()) return offset_line(segment.from, segment.to);
  return segment.curvature < 0 ? offset_arc(centre(segment), radius(segment), segment.from, segment.to)
                               : offset_arc(centre(segment), radius(segment), segment.to, segment.from);
}

/// A segment of one of the paths.
struct Placed {
  OffsetCurve curve;
  std::size_t path = 0;
  std::size_t before = 0;  ///< indices of the segments it is joined to
  std::size_t after = 0;
};

}  // namespace

int meeting_count(const std::vector<Path>& paths) {
  std::vector<Placed> all;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const std::size_t first = all.size(), n = paths[k].size();
    for (std::size_t i = 0; i < n; ++i)
      all.push_back({curve_of(paths[k][i]), k, first + (i + n - 1) % n, first + (i + 1) % n});
  }
  std::vector<std::size_t> order(all.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return all[i].curve.box.min_x < all[j].curve.box.min_x; });
  int out = 0;
  std::vector<std::size_t> open;
  for (const std::size_t i : order) {
    std::erase_if(open, [&](std::size_t j) { return all[j].curve.box.max_x < all[i].curve.box.min_x; });
    for (const std::size_t j : open)
      if (j != all[i].before && j != all[i].after)
        out += meetings(all[i].curve, all[j].curve).empty() ? 0 : 1;
    open.push_back(i);
  }
  return out;
}

std::vector<Path> parted_where_it_meets_itself(const Path& path) {
  // In a ring the last segment is joined to the first; in an open path the two may cross.
  const bool is_ring = distance(path.front().from, path.back().to) < kSamePlace_m;
  if (is_ring && meeting_count({path}) == 0) return {path};
  std::vector<Path> out;
  std::vector<OffsetCurve> driven;  // of the current part
  for (const PathSegment& segment : path) {
    const OffsetCurve curve = curve_of(segment);
    bool meets = false;
    for (std::size_t i = 0; i + 1 < driven.size() && !meets; ++i) meets = !meetings(driven[i], curve).empty();
    if (meets || out.empty()) {
      out.emplace_back();
      driven.clear();
    }
    out.back().push_back(segment);
    driven.push_back(curve);
  }
  return out;
}

bool keeps_off(const Path& path, const std::vector<OffsetBoundary>& offset_boundaries) {
  for (const PathSegment& segment : path) {
    const Box reach = reach_of({segment}, 0);
    for (const OffsetBoundary& offset_boundary : offset_boundaries) {
      const Box near = reach.grown(offset_boundary.distance_m);
      for (std::size_t i = 0; i < offset_boundary.ring.size(); ++i) {
        const Point a = offset_boundary.ring[i],
                    b = offset_boundary.ring[(i + 1) % offset_boundary.ring.size()];
        if (std::max(a.x, b.x) < near.min_x || std::min(a.x, b.x) > near.max_x ||
            std::max(a.y, b.y) < near.min_y || std::min(a.y, b.y) > near.max_y)
          continue;
        if (distance_to_edge(segment, a, b) < offset_boundary.distance_m - kNearerPass_m) return false;
      }
    }
  }
  return true;
}

bool can_be_driven(const Path& path, const TurningRoom& land) {
  return path.size() > 1 && smallest_radius(path) >= land.radius_m * (1 - kRounding_share) &&
         is_smooth(path) && inside(path, land.offset_boundaries) && keeps_off(path, land.offset_boundaries);
}

}  // namespace tramline
