#pragma once
// A reference line that a machine can drive (Zhou §4), in place of the kinked polyline that Zhou offsets.

#include <optional>
#include <string>
#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

struct Smoothed {
  Path path;               ///< lines and arcs, tangents continuous
  double deviation_m = 0;  ///< largest distance between path and polyline, either way
  Point worst{};           ///< point of that deviation, on the polyline or on the path
};

/// The polyline as a path no tighter than `radius_m` (> 0), in the same sense, from its first to its last
/// point. Kinks become arcs; where edges are too short for the arcs between them, vertices are merged:
///  - two that turn the same way become the one where the edges around them meet: a disc that rolls along
///    the inside touches these and not the edge between;
///  - two that turn opposite ways are drawn apart along their edges, or, where those are too short as
///    well, become their midpoint.
/// The shortest edges go first, so that noise is averaged before shape is touched.
///
/// `tolerance_m` (≥ 0) is the level of smoothing: vertices within it of a simpler line are left out first
/// (Douglas and Peucker 1973), and arcs are made as wide as possible without leaving a vertex by more, so
/// that a polyline along a circle becomes arcs of about its radius. 0 keeps every vertex.
///
/// Throws Error(kBadInput) with the vertex (from 0) for fewer than two distinct points, a line that crosses
/// or touches itself, a hairpin tighter than can be driven, or a path that crosses itself where the polyline
/// nearly does. O(n log n) for lines whose edges do not crowd.
Smoothed smoothed(const std::vector<Point>& polyline, double radius_m, double tolerance_m = 0);

/// A smoothed line, or a sentence for the user on why there is none.
struct SmoothedOrRefused {
  std::optional<Smoothed> smoothed;
  std::string refusal;  ///< empty where there is a line
};

/// The same for lines that the user did not give: a refusal is a result here, not an error as in smoothed().
SmoothedOrRefused try_smoothed(const std::vector<Point>& polyline, double radius_m, double tolerance_m = 0);

}  // namespace tramline
