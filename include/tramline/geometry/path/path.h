#pragma once
// Paths of lines and arcs: what a machine drives.

#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// A straight line or an arc of at most half a circle, from one point to another.
struct PathSegment {
  Point from;
  Point to;
  double curvature = 0;  ///< 1/m; 0: straight, positive: turns left. |to − from|·|curvature| ≤ 2

  bool straight() const { return curvature == 0; }
  friend bool operator==(const PathSegment& a, const PathSegment& b) = default;
};

/// Segments one after the other: each begins where the last one ended. At least one.
using Path = std::vector<PathSegment>;

/// Radius of the segment, m; infinite for a straight one.
double radius(const PathSegment& segment);
/// Precondition: an arc.
Point centre(const PathSegment& arc);
/// Change of the heading from start to end, anticlockwise positive, rad; in [−π, π].
double turning(const PathSegment& segment);
double length(const PathSegment& segment);
/// Unit vectors in driving direction. Precondition: from != to.
Point direction_at_start(const PathSegment& segment);
Point direction_at_end(const PathSegment& segment);

/// A path of one straight segment.
Path straight_path(Point from, Point to);
double length(const Path& path);
/// Smallest radius on the path, m; infinite for a path without arcs.
double smallest_radius(const Path& path);
bool has_arcs(const Path& path);
/// The same path driven the other way.
Path reversed(const Path& path);

/// The path in another frame. `move` maps points and neither stretches nor mirrors.
template <class Motion>
Path moved(const Path& path, Motion move) {
  Path out;
  out.reserve(path.size());
  for (const PathSegment& segment : path)
    out.push_back({move(segment.from), move(segment.to), segment.curvature});
  return out;
}

/// Largest distance between an arc and the chords that replace it in polygons and files, m.
inline constexpr double kChordSagitta = 1e-5;

/// The path as a polyline whose vertices lie on it and whose chords deviate from it by at most `sagitta_m`.
std::vector<Point> chords(const Path& path, double sagitta_m = kChordSagitta);

/// The area within half the width on both sides, with flat ends; counter-clockwise. Arcs are replaced by
/// chords, which deviate from the true edge by at most `sagitta_m`. Where tangents are continuous and radii
/// are at least half the width it does not fold, and its area is width · length.
Ring band(const Path& path, double width_m, double sagitta_m = kChordSagitta);

/// The same for a path that ends where it begins, in its initial direction: a ring-shaped area without a
/// seam. It has no hole where the inner edge has shrunk to nothing. Precondition: the band does not meet
/// itself.
Polygon closed_band(const Path& path, double width_m, double sagitta_m = kChordSagitta);

/// A box that contains the band of the given width along the path.
Box reach_of(const Path& path, double width_m);
/// The same for each segment's part of the band.
std::vector<Box> reaches_of(const Path& path, double width_m);

/// The runs of consecutive segments whose bands may reach into one of the windows, in order along the path.
/// `reaches`: the boxes of its segments (reaches_of()). O(n·k) for k windows.
std::vector<Path> runs_near(const Path& path, const std::vector<Box>& reaches,
                            const std::vector<Box>& windows);

/// Shortest distance between a segment of a path and the straight edge ab; 0 where they meet, m.
double distance_to_edge(const PathSegment& segment, Point a, Point b);

}  // namespace tramline
