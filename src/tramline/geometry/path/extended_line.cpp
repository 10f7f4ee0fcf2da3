#include "tramline/geometry/path/extended_line.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "tramline/geometry/path/line_crossing.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// Length up to which the box reaches from p in the direction; 0 where all of it lies behind.
double reach_ahead(Point p, Point direction, const Box& box) {
  double out = 0;
  for (const Point corner : {Point{box.min_x, box.min_y}, Point{box.max_x, box.min_y},
                             Point{box.max_x, box.max_y}, Point{box.min_x, box.max_y}})
    out = std::max(out, dot(corner - p, direction));
  return out;
}

/// Share of the way from a to b at which the segment is first reached. The path that begins at a does not
/// count where it is no farther off than kShortest_m.
std::optional<double> first_meeting(Point a, Point b, const PathSegment& segment) {
  const std::vector<Point> line = chords({segment}, kMeasuredSagitta_m);
  const double least = kShortest_m / distance(a, b);
  std::optional<double> out;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    if (const auto t = crossing_along(a, b, line[i], line[i + 1]))
      if (*t > least && (!out || *t < *out)) out = t;
  return out;
}

/// Shortens the extension from a to b to where it has to end. True where it is blocked.
bool shorten(Point a, Point& b, const Path& path) {
  double share = 1;
  for (const PathSegment& segment : path)
    if (const auto t = first_meeting(a, b, segment)) share = std::min(share, *t);
  if (share == 1) return false;
  b = a + share * (b - a);
  return true;
}

}  // namespace

Extended extended(const Path& path, double at_start_m, double at_end_m) {
  assert(!path.empty());
  Extended out{path};
  const Point begin = path.front().from, end = path.back().to;
  const Point ahead = direction_at_end(path.back());
  const Point behind = -1 * direction_at_start(path.front());
  if (at_start_m > kShortest_m) {
    Point to = begin + at_start_m * behind;
    out.blocked_at_start = shorten(begin, to, path);
    if (distance(to, begin) > 0) out.path.insert(out.path.begin(), {to, begin, 0});
  }
  if (at_end_m > kShortest_m) {
    Point to = end + at_end_m * ahead;
    out.blocked_at_end = shorten(end, to, out.path);
    if (distance(end, to) > 0) out.path.push_back({end, to, 0});
  }
  return out;
}

Extended extended(const Path& path, const Box& box) {
  assert(!path.empty());
  const double at_start = reach_ahead(path.front().from, -1 * direction_at_start(path.front()), box);
  const double at_end = reach_ahead(path.back().to, direction_at_end(path.back()), box);
  return extended(path, at_start, at_end);
}

}  // namespace tramline
