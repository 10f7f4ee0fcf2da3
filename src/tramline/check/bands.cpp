#include "tramline/check/bands.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tramline/check/tolerances.h"
#include "tramline/geometry/boolean.h"
#include "tramline/geometry/kinked_line.h"

namespace tramline::check {
namespace {

Point place_on(const PathSegment& segment, double along_m) {
  if (segment.straight())
    return segment.from + (along_m / distance(segment.from, segment.to)) * (segment.to - segment.from);
  const double half_angle = 0.5 * along_m * segment.curvature;
  const double chord_m = 2 * std::abs(std::sin(half_angle) / segment.curvature);
  const Point d = direction_at_start(segment);
  const double c = std::cos(half_angle), s = std::sin(half_angle);
  return segment.from + chord_m * Point{d.x * c - d.y * s, d.x * s + d.y * c};
}

/// The chords of an arc stand at angles that are the same for all arcs about its centre and about as large:
/// side by side they then share their edges, and overlays of them have no slivers to sort out.
class AlignedBand {
 public:
  AlignedBand(const PathSegment& arc, double half_m, double sagitta_m)
      : centre_(centre(arc)), sense_(arc.curvature > 0 ? 1 : -1) {
    const Point first = arc.from - centre_;
    const double outer_m = radius(arc) + half_m, inner_m = radius(arc) - half_m;
    // In driving direction, so that angles rise.
    const double from = sense_ * std::atan2(first.y, first.x), to = from + std::abs(turning(arc));
    const double step = step_of(outer_m, sagitta_m), shortest = kShortest_m / outer_m;
    std::vector<double> angles{from};
    for (double k = std::ceil((from + shortest) / step); k * step < to - shortest; ++k)
      angles.push_back(k * step);
    angles.push_back(to);
    for (const double angle : angles) ring_.push_back(place(angle, outer_m));
    for (auto angle = angles.rbegin(); angle != angles.rend(); ++angle)
      ring_.push_back(place(*angle, inner_m));
    if (sense_ < 0) std::reverse(ring_.begin(), ring_.end());
  }

  Ring take() { return std::move(ring_); }

 private:
  static constexpr double kShortest_m = 1e-5;

  /// A full circle has a power of two.
  static double step_of(double radius_m, double sagitta_m) {
    const double widest = 2 * std::acos(std::max(0.0, 1 - sagitta_m / radius_m));
    double step = std::numbers::pi / 2;
    while (step > widest) step *= 0.5;
    return step;
  }
  Point place(double angle, double radius_m) const {
    return centre_ + radius_m * Point{std::cos(angle), sense_ * std::sin(angle)};
  }

  Point centre_;
  double sense_;  ///< 1: turns left
  Ring ring_;
};

}  // namespace

void append_ground(Ring ring, bool may_fold, Region& out) {
  const Polygon ground{std::move(ring), {}};
  if (!may_fold || !find_invalidity(ground)) {
    out.push_back(ground);
    return;
  }
  for (Polygon& part : made_valid(ground)) out.push_back(std::move(part));
}

Region flat_bands_along(const Path& path, double width_m, double sagitta_m) {
  Region out;
  for (const PathSegment& segment : path) {
    const bool folds = 2 * radius(segment) <= width_m * (1 + 1e-9);
    const bool aligned = !segment.straight() && !folds;
    append_ground(
        aligned ? AlignedBand(segment, 0.5 * width_m, sagitta_m).take() : band({segment}, width_m, sagitta_m),
        folds, out);
  }
  return out;
}

Region bands_along(const Path& path, double width_m, double sagitta_m) {
  if (!has_kinks(path)) return flat_bands_along(path, width_m, sagitta_m);
  Region out;
  for (Ring& cell : kinked_cells(path, width_m)) append_ground(std::move(cell), false, out);
  return out;
}

Path begun_later(const Path& path, double by_m) {
  Path out;
  for (const PathSegment& segment : path) {
    const double length_m = length(segment);
    if (by_m >= length_m - kJoint_m) {  // what would be left of it has no direction worth the name
      by_m = std::max(0.0, by_m - length_m);
      continue;
    }
    out.push_back({by_m > 0 ? place_on(segment, by_m) : segment.from, segment.to, segment.curvature});
    by_m = 0;
  }
  return out;
}

Path shortened(const Path& path, double by_m) {
  return reversed(begun_later(reversed(begun_later(path, by_m)), by_m));
}

Point place_on(const Path& path, double along_m) {
  for (const PathSegment& segment : path) {
    const double length_m = length(segment);
    if (along_m <= length_m) return place_on(segment, along_m);
    along_m -= length_m;
  }
  return path.back().to;
}

double arcs_m(const Path& path) {
  double sum = 0;
  for (const PathSegment& segment : path)
    if (!segment.straight()) sum += length(segment);
  return sum;
}

}  // namespace tramline::check
