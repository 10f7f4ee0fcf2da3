#include "tramline/planner/candidate.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "tramline/cost/strip_tally.h"
#include "tramline/decomposition/decompose.h"
#include "tramline/geometry/error.h"
#include "tramline/tracks/end_rule.h"
#include "tramline/tracks/strip_origin.h"

namespace tramline {
namespace {

TurnedGround turned_ground(const SearchTask& task, const TrackFrame& frame) {
  TurnedGround out{frame.to_track(task.ground.hard), frame.to_track(task.ground.passable), {}};
  if (task.settings.boundary == EdgeKind::kHard) out.field = {{frame.to_track(task.field.outer), {}}};
  return out;
}

/// What a subfield's tracks cost by themselves, borders with other subfields taken as plain edges.
double own_cost(const SearchTask& task, const Subfield& subfield, const SubfieldTracks& tracks) {
  return cost(task.objective, tally_of({subfield}, {tracks}, area(subfield.shape)));
}

/// The tracks on the cheapest of the grids S1.13 leaves open; among equals the first.
SubfieldTracks tracks_in(const SearchTask& task, const Subfield& subfield) {
  const std::vector<StripGrid> grids = strip_grids(subfield, task.machine.width_m);
  const TrackFrame& frame = grids.front().frame;
  const Region turned = frame.to_track(Region{subfield.shape});
  const TurnedGround ground = turned_ground(task, frame);
  const EndCriterion criterion = end_criterion(task.settings.end_rule, task.objective, task.machine.width_m);
  std::optional<SubfieldTracks> best;
  double least = 0;
  for (const StripGrid& grid : grids) {
    SubfieldTracks tracks = strip_pieces(grid, turned.front(), ground, criterion, min_length_m(task.machine));
    const double own = grids.size() > 1 ? own_cost(task, subfield, tracks) : 0;
    if (best && own >= least) continue;
    least = own;
    best = std::move(tracks);
  }
  return *best;
}

/// More tracks than this no field has; the search would never end.
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

}  // namespace

SearchTask search_task(const Field& field, const Machine& machine, const Objective& objective,
                       const PlanSettings& settings) {
  require_feasible_size(field, machine);
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
