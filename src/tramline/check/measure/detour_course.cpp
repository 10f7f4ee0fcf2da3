#include "tramline/check/measure/detour_course.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The part of an edge on the side of a line that it is to be on: `inwards` leads from the line there.
std::optional<PathSegment> part_beyond(const PathSegment& edge, Point through, Point inwards) {
  const double from_m = dot(edge.from - through, inwards), to_m = dot(edge.to - through, inwards);
  if (from_m <= 0 && to_m <= 0) return std::nullopt;
  const auto at_line = [&] { return edge.from + (from_m / (from_m - to_m)) * (edge.to - edge.from); };
  return PathSegment{from_m < 0 ? at_line() : edge.from, to_m < 0 ? at_line() : edge.to, 0};
}

/// The part of an edge that lies between the normals of a segment at its ends.
std::optional<PathSegment> part_across_from(const PathSegment& segment, const PathSegment& edge) {
  const auto ahead = part_beyond(edge, segment.from, direction_at_start(segment));
  return ahead ? part_beyond(*ahead, segment.to, -1 * direction_at_end(segment)) : std::nullopt;
}

/// Across from a segment.
struct Beside {
  double right_m;  ///< negative on the left
  Point right;     ///< a unit vector
};

Beside beside(const PathSegment& segment, Point p) {
  if (segment.straight()) {
    const Point right = right_of(direction_at_start(segment));
    return {dot(p - segment.from, right), right};
  }
  // Outside an arc is the right of one that turns left.
  const double outside = segment.curvature > 0 ? 1 : -1;
  const Point spoke = p - centre(segment);
  const double off_m = length(spoke);
  return {outside * (off_m - radius(segment)),
          off_m > 0 ? (outside / off_m) * spoke : right_of(direction_at_start(segment))};
}

}  // namespace

DetourCourse::DetourCourse(Path line, const Path& detour)
    : line_(std::move(line)), between_(chords(detour, kSideSagitta_m)) {
  assert(!line_.empty());
  const std::vector<Point> back = chords(line_, kSideSagitta_m);
  between_.insert(between_.end(), back.rbegin(), back.rend());
}

bool DetourCourse::goes_left() const { return signed_area(between_) < 0; }

Sides DetourCourse::sides_of(const Polygon& land) const {
  if (contains(land, line_.front().from)) return {0, 0};
  Sides out;
  for (const Ring& ring : rings_of({land}))
    for (std::size_t i = 0; i < ring.size(); ++i)
      look_at({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], 0}, out);
  return out;
}

void DetourCourse::look_at(const PathSegment& edge, Sides& out) const {
  for (const PathSegment& segment : line_) {
    const std::optional<PathSegment> part = part_across_from(segment, edge);
    if (!part) continue;
    double& nearest_m =
        is_right_of_detour(segment, midpoint(part->from, part->to)) ? out.right_m : out.left_m;
    nearest_m = std::min(nearest_m, distance_to_edge(segment, part->from, part->to));
  }
}

/// On the right of the line, unless the ground between lies there, too: then it is on the other side.
bool DetourCourse::is_right_of_detour(const PathSegment& segment, Point p) const {
  Beside foot = beside(segment, p);
  if (std::abs(foot.right_m) < kLengthTolerance_m) {
    // On the line itself, which is an edge of the ground between.
    p = p + (kLengthTolerance_m - foot.right_m) * foot.right;
    foot.right_m = kLengthTolerance_m;
  }
  return (foot.right_m > 0) != contains(between_, p);
}

double DetourCourse::distance_to_line(const Polygon& land) const {
  if (contains(land, line_.front().from)) return 0;
  double out = std::numeric_limits<double>::infinity();
  for (const Ring& ring : rings_of({land}))
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (const PathSegment& segment : line_)
        out = std::min(out, distance_to_edge(segment, ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]));
  return out;
}

}  // namespace tramline::check
