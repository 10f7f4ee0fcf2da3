#include "tramline/avoidance/detour/curved_detour_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/avoidance/detour/detour_hull.h"

namespace tramline {
namespace {

/// Shortest step along the track, and accuracy of the position found, m.
constexpr double kStep_m = 1e-2;
constexpr double kNear_m = 1e-12;
/// Largest distance between the positions tested beside what is in the way, m.
constexpr double kLookEvery_m = 0.25;

struct Nearest {
  double distance_m = std::numeric_limits<double>::infinity();
  std::size_t vertex = 0;  ///< where the path leaves the hull, driven from left to right
  Point normal;
};

/// The point of the centre line of the hull's discs that is nearest to p.
Nearest nearest_on(const Hull& hull, Point p) {
  Nearest out;
  for (std::size_t i = 0; i < hull.centres.size(); ++i) {
    const Point v = hull.centres[i];
    if (const double off = distance(p, v); off < out.distance_m) out = {off, i, (1 / off) * (p - v)};
    if (i + 1 == hull.centres.size()) break;
    const Point edge = hull.centres[i + 1] - v;
    const double foot = dot(p - v, edge);
    if (foot <= 0 || foot >= dot(edge, edge)) continue;
    const Point up = (1 / length(edge)) * Point{-edge.y, edge.x};
    const double off = dot(p - v, up);
    if (std::abs(off) < out.distance_m) out = {std::abs(off), i, off < 0 ? -1 * up : up};
  }
  return out;
}

/// The way back to the track, to the right of what is in the way.
class WayBack {
 public:
  WayBack(const Hull& hull, double arc, const TrackLine& track) : hull_(hull), arc_(arc), track_(track) {}

  std::optional<Approach> find(double& along) const {
    if (const std::optional<Approach> touching = first_touch(along)) return touching;
    return down_a_line(along);
  }

 private:
  Point arc_centre(double along) const {
    const PathPoint on = track_.measured.at(along);
    return on.at + arc_ * Point{-on.heading.y, on.heading.x};
  }

  std::optional<Approach> first_touch(double& along) const {
    const auto missing = [this](double at) {
      return hull_.radius + arc_ - nearest_on(hull_, arc_centre(at)).distance_m;
    };
    if (!begin_where_lacking(missing, along) || !go_on_until_none(missing, along)) return std::nullopt;
    const Point centre = arc_centre(along);
    const Nearest touched = nearest_on(hull_, centre);
    if (touched.normal.y < 0 || hull_.centres.back().y > centre.y) return std::nullopt;
    return Approach{touched.vertex, touched.normal, centre, track_.measured.at(along).at};
  }

  /// The approach by a straight line, where the hull rises so steeply that an arc to it would turn by more
  /// than a right angle.
  std::optional<Approach> down_a_line(double& along) const {
    const SteepLine line = steepest_line(hull_);
    Approach out = line.touching;
    const auto missing = [&](double at) { return line.off_m + arc_ - dot(out.normal, arc_centre(at)); };
    if (!begin_where_lacking(missing, along) || !go_on_until_none(missing, along)) return std::nullopt;
    out.arc_centre = arc_centre(along);
    out.on_track = track_.measured.at(along).at;
    return out;
  }

  /// Finds the last position beside what is in the way at which distance is missing.
  template <class Missing>
  bool begin_where_lacking(Missing missing, double& along) const {
    const double from = track_.blocked_from, to = track_.blocked_to;
    const int looks = 1 + static_cast<int>((to - from) / kLookEvery_m);
    for (int i = looks; i >= 0; --i) {
      along = from + (to - from) * i / looks;
      if (missing(along) >= 0) return true;
    }
    return false;
  }

  /// Finds the next position at which none is missing. `missing` changes by no more than twice the length
  /// moved.
  template <class Missing>
  bool go_on_until_none(Missing missing, double& along) const {
    const double end = track_.measured.length();
    double low = along, lacks = missing(low), high = low;
    while (lacks >= 0) {
      low = high;
      if (low >= end) return false;
      high = std::min(end, low + std::max(0.5 * lacks, kStep_m));
      lacks = missing(high);
    }
    while (high - low > kNear_m) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (missing(middle) >= 0 ? low : high) = middle;
    }
    along = high;
    return true;
  }

  const Hull& hull_;
  double arc_;
  const TrackLine& track_;
};

/// The track driven backwards, left and right exchanged.
TrackLine mirrored(const Path& track, const TrackLine& line) {
  Path path;
  path.reserve(track.size());
  for (auto segment = track.rbegin(); segment != track.rend(); ++segment)
    path.push_back(
        {{-segment->to.x, segment->to.y}, {-segment->from.x, segment->from.y}, segment->curvature});
  const double length_m = line.measured.length();
  return {MeasuredPath(std::move(path)), length_m - line.blocked_to, length_m - line.blocked_from};
}

/// Whether any disc reaches over the track.
bool reaches_over(const Hull& hull, const TrackLine& track) {
  const double from = track.blocked_from, to = track.blocked_to;
  const int looks = 1 + static_cast<int>((to - from) / kLookEvery_m);
  for (int i = 0; i <= looks; ++i) {
    const Point p = track.measured.at(from + (to - from) * i / looks).at;
    const Nearest nearest = nearest_on(hull, p);
    if (nearest.distance_m < hull.radius || nearest.normal.y < 0) return true;
  }
  return false;
}

/// Whether its headings stay so near to the frame's x that "up" is the side of passing.
bool goes_ahead(const MeasuredPath& measured, double from, double to) {
  const int looks = 1 + static_cast<int>((to - from) / kLookEvery_m);
  for (int i = 0; i <= looks; ++i)
    if (measured.at(from + (to - from) * i / looks).heading.x < std::cos(kSteepest)) return false;
  return true;
}

}  // namespace

std::optional<CurvedDetourPath> curved_detour_path(const std::vector<KeepOut>& discs, double radius_m,
                                                   const TrackLine& track, HullCorners corners) {
  assert(!discs.empty());
  assert(radius_m > 0);
  const Hull hull = hull_round(discs, radius_m, corners);
  if (!reaches_over(hull, track)) return std::nullopt;
  const Hull other_way = mirrored(hull);
  const TrackLine back = mirrored(track.measured.path(), track);
  double from = 0, to = 0;
  const std::optional<Approach> out = WayBack(hull, radius_m, track).find(to);
  const std::optional<Approach> in = WayBack(other_way, radius_m, back).find(from);
  if (!out || !in) return std::nullopt;
  from = track.measured.length() - from;
  const Approach there = mirrored(*in, hull);
  if (from >= to || there.vertex > out->vertex || !goes_ahead(track.measured, from, to)) return std::nullopt;
  if (there.vertex == out->vertex && cross(there.normal, out->normal) > 0) return std::nullopt;
  return CurvedDetourPath{hull_path(hull, there, *out, radius_m), from, to};
}

}  // namespace tramline
