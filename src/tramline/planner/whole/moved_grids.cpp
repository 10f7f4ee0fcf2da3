#include "tramline/planner/whole/moved_grids.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "tramline/geometry/strip/track_frame.h"
#include "tramline/planner/assembly/driven_tracks.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/whole/route_floor.h"

namespace tramline {
namespace {

/// A grid is tried at so many offsets.
constexpr int kOffsets = 8;
/// Directions all round, and what lies between two of them.
constexpr int kDirections = 60;
constexpr double kApart_deg = 3;
/// Among obstacles ways past them are looked for on so many times as many grids as are drafted.
constexpr std::size_t kLookedInto = 8;
/// Stops are looked for on so many grids at once, whatever the number of threads.
constexpr std::size_t kStopsAtOnce = 8;

using CandidateOf = std::function<Candidate(std::size_t line)>;

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
                     Candidate candidate, int directions) {
  SearchResult result;
  result.best = std::move(candidate);
  result.directions_tried = directions;
  PlanDraft draft = drafted(task, result);
  return {Alternative::kMovedLines,
          {laid.trial.passes, problem, laid.trial.prepared, std::move(result), std::move(draft)}};
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

/// The floor of some tracks, without that of the headlands.
struct Floored {
  double floor = 0;
  std::size_t line = 0;
  Plan tracks{};

  friend bool operator<(const Floored& a, const Floored& b) {
    return std::pair(a.floor, a.line) < std::pair(b.floor, b.line);
  }
};

/// Those that have tracks and whose floor with the headlands is no higher than that, without their stops.
std::vector<Floored> floors_without_stops(const std::vector<std::size_t>& among, const LaidOut& laid,
                                          const SearchTask& task, const CandidateOf& candidate_of,
                                          double no_more_than, const SearchContext& context) {
  const std::vector<HeadlandPass>& passes = laid.trial.draft.plan.headland.passes;
  std::vector<std::optional<Floored>> found(among.size());
  for_each_index(among.size(), context, [&](std::size_t i) {
    const Candidate candidate = candidate_of(among[i]);
    if (!candidate.works()) return;
    Plan tracks = tracks_alone(task, candidate);
    if (floor_without_stops(tracks, passes) > no_more_than) return;
    const double floor = floor_without_stops(tracks, {});
    found[i] = Floored{floor, among[i], std::move(tracks)};
  });
  std::vector<Floored> out;
  for (std::optional<Floored>& one : found)
    if (one) out.push_back(*std::move(one));
  return out;
}

/// Of some lines the `most` on which candidates have the lowest floors, these first. Stops are looked for,
/// which takes longest, only where the floor without them is among the lowest.
std::vector<std::size_t> of_lowest_floors(std::vector<Floored> candidates, std::size_t most,
                                          const AllowedLand& land, const SearchContext& context) {
  std::sort(candidates.begin(), candidates.end());
  std::vector<Floored> lowest;
  for (std::size_t next = 0; next < candidates.size();) {
    if (lowest.size() == most && lowest.back().floor < candidates[next].floor) break;
    const std::size_t first = next;
    next = std::min(first + kStopsAtOnce, candidates.size());
    for_each_index(next - first, context, [&](std::size_t i) {
      candidates[first + i].floor += price_of_stops(candidates[first + i].tracks, land);
    });
    std::move(candidates.begin() + static_cast<std::ptrdiff_t>(first),
              candidates.begin() + static_cast<std::ptrdiff_t>(next), std::back_inserter(lowest));
    std::sort(lowest.begin(), lowest.end());
    lowest.resize(std::min(lowest.size(), most));
  }
  std::vector<std::size_t> out;
  for (const Floored& one : lowest) out.push_back(one.line);
  return out;
}

/// Tracks on the lines, of so many directions, behind the passes of a layout: the `most` of them of the
/// lowest floors, up to a floor with the headlands. Among obstacles ways past them are looked for only where
/// the floor is low with all tracks cut, because that takes many times as long.
std::vector<LaidOut> drafted_of_lowest_floors(const LaidOut& laid,
                                              const std::vector<std::vector<LinedSubfield>>& lines,
                                              int directions, std::size_t most, double no_more_than,
                                              const SearchContext& context) {
  const PlanningProblem problem = problem_of(laid);
  const PreparedField& prepared = laid.trial.prepared;
  const SearchTask task(problem, prepared);
  const AllowedLand& land = *prepared.turning_land;
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!problem.field.obstacles.empty())
    order = of_lowest_floors(
        floors_without_stops(
            order, laid, task, [&](std::size_t i) { return cut_candidate_on(task, lines[i]); }, kAnyCost,
            context),
        kLookedInto * most, land, context);
  order = of_lowest_floors(floors_without_stops(
                               order, laid, task, [&](std::size_t i) { return candidate_on(task, lines[i]); },
                               no_more_than, context),
                           most, land, context);
  std::vector<LaidOut> out;
  for (const std::size_t i : order)
    out.push_back(drafted_like(laid, task, problem, candidate_on(task, lines[i]), directions));
  return out;
}

}  // namespace

std::vector<LaidOut> beside(const LaidOut& laid, std::size_t most, const SearchContext& context) {
  constexpr std::array kTurned_deg = {0.0, -1.5, 1.5, -3.0, 3.0};
  const std::vector<LinedSubfield> lined = lined_subfields_of(laid.trial.found.best);
  if (lined.empty() || !all_in(laid.trial.draft.plan, lined.front().subfield.direction)) return {};
  const Point middle = bounds(laid.trial.prepared.ground.plannable.front().outer).centre();
  const double step_m = laid.trial.problem.machine.width_m / kOffsets;
  std::vector<std::vector<LinedSubfield>> lines;
  for (const double turned_deg : kTurned_deg)
    for (int i = turned_deg == 0 ? 1 : 0; i < kOffsets; ++i)
      lines.push_back(moved(lined, i * step_m, Angle::degrees(turned_deg), middle));
  return drafted_of_lowest_floors(laid, lines, kTurned_deg.size(), most, kAnyCost, context);
}

std::vector<LaidOut> all_round_the_compass(const LaidOut& laid, std::size_t most, double no_more_than,
                                           const SearchContext& context) {
  const double step_m = laid.trial.problem.machine.width_m / kOffsets;
  std::vector<std::vector<LinedSubfield>> lines;
  for (int direction = 0; direction < kDirections; ++direction)
    for (int i = 0; i < kOffsets; ++i)
      lines.push_back(on_one_grid(laid.trial.prepared.ground.plannable,
                                  Direction::clockwise_from_north(Angle::degrees(kApart_deg * direction)),
                                  i * step_m));
  return drafted_of_lowest_floors(laid, lines, kDirections, most, no_more_than, context);
}

}  // namespace tramline
