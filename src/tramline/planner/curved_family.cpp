#include "tramline/planner/curved_family.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "tramline/cost/strip_tally.h"
#include "tramline/geometry/boolean.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/extended.h"
#include "tramline/geometry/shifted.h"
#include "tramline/geometry/smoothed.h"
#include "tramline/planner/driven_tracks.h"
#include "tramline/planner/family_bound.h"
#include "tramline/planner/pulse.h"
#include "tramline/planner/reference_chains.h"

namespace tramline {
namespace {

TrackLimits limits_of(const Machine& machine) {
  TrackLimits limits;
  limits.radius_m = machine.radius_m;
  limits.width_m = machine.width_m;
  return limits;
}

/// Without a headland before it a hard boundary is where swaths end.
Region fence(const SearchTask& task) {
  const bool hard = task.settings.boundary == EdgeKind::kHard;
  return hard ? Region{{task.field.outer, {}}} : Region{};
}

/// Of a reference that goes round the ground, anticlockwise as outer rings do.
StripRange tracks_inside(const Box& reach, double width_m) {
  const double across = std::hypot(reach.width(), reach.height());
  return {-static_cast<int>(std::ceil(0.5 * across / width_m)) - 1, 0};
}

/// Land given up within the headland stops no track: there the machine turns.
struct HardLand {
  Region before_tracks;
  Region elsewhere;
};

HardLand hard_land(const SearchTask& task) {
  const Region& headland = task.headland.ground;
  HardLand out{task.ground.hard, task.ground.beyond};
  if (headland.empty() || out.before_tracks.empty()) return out;
  const Region in_headland = intersection(out.before_tracks, headland);
  if (in_headland.empty()) return out;
  out.before_tracks = difference(out.before_tracks, headland);
  out.elsewhere = unite(out.elsewhere, in_headland);
  return out;
}

/// The numbers of the tracks that may reach the ground.
StripRange range_of(const SearchTask& task, const CurvedCandidate& candidate) {
  const Box reach = bounds(task.ground.plannable);
  const double width_m = task.machine.width_m;
  return candidate.round ? tracks_inside(reach, width_m) : tracks_over(candidate.reference, reach, width_m);
}

EndCriterion criterion_of(const SearchTask& task) {
  return end_criterion(task.settings.end_rule, task.objective, task.machine.width_m);
}

/// Of a candidate's reference.
TrackFamily tracks_of(const SearchTask& task, const CurvedGround& ground, const CurvedCandidate& candidate) {
  const StripRange range = range_of(task, candidate);
  return curved_tracks(parallel_family(candidate.reference, range.first, range.last, limits_of(task.machine)),
                       task.machine.width_m, ground, criterion_of(task));
}

/// Refers to its arguments. One family lies over all subfields, which have no borders to look at.
AvoidanceTask avoidance_task(const SearchTask& task, const std::vector<TrackFamily>& one_family) {
  static const std::vector<Subfield> kNoBorders;
  return {task.field,    task.ground, task.machine, task.objective,
          task.settings, kNoBorders,  one_family,   task.body_m2};
}

/// The pieces of a family without detours, laid track by track outwards from the reference; nullopt as soon
/// as it is certain to cost more than `no_more_than`.
std::optional<LaidTracks> laid_plainly(const SearchTask& task, const CurvedGround& ground,
                                       const CurvedCandidate& candidate, double no_more_than) {
  const StripRange range = range_of(task, candidate);
  FamilyBound bound(task, candidate.reference, range);
  LaidTracks out{{TrackFrame(), 0, task.machine.width_m}, {}, {}};
  bool hopeful = true;
  const auto lay = [&](int index, std::vector<ParallelTrack> tracks) {
    std::vector<FamilyTrack> family;
    for (ParallelTrack& track : tracks) family.push_back({index, std::move(track)});
    LaidTracks more =
        curved_pieces(family, task.machine.width_m, ground, criterion_of(task), min_length_m(task.machine));
    std::move(more.pieces.begin(), more.pieces.end(), std::back_inserter(out.pieces));
    std::move(more.dropped.begin(), more.dropped.end(), std::back_inserter(out.dropped));
    hopeful = bound.after(index, out) <= no_more_than;
    return hopeful;
  };
  visit_family(candidate.reference, range.first, range.last, limits_of(task.machine), lay);
  if (!hopeful) return std::nullopt;
  for (std::vector<LaidPiece>* pieces : {&out.pieces, &out.dropped})
    std::stable_sort(pieces->begin(), pieces->end(),
                     [](const LaidPiece& a, const LaidPiece& b) { return a.track < b.track; });
  return out;
}

}  // namespace

Reference reference_along(const SearchTask& task, const std::vector<Point>& line, double tolerance_m) {
  Smoothed smooth = smoothed(line, limits_of(task.machine).least_radius_m(), tolerance_m);
  const bool round = distance(line.front(), line.back()) <= 2 * kSeam_m;
  // From one side of the seam to the other.
  if (round && smooth.path.size() == 1)
    throw bad_input(
        fmt::format("smoothed to {} m, the reference line all round shrinks to a point", tolerance_m));
  return {line, std::move(smooth.path), smooth.deviation_m, round};
}

CurvedGround curved_ground(const SearchTask& task) {
  const HardLand hard = hard_land(task);
  return {EdgeIndex(task.ground.plannable), EdgeIndex(hard.before_tracks), EdgeIndex(fence(task)),
          EdgeIndex(task.ground.passable), EdgeIndex(hard.elsewhere)};
}

void count_subfields(const SearchTask& task, CurvedCandidate& candidate) {
  std::vector<bool> worked(task.ground.plannable.size(), false);
  for (const LaidPiece& piece : candidate.tracks.pieces)
    worked[static_cast<std::size_t>(subfield_of(task.ground.plannable, piece, task.machine.width_m))] = true;
  candidate.tally.subfields = static_cast<int>(std::count(worked.begin(), worked.end(), true));
  candidate.cost = cost(task.objective, candidate.tally);
}

bool asks_for_detours(const SearchTask& task) {
  return !task.ground.hard.empty() || !task.ground.passable.empty();
}

CurvedCandidate curved_along(const SearchTask& task, const Reference& reference, double right_m) {
  return curved_along(task, curved_ground(task), reference, right_m, std::numeric_limits<double>::infinity());
}

CurvedCandidate curved_along(const SearchTask& task, const CurvedGround& ground, const Reference& reference,
                             double right_m, double no_more_than) {
  CurvedCandidate out;
  out.line = reference.line;
  const std::optional<Path> line = shifted(reference.path, right_m, limits_of(task.machine).least_radius_m());
  if (!line) return out;
  const Box reach = bounds(task.ground.plannable).grown(task.machine.width_m);
  out.reference = reference.round ? *line : extended(*line, reach).path;
  out.round = reference.round;
  if (asks_for_detours(task)) {
    const std::vector<TrackFamily> one_family{tracks_of(task, ground, out)};
    Avoided cut = all_cut(avoidance_task(task, one_family));
    out.tracks = std::move(cut.tracks.front());
    out.tally = cut.tally;
    count_subfields(task, out);
  } else if (std::optional<LaidTracks> tracks = laid_plainly(task, ground, out, no_more_than)) {
    std::vector<LaidTracks> one_family;
    one_family.push_back(std::move(*tracks));
    out.tally = tally_of({}, one_family, task.body_m2);
    out.tracks = std::move(one_family.front());
    count_subfields(task, out);
  }
  return out;
}

CurvedCandidate with_detours(const SearchTask& task, CurvedCandidate candidate) {
  beat();
  if (candidate.tally.pieces == 0 || !asks_for_detours(task)) return candidate;
  const std::vector<TrackFamily> one_family{tracks_of(task, curved_ground(task), candidate)};
  const AvoidanceTask avoidance = avoidance_task(task, one_family);
  Avoided avoided = choose_detours(avoidance);
  candidate.encounters = encounters_in(avoidance, avoided);
  candidate.tracks = std::move(avoided.tracks.front());
  candidate.tally = avoided.tally;
  count_subfields(task, candidate);
  return candidate;
}

}  // namespace tramline
