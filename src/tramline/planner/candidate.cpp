#include "tramline/planner/candidate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tramline/cost/strip_tally.h"
#include "tramline/decomposition/decompose.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/turned_ground.h"
#include "tramline/tracks/end_rule.h"
#include "tramline/tracks/strip_origin.h"

namespace tramline {
namespace {

/// What a subfield's tracks cost by themselves, borders with other subfields taken as plain edges.
double own_cost(const SearchTask& task, const Subfield& subfield, const SubfieldTracks& tracks) {
  return cost(task.objective, tally_of({subfield}, {tracks}, area(subfield.shape)));
}

/// The strips of the cheapest of the grids S1.13 leaves open, tracks cut; among equals the first.
Strips strips_in(const SearchTask& task, const Subfield& subfield) {
  const std::vector<StripGrid> grids = strip_grids(subfield, task.machine.width_m);
  const TrackFrame& frame = grids.front().frame;
  const Region turned = frame.to_track(Region{subfield.shape});
  const TurnedGround ground = turned_ground(task, frame);
  const EndCriterion criterion = end_criterion(task.settings.end_rule, task.objective, task.machine.width_m);
  std::optional<Strips> best;
  double least = 0;
  for (const StripGrid& grid : grids) {
    Strips strips = strips_of(grid, turned.front(), ground, criterion);
    const double own =
        grids.size() > 1 ? own_cost(task, subfield, cut_pieces(strips, min_length_m(task.machine))) : 0;
    if (best && own >= least) continue;
    least = own;
    best = std::move(strips);
  }
  return std::move(*best);
}

AvoidanceTask avoidance_task(const SearchTask& task, const Candidate& candidate) {
  return {task.field,    task.ground,         task.machine,     task.objective,
          task.settings, candidate.subfields, candidate.strips, task.body_m2};
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
  SearchTask task{
      field, machine, objective, settings, sort_obstacles(field, machine.width_m, settings.clearance_m), 0};
  task.body_m2 = area(task.ground.body);
  return task;
}

Candidate evaluate(const SearchTask& task, Direction sweep) {
  Candidate out;
  out.sweep = sweep;
  out.subfields = decompose(task.ground.plannable, sweep, task.settings);
  for (const Subfield& subfield : out.subfields) out.strips.push_back(strips_in(task, subfield));
  out.avoided = choose_detours(avoidance_task(task, out));
  return out;
}

std::vector<Encounter> encounters_of(const SearchTask& task, const Candidate& candidate) {
  return encounters_in(avoidance_task(task, candidate), candidate.avoided);
}

int first_track(const Candidate& candidate, std::size_t subfield) {
  const std::vector<StripPiece>& pieces = candidate.avoided.tracks[subfield].pieces;
  int first = pieces.empty() ? std::numeric_limits<int>::max() : pieces.front().strip;
  for (const Strip& strip : candidate.strips[subfield].strips)
    if (!hard_gaps(strip).empty()) first = std::min(first, strip.index);
  return first;
}

}  // namespace tramline
