#include "tramline/planner/driven_tracks.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "tramline/geometry/boolean.h"
#include "tramline/geometry/path_between.h"

namespace tramline {
namespace {

TrackPiece forwards(const CurvedPiece& piece, int subfield, const Writing& writing) {
  TrackPiece out;
  out.start = piece.path.front().from;
  out.end = piece.path.back().to;
  out.subfield = subfield;
  out.track = piece.track;
  out.stop_at_start = piece.stop_at_from;
  out.stop_at_end = piece.stop_at_to;
  out.after_crossing = piece.after_crossing;
  for (const StripDetour& detour : piece.detours)
    out.detours.push_back({detour.path, detour.side, detour.obstacles});
  if (writing.curved) out.curve = piece.path;
  // Where they keep to their tracks swaths of one family have no ground in common; add_overlaps() looks at
  // the rest.
  out.overlap_m2 = writing.width_m * piece.length_m - piece.inside_m2;
  return out;
}

TrackPiece backwards(TrackPiece piece) {
  std::swap(piece.start, piece.end);
  std::swap(piece.stop_at_start, piece.stop_at_end);
  piece.curve = reversed(piece.curve);
  std::reverse(piece.detours.begin(), piece.detours.end());
  for (Detour& detour : piece.detours) {
    detour.path = reversed(detour.path);
    detour.side = other_side(detour.side);
  }
  return piece;
}

/// The pieces of one track the other way round: what came after a crossing comes before it.
std::vector<TrackPiece> backwards(std::vector<TrackPiece> track) {
  std::reverse(track.begin(), track.end());
  for (std::size_t i = track.size(); i-- > 0;) {
    track[i] = backwards(std::move(track[i]));
    track[i].after_crossing = i > 0 && track[i - 1].after_crossing;
  }
  return track;
}

/// The part of the ground each piece lies in. What crossings join lies in one.
std::vector<int> subfields_of(const Region& parts, const std::vector<CurvedPiece>& pieces, double width_m) {
  std::vector<int> out;
  for (const CurvedPiece& piece : pieces)
    out.push_back(piece.after_crossing ? out.back() : subfield_of(parts, piece, width_m));
  return out;
}

}  // namespace

int subfield_of(const Region& parts, const CurvedPiece& piece, double width_m) {
  if (parts.size() == 1) return 0;
  const Path half = path_between(piece.path, 0, 0.5 * piece.length_m);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (contains(parts[i], half.back().to)) return static_cast<int>(i);
  // Along an edge most of the swath may lie outside, its middle with it.
  const Region swath = made_valid({band(piece.path, width_m, kLayerSagitta), {}});
  int best = 0;
  double most_m2 = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double inside_m2 = area(intersection(swath, {parts[i]}));
    if (inside_m2 <= most_m2) continue;
    most_m2 = inside_m2;
    best = static_cast<int>(i);
  }
  return best;
}

Passing other_side(Passing side) { return side == Passing::kLeft ? Passing::kRight : Passing::kLeft; }

Driven up_and_down(const CurvedTracks& tracks, const Region& parts, const Writing& writing) {
  Driven out{{},
             subfields_of(parts, tracks.pieces, writing.width_m),
             std::vector<bool>(tracks.pieces.size(), false)};
  for (int part = 0; part < static_cast<int>(parts.size()); ++part) {
    std::vector<TrackPiece> track;
    bool back = false;
    const auto drive = [&] {
      if (track.empty()) return;
      if (back) track = backwards(std::move(track));
      std::move(track.begin(), track.end(), std::back_inserter(out.pieces));
      back = !back;
      track.clear();
    };
    for (std::size_t i = 0; i < tracks.pieces.size(); ++i) {
      if (out.subfields[i] != part) continue;
      if (!track.empty() && track.back().track != tracks.pieces[i].track) drive();
      out.back[i] = back;
      track.push_back(forwards(tracks.pieces[i], part, writing));
    }
    drive();
  }
  return out;
}

}  // namespace tramline
