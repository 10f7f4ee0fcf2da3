#include "tramline/cost/curved_cover.h"

#include <algorithm>

namespace tramline {
namespace {

std::size_t place_of(const TrackFamily& family, const LaidPiece& piece) {
  const auto found = std::find_if(family.tracks.begin(), family.tracks.end(), [&piece](const Track& track) {
    return track.index == piece.track && track.branch == piece.branch;
  });
  return static_cast<std::size_t>(found - family.tracks.begin());
}

double new_area_of(const Path& path, double width_m, const std::vector<Ring>& body, RisingCurves curves) {
  const Box window = reach_of(path, width_m);
  for (const Ring& ring : body) append_ring(ring, Layer::kBody, window, curves);
  append_band(path, width_m, Layer::kNew, curves);
  return new_area(curves);
}

}  // namespace

void CurvedCover::add(std::size_t track, const Path& path, double width_m) {
  Worked& worked = tracks_[track];
  worked.width_m = width_m;
  const std::vector<Box> reaches = reaches_of(path, width_m);
  for (std::size_t i = 0; i < path.size(); ++i) {
    worked.swaths.push_back({path[i], reaches[i]});
    worked.reach.extend(reaches[i]);
  }
}

void CurvedCover::set(std::size_t track, const std::vector<Path>& kept,
                      const std::vector<TrackDetour>& detours, double width_m) {
  tracks_[track] = {};
  for (const Path& path : kept) add(track, path, width_m);
  for (const TrackDetour& detour : detours) {
    add(track, detour.path, width_m);
    tracks_[track].detours.push_back(reach_of(detour.path, width_m));
  }
}

void CurvedCover::append(const Worked& track, const Box& window, RisingCurves& out) {
  if (!intersects(track.reach, window)) return;
  for (const Swath& swath : track.swaths)
    if (intersects(swath.reach, window)) append_band({swath.line}, track.width_m, Layer::kTaken, out);
}

void CurvedCover::append_taken(const Box& window, std::size_t except, RisingCurves& out) const {
  for (std::size_t i = 0; i < tracks_.size(); ++i)
    if (i != except) append(tracks_[i], window, out);
}

void CurvedCover::append_taken(const Box& window, RisingCurves& out) const {
  append_taken(window, tracks_.size(), out);
}

bool CurvedCover::detours_near(const Box& window, std::size_t except) const {
  for (std::size_t i = 0; i < tracks_.size(); ++i)
    if (i != except && std::any_of(tracks_[i].detours.begin(), tracks_[i].detours.end(),
                                   [&window](const Box& box) { return intersects(box, window); }))
      return true;
  return false;
}

double new_area_of(const Path& path, double width_m, const std::vector<Ring>& body, const CurvedCover& cover,
                   std::size_t except) {
  RisingCurves taken;
  cover.append_taken(reach_of(path, width_m), except, taken);
  return new_area_of(path, width_m, body, std::move(taken));
}

double covered_by_detours_m2(const Region& body, const TrackFamily& family, const LaidTracks& laid,
                             double width_m) {
  CurvedCover cover(family.tracks.size());
  bool any = false;
  for (const LaidPiece& piece : laid.pieces) {
    const std::size_t track = place_of(family, piece);
    any = any || !piece.detours.empty();
    for (const Interval& kept : parts_on_track(piece))
      cover.add(track, path_along(family.tracks[track], kept.from, kept.to), width_m);
  }
  if (!any) return 0;
  const std::vector<Ring> rings = rings_of(body);
  double sum = 0;
  for (const LaidPiece& piece : laid.pieces)
    for (const TrackDetour& detour : piece.detours) {
      sum += new_area_of(detour.path, width_m, rings, cover, family.tracks.size());
      cover.add(place_of(family, piece), detour.path, width_m);
    }
  return sum;
}

}  // namespace tramline
