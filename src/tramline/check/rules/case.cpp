#include "tramline/check/rules/case.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "tramline/check/measure/edge_runs.h"
#include "tramline/check/measure/near_land.h"
#include "tramline/check/measure/plan_facts.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {
namespace {

/// Obstacles the machine may not enter that have no headland.
BoundedRegion without_headland(const Plan& plan) {
  BoundedRegion out;
  for (std::size_t i = 0; i < plan.field.obstacles.size(); ++i) {
    const Obstacle& obstacle = plan.field.obstacles[i];
    if (obstacle.kind == ObstacleKind::kObstacle && passes_round(plan, i) == 0)
      out.push_back({&obstacle.shape, bounds(obstacle.shape)});
  }
  return out;
}

/// Land beside the boundaries that have headlands, as deep as these or as so many passes, and round obstacles
/// the clearance.
class Surroundings {
 public:
  Surroundings(const Plan& plan, int most_passes)
      : width_m_(plan.machine.width_m),
        most_passes_(most_passes),
        plain_(plan.headland.construction == HeadlandConstruction::kPlain) {
    add(plan.field.outer, passes_round_field(plan), 0);
    add_along_edges(plan);
    const double clearance_m = plan.settings.clearance_m;
    Region holes;
    for (std::size_t i = 0; i < plan.field.obstacles.size(); ++i) {
      const int passes = passes_round(plan, i);
      if (passes <= 0) continue;
      const Polygon shape = oriented(plan.field.obstacles[i].shape);
      add(reversed(shape.outer), passes, clearance_m);
      for (const Ring& hole : shape.holes) {
        const Region inside{{reversed(hole), {}}};
        const Region kept = clearance_m > 0 ? moved_inwards(inside, clearance_m) : inside;
        holes.insert(holes.end(), kept.begin(), kept.end());
      }
    }
    land_ = unite(land_);
    if (!holes.empty()) land_ = difference(land_, unite(holes));
  }

  Region land() const { return land_; }
  /// Chords on both sides of the comparison.
  double round_edges_m2() const {
    return (kRoundEdge_m + kFanSagitta_m) * arcs_m_ + kThinnestShown_m * moved_edges_m_;
  }

 private:
  void add(const Ring& ring, int all_passes, double clearance_m) {
    const int passes = std::min(all_passes, most_passes_);
    if (passes <= 0) return;
    if (plain_) {
      add_plain(ring, passes, clearance_m);
      return;
    }
    const double deep_m = clearance_m + passes * width_m_;
    for (Polygon& part : land_near(ring, deep_m)) land_.push_back(std::move(part));
    arcs_m_ += arcs_about_corners_m(ring, deep_m);
  }

  /// Where some edges have more passes than others.
  void add_along_edges(const Plan& plan) {
    if (plan.headland.edge_passes.size() != plan.field.outer.size()) return;
    const int most = std::min(most_passes_, passes_along_edges(plan));
    for (int number = passes_round_field(plan) + 1; number <= most; ++number)
      for (const EdgeRun& run : edge_runs(plan, number)) {
        for (Polygon& part : land_beside(run, plan.field.outer, number * width_m_))
          land_.push_back(std::move(part));
        arcs_m_ += arcs_beside_m(run, number * width_m_);
      }
  }

  /// Pass by pass as in Zhou §2.3.3: half a width, whole ones, and half a width.
  void add_plain(const Ring& ring, int passes, double clearance_m) {
    const bool inwards = signed_area(ring) > 0;
    const Region whole{{inwards ? ring : reversed(ring), {}}};
    Region last = whole;
    for (int i = 0; i <= passes; ++i) {
      const double by_m = (i == 0 ? clearance_m : 0) + (i == 0 || i == passes ? 0.5 : 1) * width_m_;
      last = inwards ? moved_inwards(last, by_m) : moved_outwards(last, by_m);
    }
    const Region beside = inwards ? difference(whole, last) : last;
    land_.insert(land_.end(), beside.begin(), beside.end());
    moved_edges_m_ += perimeter(ring) * (passes + 1);
  }

  double width_m_;
  int most_passes_;
  bool plain_;
  double moved_edges_m_ = 0;
  Region land_;
  double arcs_m_ = 0;
};

/// On passables the work is interrupted: the area there is deducted as often as it is driven over.
double worked_by_passes_m2(const Plan& plan, const std::vector<WorkedPart>& passes,
                           const BoundedRegion& passables) {
  double sum = 0;
  for (const HeadlandPass& pass : plan.headland.passes) sum += plan.machine.width_m * length(pass.path);
  for (const WorkedPart& part : passes) sum -= area_common_to(part.ground, passables);
  return sum;
}

std::optional<WithPasses> with_passes_of(const Case& c) {
  const Headland& headland = c.plan.headland;
  if (c.plan.figures == PlanFigures::kTracks || (headland.passes.empty() && headland.ground.empty()))
    return std::nullopt;
  WithPasses out;
  const std::vector<WorkedPart> passes = pass_parts(c.plan);
  out.land = unite(c.plan.body, headland.ground);
  out.parts = c.parts;
  out.parts.insert(out.parts.end(), passes.begin(), passes.end());
  out.worked = worked_on(out.land, out.parts, c.plan.pieces.size() + headland.passes.size());
  out.passes_m2 = worked_by_passes_m2(c.plan, passes, c.passables);
  return out;
}

}  // namespace

const Region& counted_land(const Case& c) { return c.with_passes ? c.with_passes->land : c.plan.body; }
const std::vector<WorkedPart>& counted_parts(const Case& c) {
  return c.with_passes ? c.with_passes->parts : c.parts;
}
const WorkedLand& counted_work(const Case& c) { return c.with_passes ? c.with_passes->worked : c.worked; }

Case::Case(const Plan& of)
    : plan(of),
      obstacles(bounded_obstacles(of.field, ObstacleKind::kObstacle)),
      blocking(without_headland(of)),
      passables(bounded_obstacles(of.field, ObstacleKind::kPassable)),
      given_up(bounded(of.given_up)),
      area_tolerance_m2(
          std::max(kAreaShare * area(Polygon{of.field.outer, {}}), kGridSize * perimeter(of.field.outer))),
      lines(of),
      parts(worked_parts(of)),
      worked(worked_on(of.body, parts, of.pieces.size())) {
  with_passes = with_passes_of(*this);
  for (const Obstacle& obstacle : of.field.obstacles) obstacle_boxes.push_back(bounds(obstacle.shape));
  const Surroundings surroundings(of, std::numeric_limits<int>::max());
  near_boundaries = surroundings.land();
  round_edges_m2 = surroundings.round_edges_m2();
  if (!near_boundaries.empty()) along_boundaries = Surroundings(of, 1).land();
}

}  // namespace tramline::check
