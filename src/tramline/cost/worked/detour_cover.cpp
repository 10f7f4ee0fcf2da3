#include "tramline/cost/worked/detour_cover.h"

#include <algorithm>

namespace tramline {
namespace {

bool has_detours(const LaidTracks& tracks) {
  return std::any_of(tracks.pieces.begin(), tracks.pieces.end(),
                     [](const LaidPiece& piece) { return !piece.detours.empty(); });
}

/// Area that one detour newly covers; `ground` counts it as covered afterwards.
double newly_covered_by(const std::vector<Ring>& body, double width_m, std::size_t family, std::size_t track,
                        const TrackDetour& detour, WorkedGround& ground) {
  const Box window = reach_of(detour.path, width_m);
  RisingCurves curves;
  for (const Ring& ring : body) append_ring(ring, Layer::kBody, window, curves);
  ground.append_covered(family, window, reaches_of(detour.path, width_m), {}, curves);
  append_band(detour.path, width_m, Layer::kNew, curves);
  TrackWork work = ground.at(family, track);
  work.detours.push_back(detour);
  ground.set(family, track, std::move(work));
  return newly_covered_area(curves);
}

}  // namespace

double covered_by_detours_m2(const Region& body, const std::vector<TrackFamily>& families,
                             const std::vector<LaidTracks>& tracks) {
  if (std::none_of(tracks.begin(), tracks.end(), has_detours)) return 0;
  WorkedGround ground = worked_on_tracks(families, tracks);
  double sum = 0;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (!has_detours(tracks[i])) continue;
    const StripGrid& grid = families[i].grid;
    std::vector<Ring> turned;
    for (const Ring& ring : rings_of(body)) turned.push_back(grid.frame.to_track(ring));
    for (const LaidPiece& piece : tracks[i].pieces)
      for (const TrackDetour& detour : piece.detours)
        sum += newly_covered_by(turned, grid.width_m, i, index_in_family(families[i], piece), detour, ground);
  }
  return sum;
}

}  // namespace tramline
