#include "tramline/planner/finished_plan.h"

#include <fmt/format.h>

#include <utility>

#include "tramline/cost/piece_overlap.h"
#include "tramline/cost/worked_regions.h"
#include "tramline/cost/worked_rows.h"
#include "tramline/geometry/boolean.h"
#include "tramline/geometry/error.h"
#include "tramline/headland/body.h"
#include "tramline/headland/headland.h"
#include "tramline/planner/driving_order.h"
#include "tramline/planner/encounters_as_driven.h"
#include "tramline/planner/pulse.h"
#include "tramline/planner/warnings.h"
#include "tramline/planner/whole_figures.h"
#include "tramline/planner/worked_layers.h"

namespace tramline {
namespace {

std::vector<DroppedPiece> dropped_pieces(const Candidate& candidate) {
  std::vector<DroppedPiece> out;
  for (std::size_t i = 0; i < candidate.avoided.tracks.size(); ++i) {
    const StripGrid& grid = candidate.avoided.tracks[i].grid;
    for (const LaidPiece& piece : candidate.avoided.tracks[i].dropped) {
      const double across = grid.centre(piece.track);
      out.push_back({grid.frame.to_field({across, piece.from}), grid.frame.to_field({across, piece.to}),
                     static_cast<int>(i)});
    }
  }
  return out;
}

/// The ground of all swaths in few regions.
std::vector<Region> worked_grounds(const Candidate& candidate, const std::vector<TrackPiece>& pieces,
                                   double width_m) {
  std::vector<Region> out;
  for (const LaidTracks& tracks : candidate.avoided.tracks) out.push_back(worked_rows(tracks));
  Region detours;
  for (const TrackPiece& piece : pieces)
    for (const Detour& detour : piece.detours)
      detours.push_back({band(detour.path, width_m, kLayerSagitta), {}});
  out.push_back(unite(detours));
  return out;
}

Region swath_parts(const Plan& plan) {
  Region out;
  for (const TrackPiece& piece : plan.pieces)
    for (Ring& part : swath_parts(piece, plan.machine.width_m, kLayerSagitta))
      out.push_back({std::move(part), {}});
  return out;
}

/// Is there ground to work without the clearance, and none with it?
bool clearance_takes_all(const SearchTask& task) {
  return task.settings.clearance_m > 0 && area(task.ground.plannable) == 0 &&
         area(sort_obstacles(task.field, task.machine.width_m).plannable) > 0;
}

Error no_tracks(const SearchTask& task) {
  const double clearance_m = task.settings.clearance_m;
  if (clearance_takes_all(task))
    return bad_input(
        fmt::format("no track fits into field '{}' of {:.0f} m²: the clearance of {} m from obstacles leaves "
                    "no ground to work; use a smaller --clearance",
                    task.field.id, area_m2(task.field), clearance_m));
  const bool kept_clear = clearance_m > 0 && !obstacle_shapes(task.field, ObstacleKind::kObstacle).empty();
  return bad_input(fmt::format(
      "no track fits into field '{}' of {:.0f} m² with a working width of {} m{} and pieces of at least {} "
      "m: use a narrower machine, a smaller --min-length{} or another end rule",
      task.field.id, area_m2(task.field), task.machine.width_m,
      kept_clear ? fmt::format(", a clearance of {} m from obstacles", clearance_m) : "",
      min_length_m(task.machine), kept_clear ? ", a smaller --clearance" : ""));
}

}  // namespace

void require_tracks(const SearchTask& task, const Tally& tally) {
  const bool worked_by_passes = task.headland.worked_m2 > area(task.ground.body);
  if (tally.pieces == 0 && !worked_by_passes) throw no_tracks(task);
}

Plan bare_plan(const SearchTask& task) {
  Plan plan;
  plan.field = task.field;
  plan.machine = task.machine;
  plan.objective = task.objective;
  plan.settings = task.settings;
  plan.body = task.ground.body;
  plan.given_up = task.ground.given_up;
  plan.headland = task.headland;
  if (!plan.headland.ground.empty())
    plan.headland.unworked = unworked_ground(plan.headland, task.machine.width_m);
  return plan;
}

Plan finished_plan(const SearchTask& task, SearchResult found) {
  require_tracks(task, found.best.avoided.tally);
  Plan plan = bare_plan(task);
  plan.pieces = driving_order(task, found.best);
  plan.dropped = dropped_pieces(found.best);
  beat();
  const std::vector<double> overlaps =
      overlap_by_piece(plan.body, found.best.subfields, plan.pieces, plan.machine.width_m);
  for (std::size_t i = 0; i < overlaps.size(); ++i) plan.pieces[i].overlap_m2 = overlaps[i];
  beat();
  plan.encounters = encounters_as_driven(task, found.best, plan.pieces);
  beat();
  std::vector<Region> grounds = worked_grounds(found.best, plan.pieces, plan.machine.width_m);
  plan.subfields = std::move(found.best.subfields);
  if (!task.settings.guide.empty())
    for (Subfield& subfield : plan.subfields)
      subfield.reference = straight_path(task.settings.guide.front(), task.settings.guide.back());
  set_figures(plan, found.best.avoided.tally);
  plan.directions_tried = found.directions_tried;
  plan.proof = whole_proof(task, found, plan);
  beat();
  add_layers(plan, {std::move(grounds), common_to_two(swath_parts(plan))});
  plan.warnings = warnings_about(plan);
  return plan;
}

}  // namespace tramline
