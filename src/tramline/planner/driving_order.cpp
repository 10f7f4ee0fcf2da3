#include "tramline/planner/driving_order.h"

#include <algorithm>
#include <limits>

namespace tramline {
namespace {

Detour detour_on_field(const StripDetour& detour, const StripGrid& grid) {
  return {moved(detour.path, [&](Point p) { return grid.frame.to_field(p); }), detour.side, detour.obstacles};
}

Detour backwards(const Detour& detour) {
  return {reversed(detour.path), detour.side == Passing::kLeft ? Passing::kRight : Passing::kLeft,
          detour.obstacles};
}

TrackPiece piece_on_field(const StripPiece& piece, const StripGrid& grid, int subfield, int first_strip) {
  const double across = grid.centre(piece.strip);
  TrackPiece out;
  out.start = grid.frame.to_field({across, piece.from});
  out.end = grid.frame.to_field({across, piece.to});
  out.subfield = subfield;
  out.track = piece.strip - first_strip;
  out.stop_at_start = piece.stop_at_from;
  out.stop_at_end = piece.stop_at_to;
  out.after_crossing = piece.after_crossing;
  for (const StripDetour& detour : piece.detours) out.detours.push_back(detour_on_field(detour, grid));
  return out;
}

using Track = std::vector<TrackPiece>;

/// The pieces of one track the other way round.
Track backwards(const Track& track) {
  Track out;
  for (std::size_t i = track.size(); i-- > 0;) {
    TrackPiece piece = track[i];
    std::swap(piece.start, piece.end);
    std::swap(piece.stop_at_start, piece.stop_at_end);
    piece.after_crossing = i + 1 < track.size() && track[i + 1].after_crossing;
    std::reverse(piece.detours.begin(), piece.detours.end());
    for (Detour& detour : piece.detours) detour = backwards(detour);
    out.push_back(piece);
  }
  return out;
}

std::vector<Track> tracks_of(const SubfieldTracks& tracks, int subfield, int first_strip) {
  std::vector<Track> out;
  int last_strip = 0;
  for (const StripPiece& piece : tracks.pieces) {
    if (out.empty() || piece.strip != last_strip) out.emplace_back();
    last_strip = piece.strip;
    out.back().push_back(piece_on_field(piece, tracks.grid, subfield, first_strip));
  }
  return out;
}

std::vector<TrackPiece> up_and_down(std::vector<Track> tracks, bool from_last, bool downwards) {
  if (from_last) std::reverse(tracks.begin(), tracks.end());
  std::vector<TrackPiece> out;
  for (const Track& track : tracks) {
    const Track driven = downwards ? backwards(track) : track;
    out.insert(out.end(), driven.begin(), driven.end());
    downwards = !downwards;
  }
  return out;
}

/// The four ways of working one subfield; the one that starts nearest to `from`.
std::vector<TrackPiece> nearest_way(const std::vector<Track>& tracks, Point from, double& nearest) {
  std::vector<TrackPiece> best;
  for (const bool from_last : {false, true})
    for (const bool downwards : {false, true}) {
      std::vector<TrackPiece> way = up_and_down(tracks, from_last, downwards);
      const double reach = distance(from, way.front().start);
      if (!best.empty() && reach >= nearest) continue;
      nearest = reach;
      best = std::move(way);
    }
  return best;
}

}  // namespace

std::vector<TrackPiece> driving_order(const Candidate& candidate) {
  std::vector<std::vector<Track>> waiting;
  for (std::size_t i = 0; i < candidate.avoided.tracks.size(); ++i)
    waiting.push_back(tracks_of(candidate.avoided.tracks[i], static_cast<int>(i), first_track(candidate, i)));
  std::vector<TrackPiece> out;
  while (true) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t chosen = waiting.size();
    std::vector<TrackPiece> way;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (waiting[i].empty()) continue;
      double reach = 0;
      std::vector<TrackPiece> candidate_way = out.empty() ? up_and_down(waiting[i], false, false)
                                                          : nearest_way(waiting[i], out.back().end, reach);
      if (chosen != waiting.size() && reach >= nearest) continue;
      nearest = reach;
      chosen = i;
      way = std::move(candidate_way);
      if (out.empty()) break;
    }
    if (chosen == waiting.size()) return out;
    out.insert(out.end(), way.begin(), way.end());
    waiting[chosen].clear();
  }
}

}  // namespace tramline
