#include "tramline/planner/curved_plan.h"

#include <utility>

#include "tramline/geometry/path_between.h"
#include "tramline/planner/curved_encounters.h"
#include "tramline/planner/curved_layers.h"
#include "tramline/planner/curved_overlaps.h"
#include "tramline/planner/driven_tracks.h"
#include "tramline/planner/finished_plan.h"
#include "tramline/planner/warnings.h"
#include "tramline/planner/whole_figures.h"

namespace tramline {

Plan finished_plan(const SearchTask& task, const CurvedCandidate& candidate) {
  require_tracks(task, candidate.tally);
  Plan plan = bare_plan(task);
  const Path& line = candidate.reference;
  const Point half_way = path_between(line, 0, 0.5 * length(line)).back().to;
  const Direction whole = Direction::along(line.front().from, half_way);
  for (const Polygon& part : task.ground.plannable) plan.subfields.push_back({part, whole, line});
  const bool curved = line.size() > 1 || !line.front().straight();
  const bool paper = task.settings.tracks == TrackConstruction::kPaper;
  const Writing writing{task.machine.width_m, curved || !paper};
  Driven driven = driven_tracks(candidate.tracks, task.ground.plannable, task.field, writing);
  plan.encounters = encounters_as_driven(task, candidate, driven);
  plan.pieces = std::move(driven.pieces);
  add_overlaps(plan);
  for (const LaidPiece& piece : candidate.tracks.dropped)
    plan.dropped.push_back({piece.path.front().from, piece.path.back().to,
                            subfield_of(task.ground.plannable, piece, task.machine.width_m)});
  set_figures(plan, candidate.tally);
  plan.directions_tried = 1;
  if (paper)
    add_kinked_layers(plan, candidate);
  else
    add_curved_layers(plan);
  plan.warnings = warnings_about(plan);
  return plan;
}

}  // namespace tramline
