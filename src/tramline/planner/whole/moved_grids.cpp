#include "tramline/planner/whole/moved_grids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/geometry/strip/track_frame.h"
#include "tramline/planner/assembly/driven_tracks.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/whole/route_floor.h"

namespace tramline {
namespace {

/// A grid is tried at so many offsets.
constexpr std::size_t kOffsets = 8;
/// Directions all round, and what lies between two of them.
constexpr std::size_t kDirections = 60;
constexpr double kApart_deg = 3;
/// The lines moved across and turned about a point.
std::vector<LinedSubfield> moved(std::vector<LinedSubfield> lined, double by_m, Angle turned, Point about) {
  for (LinedSubfield& one : lined) {
    const double before_m = TrackFrame(one.subfield.direction).to_track(about).x;
    one.subfield.direction = one.subfield.direction.rotated(turned);
    one.origin_m += TrackFrame(one.subfield.direction).to_track(about).x - before_m + by_m;
  }
  return lined;
}

/// The problem of a layout, without its route.
PlanningProblem problem_of(const LaidOut& laid) {
  PlanningProblem out = laid.trial.problem;
  out.settings.turns = TurnPlanning::kNone;
  return out;
}

LaidOut drafted_like(const LaidOut& laid, const SearchTask& task, const PlanningProblem& problem,
                     Candidate candidate) {
  SearchResult result;
  result.best = std::move(candidate);
  result.directions_tried = laid.trial.found.directions_tried;
  PlanDraft draft = drafted(task, result);
  return {laid.kind, {laid.trial.passes, problem, laid.trial.prepared, std::move(result), std::move(draft)}};
}

/// All of the land in one direction on one grid.
std::vector<LinedSubfield> on_one_grid(const Region& land, Direction along, double origin_m) {
  std::vector<LinedSubfield> out;
  for (const Polygon& part : land) out.push_back({{part, along}, origin_m});
  return out;
}

/// What route_floor() asks of a plan, but for its headlands, which are the same in all directions.
Plan tracks_alone(const SearchTask& task, const Candidate& candidate) {
  Plan out;
  out.machine = task.machine;
  out.subfields = candidate.subfields;
  out.pieces = track_pieces(task, candidate);
  out.tally = candidate.avoided.tally;
  return out;
}

struct PricedLines {
  std::vector<LinedSubfield> lines;
  double floor = std::numeric_limits<double>::infinity();  ///< EUR; infinite where no track fits
};

}  // namespace

std::vector<LaidOut> beside(const LaidOut& laid, std::size_t most) {
  constexpr std::array kTurned_deg = {0.0, -1.5, 1.5, -3.0, 3.0};
  const HeadlandTrial& trial = laid.trial;
  const std::vector<LinedSubfield> lined = lined_subfields_of(trial.found.best);
  if (lined.empty() || !all_in(trial.draft.plan, lined.front().subfield.direction)) return {};
  const PlanningProblem problem = problem_of(laid);
  const SearchTask task(problem, trial.prepared);
  const Point middle = bounds(trial.prepared.ground.plannable.front().outer).centre();
  std::vector<Candidate> found;
  for (const double turned_deg : kTurned_deg)
    for (std::size_t i = turned_deg == 0 ? 1 : 0; i < kOffsets; ++i) {
      Candidate candidate =
          candidate_on(task, moved(lined, static_cast<double>(i) * problem.machine.width_m / kOffsets,
                                   Angle::degrees(turned_deg), middle));
      if (candidate.works()) found.push_back(std::move(candidate));
    }
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost() < b.cost(); });
  std::vector<LaidOut> out;
  for (std::size_t i = 0; i < std::min(found.size(), most); ++i)
    out.push_back(drafted_like(laid, task, problem, std::move(found[i])));
  return out;
}

std::vector<LaidOut> all_round_the_compass(const LaidOut& laid, std::size_t most,
                                           const SearchContext& context) {
  const PlanningProblem problem = problem_of(laid);
  const PreparedField& prepared = laid.trial.prepared;
  const SearchTask task(problem, prepared);
  std::vector<PricedLines> all(kDirections * kOffsets);
  for_each_index(all.size(), context, [&](std::size_t i) {
    const double direction = static_cast<double>(i / kOffsets), offset = static_cast<double>(i % kOffsets);
    all[i].lines = on_one_grid(prepared.ground.plannable,
                               Direction::clockwise_from_north(Angle::degrees(kApart_deg * direction)),
                               offset * problem.machine.width_m / kOffsets);
    const Candidate candidate = candidate_on(task, all[i].lines);
    if (candidate.works()) all[i].floor = route_floor(tracks_alone(task, candidate), *prepared.turning_land);
  });
  std::ranges::stable_sort(all, {}, &PricedLines::floor);
  std::vector<LaidOut> out;
  for (std::size_t i = 0; i < std::min(all.size(), most) && std::isfinite(all[i].floor); ++i)
    out.push_back(drafted_like(laid, task, problem, candidate_on(task, all[i].lines)));
  return out;
}

}  // namespace tramline
