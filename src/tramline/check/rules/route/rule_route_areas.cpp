#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tramline/check/rules/route/route_facts.h"
#include "tramline/check/rules/rules.h"
#include "tramline/coverage/drive/plan_steps.h"
#include "tramline/coverage/evaluate.h"

namespace tramline::check {
namespace {

/// Steps of the pieces and passes that legs work, in driving order, each as a run of its own. Interrupted
/// passes are whole: their steps work nothing on passable obstacles.
std::vector<coverage::WorkedStep> driven_steps(const Plan& plan) {
  std::map<int, std::vector<coverage::WorkedStep>> by_run;
  for (coverage::WorkedStep& step : coverage::steps_of(plan)) by_run[step.run].push_back(std::move(step));
  std::vector<coverage::WorkedStep> out;
  std::vector<bool> begun(plan.headland.passes.size(), false);
  int run = 0;
  const auto drive = [&](std::size_t planned_run) {
    for (coverage::WorkedStep step : by_run[static_cast<int>(planned_run)]) {
      step.run = run;
      step.fix = out.size();
      out.push_back(std::move(step));
    }
    ++run;
  };
  for (const RouteLeg& leg : plan.route.legs) {
    if (leg.piece && *leg.piece < plan.pieces.size()) drive(*leg.piece);
    if (!leg.work || !leg.pass || *leg.pass >= begun.size() || begun[*leg.pass]) continue;
    begun[*leg.pass] = true;
    drive(plan.pieces.size() + *leg.pass);
  }
  return out;
}

/// The sides of the swath along arcs are chords in the engine, exact circles in the tally.
double chords_m2(const Plan& plan) {
  double arcs_m = 0;
  const auto add = [&](const Path& path) {
    for (const PathSegment& segment : path)
      if (!segment.straight()) arcs_m += length(segment) + std::abs(turning(segment)) * plan.machine.width_m;
  };
  for (const TrackPiece& piece : plan.pieces) add(centre_line(piece));
  for (const HeadlandPass& pass : plan.headland.passes) add(pass.path);
  return 2 * coverage::kPlanSagitta_m * arcs_m;
}

}  // namespace

void check_route_areas(const Case& c, Violations& out) {
  const Plan& plan = c.plan;
  if (!plan.route.planned()) return;
  // Swaths along kinks overlap themselves in mitres, which steps square to the path do not have.
  if (plan.settings.tracks == TrackConstruction::kPaper ||
      plan.headland.construction == HeadlandConstruction::kPlain)
    return;
  // In files of earlier versions the tally is that of tracks alone.
  if (plan.figures != PlanFigures::kTracksAndPasses) return;
  coverage::EvaluateSettings settings;
  settings.shapes = false;
  const Region& land = counted_land(c);
  const CoverageAreas found =
      coverage::evaluate(driven_steps(plan), plan.machine.width_m, land, settings).areas;
  const double tolerance_m2 = c.area_tolerance_m2 + chords_m2(plan);
  const auto compare = [&](const char* what, double driven_m2, double stated_m2) {
    if (std::abs(driven_m2 - stated_m2) <= tolerance_m2) return;
    out.push_back(
        {Rule::kRouteAreas,
         fmt::format("the route {} {:.4f} m², the plan states {:.4f} m²", what, driven_m2, stated_m2),
         plan.route.legs.front().path.front().start.at, driven_m2 - stated_m2});
  };
  compare("works", found.gross_m2, plan.tally.worked_m2);
  compare("works in vain", found.gross_m2 - found.covered_inside_m2, plan.tally.overlap_m2);
  compare("misses", found.missed_m2, plan.tally.uncovered_m2);
}

}  // namespace tramline::check
