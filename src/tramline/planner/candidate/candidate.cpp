#include "tramline/planner/candidate/candidate.h"

#include <algorithm>
#include <limits>

#include "tramline/avoidance/least_cost_with_detours.h"
#include "tramline/cost/strip_tally.h"
#include "tramline/decomposition/decompose.h"
#include "tramline/planner/candidate/parallel_tracks.h"
#include "tramline/planner/candidate/turned_ground.h"
#include "tramline/tracks/end_rule.h"
#include "tramline/tracks/strip_origin.h"

namespace tramline {
namespace {

/// The cost of a subfield's tracks by themselves, with borders to other subfields counted as plain edges.
double own_cost(const SearchTask& task, const Subfield& subfield, const LaidTracks& tracks) {
  return cost(task.objective, tally_of({subfield}, {tracks}, area(subfield.shape)));
}

/// The first line of the cheapest of the grids Versleijen §2.2.1 leaves open, tracks cut; among equals the
/// first. One without any track is chosen only where all are.
double best_origin(const SearchTask& task, const Subfield& subfield) {
  const std::vector<StripGrid> grids = strip_grids(subfield, task.machine.width_m);
  if (grids.size() == 1) return grids.front().origin_m;
  double origin_m = grids.front().origin_m, least = std::numeric_limits<double>::infinity();
  for (const StripGrid& grid : grids) {
    const TrackFamily family = tracks_on(task, {subfield, grid.origin_m});
    const LaidTracks tracks = cut_pieces(family, min_length_m(task.machine));
    if (tracks.pieces.empty()) continue;
    const double own = own_cost(task, subfield, tracks);
    if (own >= least) continue;
    least = own;
    origin_m = grid.origin_m;
  }
  return origin_m;
}

AvoidanceTask avoidance_task(const SearchTask& task, const Candidate& candidate) {
  return {task.field,    task.ground,         task.machine,       task.objective,
          task.settings, candidate.subfields, candidate.families, task.body_m2};
}

/// The candidate with its strips, without ways past obstacles.
Candidate laid_on(const SearchTask& task, const std::vector<LinedSubfield>& lined_subfields) {
  Candidate out;
  for (const LinedSubfield& ground : lined_subfields) {
    out.subfields.push_back(ground.subfield);
    out.families.push_back(tracks_on(task, ground));
  }
  return out;
}

}  // namespace

TrackFamily tracks_on(const SearchTask& task, const LinedSubfield& ground) {
  if (!ground.subfield.reference.empty())
    return parallel_tracks(task, curved_ground(task, ground.subfield.shape), ground.subfield);
  const TrackFrame frame(ground.subfield.direction);
  const EndCriterion criterion = end_criterion(task.settings.end_rule, task.objective, task.machine.width_m);
  return straight_tracks({frame, ground.origin_m, task.machine.width_m},
                         frame.to_track(Region{ground.subfield.shape}).front(), turned_ground(task, frame),
                         criterion);
}

Outlook outlook_on(const SearchTask& task, const std::vector<LinedSubfield>& lined_subfields) {
  const Candidate laid = laid_on(task, lined_subfields);
  const AvoidanceTask avoidance = avoidance_task(task, laid);
  const Avoided cut = all_cut(avoidance);
  Objective soft = task.objective;
  soft.stop = std::min(soft.stop, soft.turn);
  const bool decided = task.settings.avoid == Avoidance::kCut || !meets_obstacles(avoidance);
  return {cut.cost, cost(soft, cut.tally), decided ? cut.cost : least_cost_with_detours(avoidance, cut)};
}

void settle_cost(const SearchTask& task, Candidate& candidate) {
  settle_cost(avoidance_task(task, candidate), candidate.avoided);
}

Candidate candidate_on(const SearchTask& task, const std::vector<LinedSubfield>& lined_subfields) {
  Candidate out = laid_on(task, lined_subfields);
  out.avoided = choose_detours(avoidance_task(task, out));
  return out;
}

Candidate cut_candidate_on(const SearchTask& task, const std::vector<LinedSubfield>& lined_subfields) {
  Candidate out = laid_on(task, lined_subfields);
  out.avoided = all_cut(avoidance_task(task, out));
  return out;
}

double cost_by_rule(const SearchTask& task, const std::vector<LinedSubfield>& lined_subfields) {
  const Candidate laid = laid_on(task, lined_subfields);
  PlanSettings settings = task.settings;
  settings.avoid = Avoidance::kPaper;
  return choose_detours({task.field, task.ground, task.machine, task.objective, settings, laid.subfields,
                         laid.families, task.body_m2})
      .cost;
}

std::vector<LinedSubfield> lined_subfields_of(const Candidate& candidate) {
  std::vector<LinedSubfield> out;
  for (std::size_t i = 0; i < candidate.subfields.size(); ++i)
    out.push_back({candidate.subfields[i], candidate.families[i].grid.origin_m});
  return out;
}

std::vector<LinedSubfield> swept(const SearchTask& task, Direction sweep) {
  std::vector<LinedSubfield> out;
  PlanSettings settings = task.settings;
  settings.short_edge_m = task.short_edge_m;
  // No corner has an inside angle of more than a whole turn.
  if (task.may_divide == MayDivide::kNo) settings.decomposition_threshold = Angle::degrees(360);
  for (const Subfield& subfield : decompose(task.ground.plannable, sweep, settings))
    out.push_back({subfield, best_origin(task, subfield)});
  return out;
}

bool follow_curves(const std::vector<Subfield>& subfields) {
  return std::any_of(subfields.begin(), subfields.end(),
                     [](const Subfield& subfield) { return !subfield.reference.empty(); });
}

std::vector<PlacedEncounter> encounters_of(const SearchTask& task, const Candidate& candidate) {
  return encounters_in(avoidance_task(task, candidate), candidate.avoided);
}

int first_track(const Candidate& candidate, std::size_t subfield) {
  if (candidate.numbered_from_line_0 || !candidate.subfields[subfield].reference.empty()) return 0;
  const std::vector<LaidPiece>& pieces = candidate.avoided.tracks[subfield].pieces;
  int first = pieces.empty() ? std::numeric_limits<int>::max() : pieces.front().track;
  for (const Track& strip : candidate.families[subfield].tracks)
    if (!hard_gaps(strip).empty()) first = std::min(first, strip.index);
  return first;
}

}  // namespace tramline
