#include "tramline/io/mission/way_points.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/model/speeds.h"

namespace tramline::io {
namespace {

/// Points nearer to one another than this are one, m: a tenth of what receivers resolve.
constexpr double kSamePlace_m = 1e-3;
/// Turning between two points, rad, at most: an arc of a tenth of a metre is not to become a line.
constexpr double kMostTurning_rad = 0.5;

/// So many chords follow the stretch within the tolerance: a chord of length s deviates from a circle of
/// curvature κ by κ·s²/8.
int chords_of(const SteeredStretch& stretch, double tolerance_m) {
  const double curvature = std::max(std::abs(stretch.curvature_at_start), std::abs(stretch.curvature_at_end));
  if (curvature == 0) return 1;
  const double longest_m = std::min(std::sqrt(8 * tolerance_m / curvature), kMostTurning_rad / curvature);
  return std::max(1, static_cast<int>(std::ceil(stretch.length_m / longest_m)));
}

void add(std::vector<WayPoint>& points, const WayPoint& point) {
  // At the end of one leg and the start of the next the first of the two is kept.
  if (points.empty() || distance(points.back().at, point.at) >= kSamePlace_m) points.push_back(point);
}

}  // namespace

std::vector<WayPoint> way_points(const Plan& plan, double tolerance_m) {
  assert(plan.route.planned() && tolerance_m > 0);
  std::vector<WayPoint> out;
  for (const RouteLeg& leg : plan.route.legs) {
    const double speed_mps = speed_of(leg, plan.machine.turning);
    for (const SteeredStretch& stretch : leg.path) {
      const auto reached = [&](const Pose& pose) {
        return WayPoint{pose.at, pose.heading, stretch.gear, speed_mps, leg.work};
      };
      add(out, reached(stretch.start));
      const int chords = chords_of(stretch, tolerance_m);
      for (int i = 1; i <= chords; ++i) add(out, reached(pose_after(stretch, stretch.length_m * i / chords)));
    }
  }
  return out;
}

double length_of(const std::vector<WayPoint>& route) {
  double out = 0;
  for (std::size_t i = 0; i + 1 < route.size(); ++i) out += distance(route[i].at, route[i + 1].at);
  return out;
}

}  // namespace tramline::io
