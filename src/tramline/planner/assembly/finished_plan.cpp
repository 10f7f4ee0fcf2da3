#include "tramline/planner/assembly/finished_plan.h"

#include <fmt/format.h>

#include <utility>

#include "tramline/cost/worked/kinked_overlap.h"
#include "tramline/cost/worked/piece_overlap.h"
#include "tramline/geometry/error.h"
#include "tramline/headland/body.h"
#include "tramline/headland/headland.h"
#include "tramline/planner/assembly/driven_tracks.h"
#include "tramline/planner/assembly/encounters_as_driven.h"
#include "tramline/planner/assembly/track_ground.h"
#include "tramline/planner/assembly/whole_figures.h"
#include "tramline/planner/candidate/anchored_guide.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/warnings.h"
#include "tramline/route/build/driven_over.h"
#include "tramline/route/turning/planned_turns.h"
#include "tramline/route/turning/stops.h"

namespace tramline {
namespace {

std::vector<DroppedPiece> dropped_pieces(const Candidate& candidate, const Machine& machine) {
  std::vector<DroppedPiece> out;
  for (std::size_t i = 0; i < candidate.avoided.tracks.size(); ++i) {
    const LaidTracks& tracks = candidate.avoided.tracks[i];
    for (const LaidPiece& piece : tracks.dropped) {
      const Path line = line_of(piece, tracks.grid);
      out.push_back({line.front().from, line.back().to, i, why_dropped(piece, machine)});
    }
  }
  return out;
}

void settle_overlaps(Plan& plan, const std::vector<Subfield>& subfields) {
  const double width_m = plan.machine.width_m;
  const bool kinked = plan.settings.tracks == TrackConstruction::kPaper;
  const std::vector<double> overlaps = kinked ? overlap_by_kinked_piece(plan.body, plan.pieces, width_m)
                                              : overlap_by_piece(plan.body, subfields, plan.pieces, width_m);
  for (std::size_t i = 0; i < overlaps.size(); ++i) plan.pieces[i].overlap_m2 = overlaps[i];
}

/// Straight tracks along a line that was given follow it, or the side of the envelope in its place.
void add_guide(const SearchTask& task, std::vector<Subfield>& subfields) {
  if (task.settings.guide.empty() || subfields.empty()) return;
  const std::vector<Point> guide = anchored_guide(task);
  for (Subfield& subfield : subfields)
    if (subfield.reference.empty()) subfield.reference = straight_path(guide.front(), guide.back());
}

/// Fills in the route and marks the ends without a way off; returns their number.
int add_route(const AllowedLand& land, PlannedRoute route, Plan& plan) {
  plan.route.legs = std::move(route.legs);
  plan.settings.route.start = route.start;
  plan.settings.route.end = route.end;
  plan.stop_rule = StopRule::kNoWayOff;
  add_driven_over(plan);
  return mark_stops(land, plan.machine, plan.pieces);
}

/// What leaves tracks more land, besides what always does.
const char* more_land(const PlanSettings& settings) {
  if (settings.headlands > 0) return "fewer --headlands";
  return settings.boundary == EdgeKind::kHard ? "--boundary soft, by which swaths may run past the edge"
                                              : "another end rule";
}

Error no_tracks(const SearchTask& task) {
  const double clearance_m = task.settings.clearance_m;
  if (task.clearance_takes_all)
    return bad_input(
        fmt::format("no track fits into field '{}' of {:.0f} m²: the clearance of {} m from obstacles leaves "
                    "no land to work; use a smaller --clearance",
                    task.field.id, area_m2(task.field), clearance_m));
  const bool kept_clear = clearance_m > 0 && !obstacle_shapes(task.field, ObstacleKind::kObstacle).empty();
  return bad_input(fmt::format(
      "no track fits into field '{}' of {:.0f} m² with a working width of {} m{} and pieces of at least {} "
      "m: use a narrower machine, a smaller --min-length{} or {}",
      task.field.id, area_m2(task.field), task.machine.width_m,
      kept_clear ? fmt::format(", a clearance of {} m from obstacles", clearance_m) : "",
      min_length_m(task.machine), kept_clear ? ", a smaller --clearance" : "", more_land(task.settings)));
}

/// Everything that the task determines: no tracks.
Plan bare_plan(const SearchTask& task) {
  Plan plan;
  plan.field = task.field;
  plan.machine = task.machine;
  plan.objective = task.objective;
  plan.settings = task.settings;
  plan.body = task.ground.body;
  plan.given_up = task.ground.given_up;
  plan.left_out = task.given.left_out;
  plan.worked = task.given.worked;
  std::vector<std::string>& remarks = plan.settings.given.remarks;
  remarks.insert(remarks.end(), task.given.remarks.begin(), task.given.remarks.end());
  plan.headland = task.headland;
  return plan;
}

}  // namespace

void require_tracks(const SearchTask& task, const Tally& tally) {
  const bool worked_by_passes = task.headland.worked_m2 > area(task.ground.body);
  if (tally.pieces == 0 && !worked_by_passes) throw no_tracks(task);
}

PlanDraft drafted(const SearchTask& task, const SearchResult& found) {
  require_tracks(task, found.best.avoided.tally);
  PlanDraft out;
  Plan& plan = out.plan;
  plan = bare_plan(task);
  out.driven = driven_tracks(task, found.best);
  plan.pieces = std::move(out.driven.pieces);
  plan.directions_tried = found.directions_tried;
  plan.subfields = found.best.subfields;
  plan.dropped = dropped_pieces(found.best, task.machine);
  Tally tracks = found.best.avoided.tally;
  if (plan.settings.turns == TurnPlanning::kTurns) tracks.stops = plan_turns(task.turning_land, plan);
  if (out.driven.route) {
    out.parts = out.driven.route->parts;
    out.gave_up = out.driven.route->gave_up;
    out.reached = out.driven.route->reached;
    tracks.stops = add_route(task.turning_land, *std::exchange(out.driven.route, std::nullopt), plan);
  }
  set_figures(plan, tracks);
  return out;
}

Plan finished(const SearchTask& task, SearchResult found, PlanDraft draft, const SearchContext& context) {
  Plan plan = std::move(draft.plan);
  context.report();
  settle_overlaps(plan, found.best.subfields);
  context.report();
  plan.encounters = encounters_as_driven(task, found.best, draft.driven);
  context.report();
  // Half of the time of a plan of one layout. Neither reads what the other sets.
  const auto prove = [&] {
    if (!plan.headland.ground.empty())
      plan.headland.unworked = unworked_ground(plan.headland, task.machine.width_m);
    plan.proof = whole_proof(task, found, plan);
    if (plan.route.planned()) plan.route.proof = proof_of_route(task, found.best, draft.driven.tour, plan);
  };
  const auto draw = [&] { add_layers(plan, track_ground(plan, found.best), context); };
  side_by_side(context, draw, prove);
  if (task.given.parts.empty()) add_guide(task, plan.subfields);
  plan.warnings = warnings_about(plan);
  add_parts(draft.parts, plan.warnings);
  add_limits(found.limits, plan.warnings);
  add_shorter_ends(found.best, plan.warnings);
  return plan;
}

Plan finished_plan(const SearchTask& task, SearchResult found, const SearchContext& context) {
  if (!context.wants_layout_only()) {
    PlanDraft draft = drafted(task, found);
    return finished(task, std::move(found), std::move(draft), context);
  }
  require_tracks(task, found.best.avoided.tally);
  Plan plan = bare_plan(task);
  plan.pieces = driven_tracks(task, found.best).pieces;
  plan.directions_tried = found.directions_tried;
  plan.subfields = std::move(found.best.subfields);
  if (task.given.parts.empty()) add_guide(task, plan.subfields);
  return plan;
}

}  // namespace tramline
