#include "tramline/geometry/path/kinked_line.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// tan(60°): half of the sharpest kink that is mitred.
constexpr double kSteepest = 1.7320508075688772;
/// Cosine of a turn that is certainly sharper. Where a line goes straight back the tangent of half the turn
/// is a quotient of two roundings, which may be any number.
constexpr double kCosineOfReturn = -0.9;

/// tan(τ/2) for a turn of τ, right positive.
double half_turn_tangent(Point before, Point after) {
  return -cross(before, after) / (1 + dot(before, after));
}

/// Length by which the right side of a swath is cut at each joint, per metre of half its width; negative
/// where it is lengthened and the left side is cut. 0 where ends are flat.
class Mitres {
 public:
  Mitres(const Path& path, double half_m) {
    for (const PathSegment& segment : path) {
      along_.push_back(direction_at_start(segment));
      length_m_.push_back(length(segment));
    }
    std::vector<double> wanted(path.size() + 1, 0.0);
    std::vector<bool> sharp(path.size() + 1, false);
    for (std::size_t i = 1; i < path.size(); ++i) {
      wanted[i] = half_turn_tangent(along_[i - 1], along_[i]);
      sharp[i] = !(std::abs(wanted[i]) <= kSteepest) || dot(along_[i - 1], along_[i]) < kCosineOfReturn;
      if (sharp[i]) wanted[i] = 0;
    }
    cut_ = wanted;
    // A joint made flat may leave too little of the next segment: repeated until nothing changes.
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < path.size(); ++i) {
        if (half_m * std::abs(cut_[i] + cut_[i + 1]) <= length_m_[i]) continue;
        cut_[i] = cut_[i + 1] = 0;
        changed = true;
      }
    }
    for (std::size_t i = 1; i < path.size(); ++i)
      flat_.push_back(sharp[i] || (cut_[i] == 0 && wanted[i] != 0));
  }

  double at(std::size_t joint) const { return cut_[joint]; }
  /// Between segment i and the next.
  bool flat_after(std::size_t i) const { return i < flat_.size() && flat_[i]; }
  Point along(std::size_t i) const { return along_[i]; }

 private:
  std::vector<Point> along_;
  std::vector<double> length_m_;
  std::vector<double> cut_;  ///< by joint: before segment i, and after the last
  std::vector<bool> flat_;
};

}  // namespace

Path polyline_path(const std::vector<Point>& points) {
  assert(std::adjacent_find(points.begin(), points.end()) == points.end());
  Path out;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) out.push_back({points[i], points[i + 1], 0});
  return out;
}

std::vector<Point> vertices_of(const Path& path) {
  assert(std::all_of(path.begin(), path.end(), [](const PathSegment& s) { return s.straight(); }));
  std::vector<Point> out;
  if (!path.empty()) out.push_back(path.front().from);
  for (const PathSegment& segment : path) out.push_back(segment.to);
  return out;
}

bool has_kinks(const Path& path) {
  if (!std::all_of(path.begin(), path.end(), [](const PathSegment& s) { return s.straight(); })) return false;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Point a = direction_at_start(path[i]), b = direction_at_start(path[i + 1]);
    const double sine = std::abs(cross(a, b));
    // The rounding of its ends turns a segment of a micrometre by more than the least kink.
    const double aside_m = sine * std::min(length(path[i]), length(path[i + 1]));
    if ((sine > kLeastKink_rad && aside_m > kShortest_m) || dot(a, b) < 0) return true;
  }
  return false;
}

std::vector<Ring> kinked_cells(const Path& path, double width_m) {
  const double half = 0.5 * width_m;
  const Mitres mitres(path, half);
  std::vector<Ring> out;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Point along = mitres.along(i), right = half * right_of(along);
    const Point start = (half * mitres.at(i)) * along, end = (half * mitres.at(i + 1)) * along;
    out.push_back({path[i].from + right + start, path[i].to + right - end, path[i].to - right + end,
                   path[i].from - right - start});
  }
  return out;
}

Ring kinked_band(const Path& path, double width_m) {
  const std::vector<Ring> cells = kinked_cells(path, width_m);
  const Mitres mitres(path, 0.5 * width_m);
  Ring out, left;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i == 0 || mitres.flat_after(i - 1)) {
      out.push_back(cells[i][0]);
      left.push_back(cells[i][3]);
    }
    out.push_back(cells[i][1]);
    left.push_back(cells[i][2]);
  }
  out.insert(out.end(), left.rbegin(), left.rend());
  return out;
}

}  // namespace tramline
