#include "tramline/planner/planning_problem.h"

#include <fmt/format.h>

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

}  // namespace

PlanningProblem planning_problem(const Field& field, const Machine& machine, const Objective& objective,
                                 const PlanSettings& settings) {
  validate_request(machine, objective, settings);
  require_line_to_anchor(settings);
  require_feasible_size(field, machine);
  PlanningProblem out{field, machine, objective, settings};
  out.settings.ab_anchor = anchor_of(settings);
  if (settings.headlands > 0) out.settings.boundary = EdgeKind::kHard;
  return out;
}

}  // namespace tramline
