#pragma once
// Single segments, and what their cross-sections meet, found edge by edge in the field.

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/random_shapes.h"
#include "tramline/geometry/index/edge_index.h"
#include "tramline/geometry/path/segment_frame.h"
#include "tramline/geometry/profile/path_profile.h"

namespace tramline::testing {

/// A line or an arc within reach of random_region(), with room for a swath up to 8 m wide.
inline PathSegment random_segment(RandomCase& random) {
  const Point from = random.point_in({-50, -50, 130, 50}), direction = turned({1, 0}, random.between(-3, 3));
  if (random.whole(0, 2) == 0) return {from, from + random.between(5, 80) * direction, 0};
  const double turn = (random.whole(0, 1) == 0 ? -1 : 1) * random.between(0.2, 3);
  return arc_onwards(from, direction, random.between(4, 40), turn);
}

/// A random region, and the swath along a random segment through it.
struct RandomSection {
  explicit RandomSection(RandomCase& random)
      : region(random_region(random)),
        segment(random_segment(random)),
        width(random.between(1, 8)),
        frame(segment, 0.5 * width) {}
  Region region;
  PathSegment segment;
  double width;
  SegmentFrame frame;
};

inline SegmentProfile shape_of(const SegmentFrame& frame) {
  SegmentProfile out;
  out.length = frame.length();
  out.radius = frame.radius();
  out.sense = frame.sense();
  out.half_turn = frame.half_turn();
  return out;
}

/// An edge that a cross-section meets: how far from its left end, and +1 where the region lies to the left.
struct Meeting {
  double across = 0;
  int sign = 0;
};

/// The edges that the cross-section at a position meets, from left to right.
inline std::vector<Meeting> meetings_with(const EdgeIndex& region, const SegmentFrame& frame, double width,
                                          double along) {
  const Point left = frame.point_at(along, 0), right = frame.point_at(along, width);
  std::vector<Meeting> out;
  for (const EdgeIndex::Edge& edge : region.edges()) {
    const double from = cross(right - left, edge.from - left), to = cross(right - left, edge.to - left);
    if ((from < 0) == (to < 0)) continue;
    const Point at = edge.from + (from / (from - to)) * (edge.to - edge.from);
    const double across = dot(at - left, right - left) / width;
    if (across >= 0 && across <= width) out.push_back({across, to > from ? 1 : -1});
  }
  std::sort(out.begin(), out.end(), [](const Meeting& a, const Meeting& b) { return a.across < b.across; });
  return out;
}

}  // namespace tramline::testing
