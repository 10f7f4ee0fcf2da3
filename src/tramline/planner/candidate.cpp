#include "tramline/planner/candidate.h"

#include "tramline/cost/strip_tally.h"
#include "tramline/decomposition/decompose.h"
#include "tramline/tracks/end_rule.h"
#include "tramline/tracks/strip_origin.h"

namespace tramline {
namespace {

TurnedGround turned_ground(const SearchTask& task, const TrackFrame& frame) {
  TurnedGround out{frame.to_track(task.ground.hard), frame.to_track(task.ground.passable), {}};
  if (task.settings.boundary == EdgeKind::kHard) out.field = {{frame.to_track(task.field.outer), {}}};
  return out;
}

SubfieldTracks tracks_in(const SearchTask& task, const Subfield& subfield) {
  const StripGrid grid = strip_grid(subfield, task.machine.width_m);
  const Region turned = grid.frame.to_track(Region{subfield.shape});
  const EndCriterion criterion = end_criterion(task.settings.end_rule, task.objective, task.machine.width_m);
  return strip_pieces(grid, turned.front(), turned_ground(task, grid.frame), criterion, min_length_m(task.machine));
}

}  // namespace

SearchTask search_task(const Field& field, const Machine& machine, const Objective& objective,
                       const PlanSettings& settings) {
  SearchTask task{field, machine, objective, settings, sort_obstacles(field, machine.width_m), 0};
  task.body_m2 = area(task.ground.body);
  return task;
}

Candidate evaluate(const SearchTask& task, Direction sweep) {
  Candidate out;
  out.sweep = sweep;
  out.subfields = decompose(task.ground.plannable, sweep, task.settings);
  for (const Subfield& subfield : out.subfields) out.tracks.push_back(tracks_in(task, subfield));
  out.tally = tally_of(out.subfields, out.tracks, task.body_m2);
  out.cost = cost(task.objective, out.tally);
  return out;
}

}  // namespace tramline
