#include "tramline/planner/planning_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/geometry/error.h"
#include "tramline/planner/validate_request.h"

namespace tramline {
namespace {

/// No real field has more tracks than this; the search would never end.
void require_feasible_size(const Field& field, const Machine& machine) {
  constexpr double kMostTracks = 1e5;
  const Box box = bounds(field.outer);
  const double across = std::hypot(box.width(), box.height());
  if (across > kMostTracks * machine.width_m)
    throw bad_input(
        fmt::format("field '{}' is {:.0f} m across, which would take more than {:.0f} tracks of {} m: check "
                    "the coordinates and "
                    "--width",
                    field.id, across, kMostTracks, machine.width_m));
}

void require_line_to_anchor(const PlanSettings& settings) {
  if (settings.ab_anchor != AbAnchor::kEnvelope || settings.guide.size() == 2) return;
  if (settings.guide.empty())
    throw bad_input(
        "--ab-anchor envelope moves a straight line to the edge of the land: give the line with --ab or "
        "--guide, or leave --ab-anchor out");
  throw bad_input(
      "--ab-anchor envelope moves a straight line to the edge of the land, and the line of --guide has "
      "bends: "
      "leave --ab-anchor out");
}

/// Refuses numbers of passes that are not those of the field's edges.
void require_edge_passes(const Field& field, const PlanSettings& settings) {
  const std::vector<int>& passes = settings.headland_edges;
  if (passes.empty()) return;
  if (passes.size() != field.outer.size())
    throw bad_input(fmt::format("field '{}' has {} edges, and numbers of headland passes are given for {}",
                                field.id, field.outer.size(), passes.size()));
  if (passes_everywhere(passes) < 0)
    throw bad_input(fmt::format("an edge of field '{}' cannot have {} headland passes", field.id,
                                passes_everywhere(passes)));
  if (settings.tracks == TrackConstruction::kPaper && passes_everywhere(passes) != passes_anywhere(passes))
    throw bad_input(
        "headlands as in the paper go round the whole field: with --tracks paper give all edges the same "
        "number "
        "of passes");
}

/// The same settings with `headlands` as the largest number by edge, which are left out where they are equal.
void settle_headland_edges(PlanSettings& settings) {
  if (settings.headland_edges.empty()) return;
  settings.headlands = passes_anywhere(settings.headland_edges);
  if (passes_everywhere(settings.headland_edges) == settings.headlands) settings.headland_edges.clear();
}

/// Prices of the land would have to allow for all that detours may work, and prove next to nothing.
void require_no_obstacles(const Field& field) {
  if (std::any_of(field.obstacles.begin(), field.obstacles.end(),
                  [](const Obstacle& o) { return o.kind == ObstacleKind::kObstacle; }))
    throw bad_input(fmt::format(
        "--prove is not for fields with obstacles, and field '{}' has some: leave it out", field.id));
}

}  // namespace

PlanningProblem planning_problem(const Field& field, const Machine& machine, const Objective& objective,
                                 const PlanSettings& settings) {
  require_edge_passes(field, settings);
  PlanningProblem out{field, machine, objective, settings};
  settle_headland_edges(out.settings);
  validate_request(machine, objective, out.settings);
  require_line_to_anchor(settings);
  require_feasible_size(field, machine);
  if (out.settings.prove) require_no_obstacles(field);
  out.settings.ab_anchor = anchor_of(settings);
  if (out.settings.headlands > 0) out.settings.boundary = EdgeKind::kHard;
  return out;
}

}  // namespace tramline
