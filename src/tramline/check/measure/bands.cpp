#include "tramline/check/measure/bands.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tramline/check/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {
namespace {

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
    const double step = step_of(outer_m, sagitta_m), shortest = kShortestChord_m / outer_m;
    std::vector<double> angles{from};
    for (double k = std::ceil((from + shortest) / step); k * step < to - shortest; ++k)
      angles.push_back(k * step);
    angles.push_back(to);
    for (const double angle : angles) ring_.push_back(point_at(angle, outer_m));
    for (auto angle = angles.rbegin(); angle != angles.rend(); ++angle)
      ring_.push_back(point_at(*angle, inner_m));
    if (sense_ < 0) std::reverse(ring_.begin(), ring_.end());
  }

  Ring take() { return std::move(ring_); }

 private:
  /// Of an outer chord: shorter ones at its ends are left out.
  static constexpr double kShortestChord_m = 1e-5;

  /// A full circle has a power of two.
  static double step_of(double radius_m, double sagitta_m) {
    const double widest = 2 * std::acos(std::max(0.0, 1 - sagitta_m / radius_m));
    double step = std::numbers::pi / 2;
    while (step > widest) step *= 0.5;
    return step;
  }
  Point point_at(double angle, double radius_m) const {
    return centre_ + radius_m * Point{std::cos(angle), sense_ * std::sin(angle)};
  }

  Point centre_;
  double sense_;  ///< 1: turns left
  Ring ring_;
};

/// A line to which bands are cut: what lies against its normal is within.
struct Cut {
  Point through;
  Point normal;

  bool has(Point p) const { return dot(p - through, normal) <= 0; }
  /// Where a line along a direction meets it.
  Point on(Point p, Point direction) const {
    return p + (dot(through - p, normal) / dot(direction, normal)) * direction;
  }
};

/// The band of each straight segment between the cuts at its ends.
class CutBands {
 public:
  CutBands(const Path& path, double width_m) : path_(path), half_m_(0.5 * width_m) {
    for (const PathSegment& segment : path) along_.push_back(direction_at_start(segment));
    flat_.assign(path.size() + 1, false);
    for (std::size_t joint = 1; joint < path.size(); ++joint)
      flat_[joint] = dot(along_[joint - 1], along_[joint]) < kCosineOfSharpest;
    flat_.front() = flat_.back() = true;
    // An end made flat may reach over the other end's cut of the segment behind it.
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < path.size(); ++i) {
        if ((flat_[i] && flat_[i + 1]) || !cuts_meet(i)) continue;
        flat_[i] = flat_[i + 1] = true;
        changed = true;
      }
    }
  }

  /// Counter-clockwise.
  Ring of(std::size_t i) const {
    const Cut start = start_of(i), end = end_of(i);
    const Point right = beside(i, -half_m_), left = beside(i, half_m_), along = along_[i];
    return {start.on(right, along), end.on(right, along), end.on(left, along), start.on(left, along)};
  }

 private:
  static constexpr double kCosineOfSharpest = -0.5;

  Point beside(std::size_t i, double left_m) const {
    return path_[i].from + left_m * Point{-along_[i].y, along_[i].x};
  }
  /// Both segments at a kink make the same angle with its bisector.
  Point across(std::size_t joint, std::size_t segment) const {
    return flat_[joint] ? along_[segment] : along_[joint - 1] + along_[joint];
  }
  Cut start_of(std::size_t i) const { return {path_[i].from, -1 * across(i, i)}; }
  Cut end_of(std::size_t i) const { return {path_[i].to, across(i + 1, i)}; }
  bool cuts_meet(std::size_t i) const {
    const Cut start = start_of(i), end = end_of(i);
    return !end.has(start.on(beside(i, -half_m_), along_[i])) ||
           !end.has(start.on(beside(i, half_m_), along_[i]));
  }

  const Path& path_;
  double half_m_;
  std::vector<Point> along_;
  std::vector<bool> flat_;  ///< by joint: before segment i, and after the last
};

}  // namespace

Point heading_on(const PathSegment& segment, double along_m) {
  const Point first = direction_at_start(segment);
  const double angle = along_m * segment.curvature, c = std::cos(angle), s = std::sin(angle);
  return {first.x * c - first.y * s, first.x * s + first.y * c};
}

Point point_on(const PathSegment& segment, double along_m) {
  if (segment.straight())
    return segment.from + (along_m / distance(segment.from, segment.to)) * (segment.to - segment.from);
  const double half_angle = 0.5 * along_m * segment.curvature;
  const double chord_m = 2 * std::abs(std::sin(half_angle) / segment.curvature);
  const Point d = direction_at_start(segment);
  const double c = std::cos(half_angle), s = std::sin(half_angle);
  return segment.from + chord_m * Point{d.x * c - d.y * s, d.x * s + d.y * c};
}

bool is_kinked(const Path& path) {
  bool turns = false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!path[i].straight()) return false;
    turns =
        turns || (i > 0 && distance(direction_at_end(path[i - 1]), direction_at_start(path[i])) > kLeastKink);
  }
  return turns;
}

void append_ground(Ring ring, Folds folds, Region& out) {
  const Polygon ground{std::move(ring), {}};
  if (folds == Folds::kNever || !find_invalidity(ground)) {
    out.push_back(ground);
    return;
  }
  for (Polygon& part : made_valid(ground)) out.push_back(std::move(part));
}

Region flat_bands_along(const Path& path, double width_m, double sagitta_m) {
  Region out;
  for (const PathSegment& segment : path) {
    const bool folds = 2 * radius(segment) <= width_m * (1 + kRounding);
    const bool aligned = !segment.straight() && !folds;
    append_ground(
        aligned ? AlignedBand(segment, 0.5 * width_m, sagitta_m).take() : band({segment}, width_m, sagitta_m),
        folds ? Folds::kPerhaps : Folds::kNever, out);
  }
  return out;
}

Region bands_along(const Path& path, double width_m, double sagitta_m) {
  if (!is_kinked(path)) return flat_bands_along(path, width_m, sagitta_m);
  const CutBands bands(path, width_m);
  Region out;
  for (std::size_t i = 0; i < path.size(); ++i) append_ground(bands.of(i), Folds::kNever, out);
  return out;
}

Region pass_bands_along(const Path& path, HeadlandConstruction how, double width_m, double sagitta_m) {
  return how == HeadlandConstruction::kPlain ? bands_along(path, width_m, sagitta_m)
                                             : flat_bands_along(path, width_m, sagitta_m);
}

Path begun_later(const Path& path, double by_m) {
  Path out;
  for (const PathSegment& segment : path) {
    const double length_m = length(segment);
    if (by_m >= length_m - kJoint_m) {  // what would be left of it has no direction worth the name
      by_m = std::max(0.0, by_m - length_m);
      continue;
    }
    out.push_back({by_m > 0 ? point_on(segment, by_m) : segment.from, segment.to, segment.curvature});
    by_m = 0;
  }
  return out;
}

Path shortened(const Path& path, double by_m) {
  return reversed(begun_later(reversed(begun_later(path, by_m)), by_m));
}

Point point_on(const Path& path, double along_m) {
  for (const PathSegment& segment : path) {
    const double length_m = length(segment);
    if (along_m <= length_m) return point_on(segment, along_m);
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
