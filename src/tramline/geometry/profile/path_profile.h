#pragma once
// The part of a region in the cross-sections of a path: cross_section.h for paths with arcs.
//
// Along each segment the plane is seen in two coordinates, along it and across to the right; about an arc
// these are angle and radius. A straight boundary edge is a line there, or r = d / cos(φ − φ₀), which is
// monotonic on either side of the point nearest to the arc's centre.

#include <vector>

#include "tramline/geometry/index/edge_index.h"
#include "tramline/geometry/interval.h"
#include "tramline/geometry/path/path.h"

namespace tramline {

/// Part of a boundary edge within the cross-sections of one segment: positions along that segment, and the
/// distance from the left end of the cross-section, which is monotonic in between.
struct SectionPart {
  double from = 0;
  double to = 0;
  double across_from = 0;
  double across_to = 0;
  int sign = 0;  ///< +1 where the edge runs along the path: the region lies left of it
  // On an arc: radius(φ) = moment / (cos φ·edge.y − sin φ·edge.x).
  double moment = 0;
  Point edge;
};

/// A stretch of a segment whose cross-sections cross the same parts.
struct SectionSlab {
  double from = 0;  ///< positions along the segment
  double to = 0;
  int right_inside = 0;  ///< 1 where the right end of the cross-section is inside the region
  std::vector<std::size_t> parts{};
};

struct SegmentProfile {
  double start = 0;      ///< position along the path
  double length = 0;     ///< m
  double radius = 0;     ///< 0: straight
  int sense = 0;         ///< of an arc, +1: turns left
  double half_turn = 0;  ///< of an arc, rad, positive
  std::vector<SectionPart> parts;
  std::vector<SectionSlab> slabs;  ///< cover the segment
};

struct PathProfile {
  double width_m = 0;
  std::vector<SegmentProfile> segments;
  double length() const { return segments.empty() ? 0 : segments.back().start + segments.back().length; }
};

/// The profile of a region along a path, exact up to rounding. Precondition: arcs' radii are at least half
/// the width. About O(k log k) for the k edges near the path.
PathProfile path_profile(const EdgeIndex& region, const Path& path, double width_m);

/// Positions along the path where at least `least_m` (> 0) of the cross-section is inside; to 1e-8 m.
Intervals where_at_least(const PathProfile& profile, double least_m);
/// Positions along the path where its centre line is inside; to 1e-8 m.
Intervals centre_inside(const PathProfile& profile);
/// Area of the region within the swath between two positions, m².
double area_between(const PathProfile& profile, double from, double to);

}  // namespace tramline
