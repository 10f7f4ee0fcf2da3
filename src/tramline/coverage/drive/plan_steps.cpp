#include "tramline/coverage/drive/plan_steps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tramline/coverage/drive/interrupted.h"
#include "tramline/geometry/path/path.h"

namespace tramline::coverage {
namespace {

/// A place on a path and the way it goes there.
struct Pose {
  Point position;
  Point direction;  ///< unit vector
};

/// Of the chords of an arc: π over a power of two, so that concentric arcs side by side share their corners,
/// and neither gaps nor overlaps of a chord's height come between their swaths.
double step_of(const PathSegment& arc, double width_m) {
  const double outer_m = radius(arc) + width_m / 2;
  const double widest = 2 * std::acos(1 - std::min(1.0, kPlanSagitta_m / outer_m));
  double step = std::numbers::pi;
  while (step > widest) step /= 2;
  return step;
}

/// From one end of the segment to the other; on an arc at its ends and at all multiples of the step about its
/// centre.
std::vector<Pose> poses(const PathSegment& segment, double width_m) {
  const Point start = direction_at_start(segment);
  std::vector<Pose> out{{segment.from, start}};
  if (!segment.straight()) {
    const Point middle = centre(segment);
    const Point spoke = segment.from - middle;
    const double step = step_of(segment, width_m);
    const double turn = turning(segment);
    const double sense = turn > 0 ? 1 : -1;
    const double from = std::atan2(spoke.y, spoke.x);
    // Corners nearer to the ends than this share of a step would make slivers.
    constexpr double kNear = 1e-3;
    const double first = sense > 0 ? std::ceil(from / step + kNear) : std::floor(from / step - kNear);
    for (double k = first; sense * (k * step - from) < std::abs(turn) - kNear * step; k += sense) {
      const double angle = k * step - from;
      out.push_back({middle + turned(spoke, angle), turned(start, angle)});
    }
  }
  out.push_back({segment.to, direction_at_end(segment)});
  return out;
}

Quad quad_between(const Pose& rear, const Pose& front, double width_m) {
  const auto left = [&](const Pose& pose) {
    return (width_m / 2) * Point{-pose.direction.y, pose.direction.x};
  };
  return {rear.position + left(rear), rear.position - left(rear), front.position - left(front),
          front.position + left(front)};
}

void append(const Path& path, double width_m, int run, std::vector<WorkedStep>& out) {
  double travel_m = 0;
  for (const PathSegment& segment : path) {
    const std::vector<Pose> along = poses(segment, width_m);
    for (std::size_t i = 1; i < along.size(); ++i) {
      const double step_m = distance(along[i - 1].position, along[i].position);
      travel_m += step_m;
      out.push_back(
          {{quad_between(along[i - 1], along[i], width_m)}, run, travel_m, step_m + width_m, out.size()});
    }
  }
}

}  // namespace

std::vector<WorkedStep> plan_steps(const Plan& plan) {
  std::vector<WorkedStep> out;
  int run = 0;
  for (const TrackPiece& piece : plan.pieces) append(centre_line(piece), plan.machine.width_m, run++, out);
  return out;
}

std::vector<WorkedStep> headland_steps(const Plan& plan, int first_run) {
  std::vector<WorkedStep> out;
  int run = first_run;
  for (const HeadlandPass& pass : plan.headland.passes) append(pass.path, plan.machine.width_m, run++, out);
  Region passable;
  for (const Obstacle& obstacle : plan.field.obstacles)
    if (obstacle.kind == ObstacleKind::kPassable) passable.push_back(obstacle.shape);
  if (!passable.empty())
    for (WorkedStep& step : out) step.quads = interrupted(step.quads, passable);
  return out;
}

std::vector<WorkedStep> steps_of(const Plan& plan) {
  std::vector<WorkedStep> out = plan_steps(plan);
  for (WorkedStep& step : headland_steps(plan, static_cast<int>(plan.pieces.size())))
    out.push_back(std::move(step));
  for (std::size_t i = 0; i < out.size(); ++i) out[i].fix = i;
  return out;
}

}  // namespace tramline::coverage
