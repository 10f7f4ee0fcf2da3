#include "tramline/planner/price/given_pieces.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

bool all_straight(const Path& path) {
  return std::all_of(path.begin(), path.end(), [](const PathSegment& s) { return s.straight(); });
}

/// Whether a band along a path with arcs has the area width · length and no gaps.
bool lies_flat(const Path& path, double width_m) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (distance(path[i].from, path[i].to) <= kSamePlace_m) return false;
    if (radius(path[i]) < 0.5 * width_m * (1 - kRounding_share)) return false;
    if (i > 0 && distance(direction_at_end(path[i - 1]), direction_at_start(path[i])) > kLeastTurnAtJoint)
      return false;
  }
  return true;
}

/// The vertices without those that lie where the one before does; the last one stays.
std::vector<Point> in_different_places(const std::vector<Point>& given) {
  std::vector<Point> out;
  for (const Point p : given)
    if (out.empty() || distance(out.back(), p) > kSamePlace_m) out.push_back(p);
  if (out.size() > 1) out.back() = given.back();
  return out;
}

void open_ring(std::vector<Point>& points) {
  if (points.size() < 3 || distance(points.front(), points.back()) > kSamePlace_m) return;
  const Point before = points[points.size() - 2], back = before - points.back();
  points.back() = points.back() + (std::min(kOpenedRing_m, 0.5 * length(back)) / length(back)) * back;
}

/// The same for a path with arcs, which it keeps: its last segment ends sooner.
void open_ring(Path& path) {
  PathSegment& last = path.back();
  const double off_m = std::min(kOpenedRing_m, 0.5 * length(last));
  if (last.straight()) {
    last.to = last.to - off_m * direction_at_end(last);
    return;
  }
  const Point middle = centre(last), spoke = last.to - middle;
  const double angle = -off_m * last.curvature, c = std::cos(angle), s = std::sin(angle);
  last.to = middle + Point{spoke.x * c - spoke.y * s, spoke.x * s + spoke.y * c};
}

std::vector<Point> all_vertices(const Path& path) {
  std::vector<Point> out{path.front().from};
  for (const PathSegment& segment : path) out.push_back(segment.to);
  return out;
}

/// A rectangle that reaches from the line through a point, half a width to both sides, `depth_m` ahead.
Ring ahead_of(Point at, Point heading, double width_m, double depth_m) {
  const Point right = 0.5 * width_m * Point{heading.y, -heading.x}, on = depth_m * heading;
  return {at + right, at + right + on, at - right + on, at - right};
}

double common_m2(const Ring& ring, const Region& land) {
  const Box window = bounds(ring);
  RisingCurves curves;
  append_ring(ring, Layer::kNew, window, curves);
  for (const Polygon& polygon : land)
    if (intersects(window, bounds(polygon)))
      for (const Ring& edge : rings_of({polygon})) append_ring(edge, Layer::kBody, window, curves);
  return newly_covered_area(curves);
}

bool lies_against(const Region& hard, Point end, Point heading, double width_m) {
  return common_m2(ahead_of(end, heading, width_m, kAheadOfLine_m), hard) > kAheadOfLine_m2;
}

bool goes_on_behind(const Path& before, const Path& next, const Region& passable, const Region& hard,
                    double width_m) {
  const Point gap = next.front().from - before.back().to;
  const double gap_m = length(gap);
  if (gap_m <= kSamePlace_m) return false;
  const Point out = direction_at_end(before.back()), in = direction_at_start(next.front());
  const bool ahead = dot(gap, out) > 0 && dot(gap, in) > 0;
  const bool in_line = std::max(std::abs(cross(out, gap)), std::abs(cross(in, gap))) <= 0.5 * width_m;
  if (!ahead || !in_line) return false;
  const Ring hop = ahead_of(before.back().to, (1 / gap_m) * gap, width_m, gap_m);
  return common_m2(hop, passable) > kAheadOfLine_m2 && common_m2(hop, hard) <= kAheadOfLine_m2;
}

TrackPiece piece_along(const Path& path) {
  TrackPiece out;
  out.start = path.front().from;
  out.end = path.back().to;
  if (path.size() > 1 || !path.front().straight()) out.curve = path;
  return out;
}

}  // namespace

std::optional<Path> workable_path(const Path& given, double width_m, Rings rings) {
  if (given.empty()) return std::nullopt;
  const bool straight = all_straight(given);
  const bool opened =
      rings == Rings::kAreOpened && distance(given.front().from, given.back().to) <= kSamePlace_m;
  if (!straight && lies_flat(given, width_m)) {
    Path out = given;
    if (opened) open_ring(out);
    return out;
  }
  std::vector<Point> points =
      in_different_places(straight ? all_vertices(given) : chords(given, kTightSagitta_m));
  if (rings == Rings::kAreOpened) open_ring(points);
  if (points.size() < 2) return std::nullopt;
  return polyline_path(points);
}

bool has_smooth_edges(const Path& path) { return !has_kinks(path); }

std::vector<TrackPiece> given_pieces(const std::vector<GivenLine>& lines, const Region& hard,
                                     const Region& passable, double width_m) {
  std::vector<TrackPiece> out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Path& path = lines[i].path;
    assert(!path.empty());
    TrackPiece piece = piece_along(path);
    piece.stop_at_start = lies_against(hard, piece.start, -1.0 * direction_at_start(path.front()), width_m);
    piece.stop_at_end = lies_against(hard, piece.end, direction_at_end(path.back()), width_m);
    piece.after_crossing = i > 0 && !passable.empty() && lines[i].way_here != WayHere::kTurn &&
                           goes_on_behind(lines[i - 1].path, path, passable, hard, width_m);
    piece.subfield = static_cast<std::size_t>(lines[i].subfield);
    piece.track = piece.after_crossing ? out.back().track : static_cast<int>(i);
    out.push_back(std::move(piece));
  }
  return out;
}

}  // namespace tramline
