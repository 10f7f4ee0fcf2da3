#include "tramline/planner/recursive_plan.h"

#include <fmt/format.h>

#include "tramline/cost/recursive_tally.h"
#include "tramline/geometry/error.h"
#include "tramline/headland/body.h"
#include "tramline/tracks/recursive_tracks.h"

namespace tramline {
void require_paper_ground(const Field& field, const PlanSettings& settings) {
  if (!obstacle_shapes(field, ObstacleKind::kPassable).empty())
    throw bad_input(fmt::format(
        "field '{}' has passable obstacles, which tracks as in the paper know nothing of; leave --tracks "
        "paper or the passable obstacles out",
        field.id));
  if (settings.obstacle_headlands == 0 && !obstacle_shapes(field, ObstacleKind::kObstacle).empty())
    throw bad_input(
        fmt::format("tracks as in the paper end in the headlands of obstacles, and those of field '{}' have "
                    "none; give --obstacle-headlands",
                    field.id));
}

CurvedCandidate recursive_along(const SearchTask& task, const std::vector<Point>& line) {
  const double width_m = task.machine.width_m;
  const Region& body = task.ground.plannable;
  CurvedCandidate out;
  out.line = line;
  out.reference = extended_over(line, width_m, body);
  out.tracks = recursive_tracks(line, width_m, body, min_length_m(task.machine));
  RecursiveTally found = recursive_tally(out.tracks, width_m, task.ground.body);
  out.tally = found.tally;
  out.worked = std::move(found.worked);
  count_subfields(task, out);
  return out;
}

std::optional<CurvedCandidate> recursive_along_best(const SearchTask& task, int threads) {
  const std::optional<CurvedCandidate> found = best_curved(task, threads);
  if (!found) return std::nullopt;
  return recursive_along(task, found->line);
}

}  // namespace tramline
