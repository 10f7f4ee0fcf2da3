#include "tramline/planner/curved/zhou_plan.h"

#include <fmt/format.h>

#include "tramline/cost/zhou_tally.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/path/path_between.h"
#include "tramline/headland/body.h"
#include "tramline/tracks/zhou_tracks.h"

namespace tramline {
void require_zhou_ground(const Field& field, const PlanSettings& settings) {
  if (!obstacle_shapes(field, ObstacleKind::kPassable).empty())
    throw bad_input(
        fmt::format("field '{}' has passable obstacles, which tracks as in the paper do not support; leave "
                    "out --tracks paper or the passable obstacles",
                    field.id));
  if (settings.obstacle_headlands == 0 && !obstacle_shapes(field, ObstacleKind::kObstacle).empty())
    throw bad_input(
        fmt::format("tracks as in the paper end in the headlands of obstacles, and those of field '{}' have "
                    "none; give --obstacle-headlands",
                    field.id));
}

Candidate zhou_plan_along(const SearchTask& task, const std::vector<Point>& line) {
  const double width_m = task.machine.width_m;
  const Region& body = task.ground.plannable;
  const Path reference = extended_over(line, width_m, body);
  const Point half_way = path_between(reference, 0, 0.5 * length(reference)).back().to;
  const Direction whole = Direction::along(reference.front().from, half_way);
  LaidTracks tracks = zhou_tracks(line, width_m, body, min_length_m(task.machine));
  ZhouTally found = zhou_tally(tracks, width_m, task.ground.body);
  Candidate out;
  for (const Polygon& part : body) {
    out.subfields.push_back({part, whole, reference});
    out.families.push_back({tracks.grid, {}});
    out.avoided.tracks.push_back({tracks.grid, {}, {}});
  }
  // A piece's branch is the part of the body it lies in.
  for (LaidPiece& piece : tracks.pieces)
    out.avoided.tracks[static_cast<std::size_t>(piece.branch)].pieces.push_back(std::move(piece));
  for (LaidPiece& piece : tracks.dropped)
    out.avoided.tracks[static_cast<std::size_t>(piece.branch)].dropped.push_back(std::move(piece));
  for (const LaidTracks& part : out.avoided.tracks) found.tally.subfields += part.pieces.empty() ? 0 : 1;
  out.avoided.tally = found.tally;
  out.avoided.cost = cost(task.objective, found.tally);
  out.worked = std::move(found.worked);
  return out;
}

std::optional<Candidate> zhou_plan_along_best(const SearchTask& task, const SearchContext& context) {
  const std::optional<BestCurve> found = best_curved(task, context);
  if (!found) return std::nullopt;
  return zhou_plan_along(task, found->line);
}

}  // namespace tramline
