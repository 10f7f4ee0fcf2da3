#include "tramline/coverage/drive/plan_steps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tramline/coverage/drive/interrupted.h"
#include "tramline/coverage/drive/plan_runs.h"
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
    constexpr double kSliver = 1e-3;
    const double first = sense > 0 ? std::ceil(from / step + kSliver) : std::floor(from / step - kSliver);
    for (double k = first; sense * (k * step - from) < std::abs(turn) - kSliver * step; k += sense) {
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

Region passables(const Field& field) {
  Region out;
  for (const Obstacle& obstacle : field.obstacles)
    if (obstacle.kind == ObstacleKind::kPassable) out.push_back(obstacle.shape);
  return out;
}

/// Of the steps from `first` on.
void interrupt(std::vector<WorkedStep>& steps, std::size_t first, const Region& passable) {
  if (passable.empty()) return;
  for (std::size_t i = first; i < steps.size(); ++i) steps[i].quads = interrupted(steps[i].quads, passable);
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
  interrupt(out, 0, passables(plan.field));
  return out;
}

std::vector<WorkedStep> steps_of(const Plan& plan) {
  std::vector<WorkedStep> out;
  const Region passable = passables(plan.field);
  for (const PlanRun& run : runs_of(plan)) {
    const std::size_t first = out.size();
    append(run.path, plan.machine.width_m, run.run, out);
    if (is_of_pass(plan, run)) interrupt(out, first, passable);
  }
  return out;
}

}  // namespace tramline::coverage
