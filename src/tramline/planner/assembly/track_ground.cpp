#include "tramline/planner/assembly/track_ground.h"

#include <cassert>
#include <utility>

#include "tramline/cost/worked/doubled_ground.h"
#include "tramline/cost/worked/swath_union.h"
#include "tramline/cost/worked/worked_bands.h"
#include "tramline/cost/worked/worked_regions.h"
#include "tramline/cost/worked/worked_rows.h"
#include "tramline/cost/zhou_tally.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// The pieces of a subfield where they keep to their tracks, each part a piece.
std::vector<TrackPiece> kept_to_tracks(const Plan& plan, std::size_t subfield) {
  std::vector<TrackPiece> out;
  for (const TrackPiece& piece : plan.pieces) {
    if (piece.subfield != subfield) continue;
    for (Path& part : parts_on_track(piece)) {
      TrackPiece alone{part.front().from, part.back().to};
      alone.track = piece.track;
      alone.curve = std::move(part);
      out.push_back(std::move(alone));
    }
  }
  return out;
}

/// In driving order, so that neighbours mostly follow one another.
Region swaths_of_detours(const Plan& plan) {
  Region out;
  for (const TrackPiece& piece : plan.pieces)
    for (const Detour& detour : piece.detours) append_swath(detour.path, plan.machine.width_m, out);
  return out;
}

/// The swaths of straight pieces without their detours.
Region rectangles_of(const Plan& plan) {
  Region out;
  for (const TrackPiece& piece : plan.pieces)
    for (const PathSegment& part : straight_parts(piece))
      out.push_back({band({part}, plan.machine.width_m), {}});
  return out;
}

/// As of any plan, in fewer booleans: many detours round one obstacle meet one another and all tracks there.
TrackGround ground_of_rows(const Plan& plan, const std::vector<LaidTracks>& tracks) {
  TrackGround out;
  for (const LaidTracks& rows : tracks) out.regions.push_back(worked_rows(rows));
  out.doubled = common_to_two(rectangles_of(plan));
  SwathUnion detours = swath_union(swaths_of_detours(plan));
  for (const Region& rows : out.regions) out.also_doubled.push_back(common_land(rows, detours.all));
  out.also_doubled.push_back(std::move(detours.doubled));
  out.regions.push_back(std::move(detours.all));
  return out;
}

std::vector<Region> worked_grounds(const Plan& plan, const Candidate& candidate) {
  std::vector<Region> out;
  for (std::size_t i = 0; i < candidate.avoided.tracks.size(); ++i) {
    const Path& reference = plan.subfields[i].reference;
    if (candidate.subfields[i].reference.empty()) {
      out.push_back(worked_rows(candidate.avoided.tracks[i]));
      continue;
    }
    for (Region& ground :
         worked_bands(reference, kept_to_tracks(plan, i), plan.machine.width_m, kLayerSagitta))
      out.push_back(std::move(ground));
  }
  out.push_back(unite(swaths_of_detours(plan)));
  return out;
}

}  // namespace

TrackGround track_ground(const Plan& plan, const Candidate& candidate) {
  assert(plan.subfields.size() == candidate.subfields.size());
  if (candidate.worked) {
    Region swaths;
    for (const LaidTracks& tracks : candidate.avoided.tracks)
      for (Polygon& part : kinked_swaths(tracks.pieces, plan.machine.width_m))
        swaths.push_back(std::move(part));
    return {{*candidate.worked}, common_to_two(swaths)};
  }
  if (!is_curved(plan)) return ground_of_rows(plan, candidate.avoided.tracks);
  return {worked_grounds(plan, candidate), doubled_ground(plan)};
}

}  // namespace tramline
