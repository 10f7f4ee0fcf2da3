#include "tramline/geometry/path/band_on_circles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// A vertex nearer to the end of an arc than this share of a chord is left out.
constexpr double kBesideEnd_share = 0.01;

/// The angle of a chord that divides the whole circle.
double chord_angle(double radius_m, double sagitta_m) {
  const double most = 2 * std::acos(1 - std::min(1.0, sagitta_m / radius_m));
  return 2 * std::numbers::pi / std::ceil(2 * std::numbers::pi / most);
}

/// Appends the circle's own vertices between two of its points, the second `turning` radians behind the
/// first.
void append_between(Point centre, Point first, double turning_rad, double sagitta_m,
                    std::vector<Point>& out) {
  const double radius_m = distance(first, centre);
  if (radius_m < kShortest_m) return;
  const double chord = chord_angle(radius_m, sagitta_m), sense = turning_rad > 0 ? 1 : -1;
  const double from = std::atan2(first.y - centre.y, first.x - centre.x) / chord;
  const double to = from + turning_rad / chord;
  const double last = std::floor(sense * to - kBesideEnd_share);
  for (double k = std::ceil(sense * from + kBesideEnd_share); k <= last; ++k) {
    const double angle = sense * k * chord;
    out.push_back(centre + Point{radius_m * std::cos(angle), radius_m * std::sin(angle)});
  }
}

/// The edge of the band `offset_m` to the left of the path.
std::vector<Point> edge_of_band(const Path& path, double offset_m, double sagitta_m) {
  std::vector<Point> out;
  for (const PathSegment& segment : path) {
    const Point first = segment.from + offset_m * left_of(direction_at_start(segment));
    out.push_back(first);
    if (!segment.straight()) append_between(centre(segment), first, turning(segment), sagitta_m, out);
    out.push_back(segment.to + offset_m * left_of(direction_at_end(segment)));
  }
  out.erase(
      std::unique(out.begin(), out.end(), [](Point a, Point b) { return distance(a, b) < kShortest_m; }),
      out.end());
  return out;
}

}  // namespace

Ring band_on_circles(const Path& path, double width_m, double sagitta_m) {
  const double half = 0.5 * width_m;
  Ring out = edge_of_band(path, -half, sagitta_m);
  const std::vector<Point> left = edge_of_band(path, half, sagitta_m);
  out.insert(out.end(), left.rbegin(), left.rend());
  return out;
}

}  // namespace tramline
