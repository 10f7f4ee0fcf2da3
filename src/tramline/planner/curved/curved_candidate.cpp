#include "tramline/planner/curved/curved_candidate.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "tramline/cost/strip_tally.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/path/extended_line.h"
#include "tramline/geometry/path/path_between.h"
#include "tramline/geometry/path/shifted_path.h"
#include "tramline/geometry/path/smoothed_line.h"
#include "tramline/planner/candidate/parallel_tracks.h"
#include "tramline/planner/candidate/reference_chains.h"
#include "tramline/planner/curved/family_bound.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

/// The pieces of a family without detours, laid track by track outwards from the reference; nullopt as soon
/// as it is certain to cost more than the limits.
std::optional<LaidTracks> laid_outwards(const SearchTask& task, const CurvedGround& ground,
                                        const Subfield& subfield, const CostLimits& limits) {
  const StripRange range = parallels_over(task, subfield);
  FamilyBound bound(task, subfield, range);
  LaidTracks out{{TrackFrame(), 0, task.machine.width_m}, {}, {}};
  bool hopeful = true;
  const auto lay = [&](int index, std::vector<ParallelTrack> tracks) {
    std::vector<FamilyTrack> parallel;
    for (ParallelTrack& track : tracks) parallel.push_back({index, std::move(track)});
    const TrackFamily family = curved_tracks(parallel, task.machine.width_m, ground, end_criterion_of(task));
    LaidTracks more = cut_pieces(family, min_length_m(task.machine));
    double inside_m2 = 0;
    for (const Track& track : family.tracks) inside_m2 += inside_between(track, 0, track.length_m);
    bound.add(more, inside_m2);
    std::move(more.pieces.begin(), more.pieces.end(), std::back_inserter(out.pieces));
    std::move(more.dropped.begin(), more.dropped.end(), std::back_inserter(out.dropped));
    hopeful = !bound.exceeds(limits, index);
    return hopeful;
  };
  visit_family(subfield.reference, range.first, range.last, track_limits(task.machine), lay);
  if (!hopeful) return std::nullopt;
  for (std::vector<LaidPiece>* pieces : {&out.pieces, &out.dropped})
    std::stable_sort(pieces->begin(), pieces->end(),
                     [](const LaidPiece& a, const LaidPiece& b) { return a.track < b.track; });
  return out;
}

struct ReferenceOrRefused {
  std::optional<Reference> reference;
  std::string refusal;
};

ReferenceOrRefused found_along(const SearchTask& task, const std::vector<Point>& line, double tolerance_m) {
  SmoothedOrRefused found = try_smoothed(line, track_limits(task.machine).least_radius_m(), tolerance_m);
  if (!found.smoothed) return {std::nullopt, std::move(found.refusal)};
  Smoothed& smooth = *found.smoothed;
  const bool round = distance(line.front(), line.back()) <= 2 * kSeam_m;
  // From one side of the seam to the other.
  if (round && smooth.path.size() == 1)
    return {std::nullopt,
            fmt::format("smoothed to {} m, the reference line all round shrinks to a point", tolerance_m)};
  return {Reference{line, std::move(smooth.path), smooth.deviation_m, round}, ""};
}

}  // namespace

Reference reference_along(const SearchTask& task, const std::vector<Point>& line, double tolerance_m) {
  ReferenceOrRefused out = found_along(task, line, tolerance_m);
  if (!out.reference) throw bad_input(out.refusal);
  return std::move(*out.reference);
}

std::optional<Reference> try_reference_along(const SearchTask& task, const std::vector<Point>& line,
                                             double tolerance_m) {
  return found_along(task, line, tolerance_m).reference;
}

std::optional<Subfield> subfield_along(const SearchTask& task, const Polygon& shape,
                                       const Reference& reference, double right_m) {
  std::optional<Path> line = shifted(reference.path, right_m, track_limits(task.machine).least_radius_m());
  if (!line) return std::nullopt;
  const Box reach = bounds(task.ground.plannable).grown(task.machine.width_m);
  Path path = reference.round ? std::move(*line) : extended(*line, reach).path;
  const Point half_way = path_between(path, 0, 0.5 * length(path)).back().to;
  const Direction whole = Direction::along(path.front().from, half_way);
  return Subfield{shape, whole, std::move(path)};
}

Candidate plain_candidate(const SearchTask& task, const CurvedGround& ground, const Subfield& subfield,
                          const CostLimits& limits) {
  Candidate out;
  out.subfields.push_back(subfield);
  std::optional<LaidTracks> tracks = laid_outwards(task, ground, subfield, limits);
  if (!tracks) return out;
  out.families.push_back({tracks->grid, {}});
  out.avoided.tracks.push_back(std::move(*tracks));
  out.avoided.tally = tally_of(out.subfields, out.avoided.tracks, task.body_m2);
  out.avoided.cost = cost(task.objective, out.avoided.tally);
  return out;
}

bool asks_for_detours(const SearchTask& task) {
  return !task.ground.hard.empty() || !task.ground.passable.empty();
}

}  // namespace tramline
