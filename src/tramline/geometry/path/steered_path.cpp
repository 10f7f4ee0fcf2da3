#include "tramline/geometry/path/steered_path.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace tramline {
namespace {

// Abscissae and weights of Gauss and Legendre on [0, 1], four of eight points: the others lie as far from 1.
constexpr std::array<double, 4> kGaussAt = {0.019855071751231884, 0.10166676129318664, 0.2372337950418355,
                                            0.4082826787521751};
constexpr std::array<double, 4> kGaussWeight = {0.05061426814518813, 0.11119051722668724, 0.15685332293894364,
                                                0.18134189168918100};
/// Turning of a clothoid on which eight points are exact to 1e-13, rad.
constexpr double kQuadratureStep_rad = 0.5;
/// Half angles below which sin φ/φ is 1 − φ²/6 to rounding, rad.
constexpr double kSmallHalfAngle_rad = 1e-4;
/// Excess over half a circle that is rounding: such an arc stays one.
constexpr double kHalfCircleNoise = 1e-12;

double sense(Gear gear) { return gear == Gear::kForward ? 1 : -1; }

/// The heading's change after a length, clockwise, rad.
double clockwise_after(const SteeredStretch& stretch, double after_m) {
  const double change =
      stretch.length_m > 0 ? (stretch.curvature_at_end - stretch.curvature_at_start) / stretch.length_m : 0;
  return -sense(stretch.gear) * after_m * (stretch.curvature_at_start + 0.5 * change * after_m);
}

Heading heading_after(const SteeredStretch& stretch, double after_m) {
  return Heading::clockwise_from_north(stretch.start.heading.angle() +
                                       Angle::radians(clockwise_after(stretch, after_m)));
}

Point heading_vector(const SteeredStretch& stretch, double after_m) {
  const double angle = stretch.start.heading.angle().radians() + clockwise_after(stretch, after_m);
  return {std::sin(angle), std::cos(angle)};
}

Point clothoid_end(const SteeredStretch& stretch, double after_m) {
  const double most_turning =
      after_m * std::max(std::abs(stretch.curvature_at_start), std::abs(stretch.curvature_at_end));
  const double parts = std::max(1.0, std::ceil(most_turning / kQuadratureStep_rad));
  Point sum;
  for (double part = 0; part < parts; ++part)
    for (std::size_t i = 0; i < kGaussAt.size(); ++i)
      for (const double at : {kGaussAt[i], 1 - kGaussAt[i]})
        sum = sum + kGaussWeight[i] * heading_vector(stretch, (part + at) / parts * after_m);
  return stretch.start.at + (sense(stretch.gear) * after_m / parts) * sum;
}

/// End of a line or an arc, driven `way` metres along the heading, negative in reverse. The chord of an arc
/// of angle φ is way · sin(φ/2)/(φ/2) long, at φ/2 from the heading.
Point arc_end(const SteeredStretch& stretch, double way) {
  const double half = 0.5 * way * stretch.curvature_at_start;
  const double shorter = std::abs(half) < kSmallHalfAngle_rad ? 1 - half * half / 6 : std::sin(half) / half;
  return stretch.start.at + way * shorter * turned(stretch.start.heading.unit(), half);
}

SteeredStretch retraced(const SteeredStretch& stretch) {
  return {end_of(stretch), stretch.length_m, stretch.curvature_at_end, stretch.curvature_at_start,
          stretch.gear == Gear::kForward ? Gear::kReverse : Gear::kForward};
}

Pose about_face(const Pose& pose) {
  return {pose.at, Heading::clockwise_from_north(pose.heading.angle() + Angle::degrees(180))};
}

/// Chords of a clothoid: n of them deviate by about κ (L/n)²/8.
std::size_t chord_count(const SteeredStretch& clothoid, double sagitta_m) {
  const double tightest =
      std::max(std::abs(clothoid.curvature_at_start), std::abs(clothoid.curvature_at_end));
  return static_cast<std::size_t>(std::ceil(clothoid.length_m * std::sqrt(tightest / (8 * sagitta_m)) + 1));
}

void add(Path& out, Point from, Point to, double curvature) {
  if (from != to) out.push_back({from, to, curvature});
}

}  // namespace

const char* name(Gear gear) { return gear == Gear::kForward ? "forward" : "reverse"; }

Pose pose_after(const SteeredStretch& stretch, double after_m) {
  assert(after_m >= 0);
  const Point at =
      stretch.clothoid() ? clothoid_end(stretch, after_m) : arc_end(stretch, sense(stretch.gear) * after_m);
  return {at, heading_after(stretch, after_m)};
}

Pose end_of(const SteeredStretch& stretch) { return pose_after(stretch, stretch.length_m); }

double length(const SteeredPath& path) {
  double sum = 0;
  for (const SteeredStretch& stretch : path) sum += stretch.length_m;
  return sum;
}

int gear_changes(const SteeredPath& path) {
  int changes = 0;
  for (std::size_t i = 1; i < path.size(); ++i) changes += path[i].gear != path[i - 1].gear ? 1 : 0;
  return changes;
}

SteeredStretch arc_from(const Pose& start, double length_m, double curvature, Gear gear) {
  assert(length_m >= 0);
  return {start, length_m, curvature, curvature, gear};
}

SteeredPath retraced(const SteeredPath& path) {
  SteeredPath out;
  for (auto stretch = path.rbegin(); stretch != path.rend(); ++stretch) out.push_back(retraced(*stretch));
  return out;
}

SteeredPath turned_round(const SteeredPath& path) {
  SteeredPath out;
  for (auto stretch = path.rbegin(); stretch != path.rend(); ++stretch)
    out.push_back({about_face(end_of(*stretch)), stretch->length_m, -stretch->curvature_at_end,
                   -stretch->curvature_at_start, stretch->gear});
  return out;
}

SteeredPath mirrored(const SteeredPath& path, const Pose& axis) {
  const Point along = axis.heading.unit();
  SteeredPath out = path;
  for (SteeredStretch& stretch : out) {
    const Point from_axis = stretch.start.at - axis.at;
    stretch.start.at = axis.at + 2 * dot(from_axis, along) * along - from_axis;
    stretch.start.heading = Heading::clockwise_from_north(axis.heading.angle() + axis.heading.angle() -
                                                          stretch.start.heading.angle());
    stretch.curvature_at_start = -stretch.curvature_at_start;
    stretch.curvature_at_end = -stretch.curvature_at_end;
  }
  return out;
}

Path trace(const SteeredPath& path, double sagitta_m) {
  Path out;
  for (const SteeredStretch& stretch : path) {
    if (!(stretch.length_m > 0)) continue;
    const bool clothoid = stretch.clothoid();
    // in reverse the centre is on the other side of the way driven
    const double curvature = clothoid ? 0 : sense(stretch.gear) * stretch.curvature_at_start;
    const double half_circles = std::abs(curvature) * stretch.length_m / std::numbers::pi;
    const std::size_t parts =
        clothoid
            ? chord_count(stretch, sagitta_m)
            : std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(half_circles - kHalfCircleNoise)));
    Point from = stretch.start.at;
    for (std::size_t i = 1; i <= parts; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(parts);
      const Point to = pose_after(stretch, share * stretch.length_m).at;
      add(out, from, to, curvature);
      from = to;
    }
  }
  return out;
}

}  // namespace tramline
