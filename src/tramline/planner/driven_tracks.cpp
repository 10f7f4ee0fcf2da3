#include "tramline/planner/driven_tracks.h"

#include <algorithm>
#include <numeric>

#include "tramline/geometry/boolean.h"
#include "tramline/geometry/path_between.h"
#include "tramline/planner/order/best_tour.h"

namespace tramline {
namespace {

TrackPiece forwards(const LaidPiece& piece, int subfield, const Writing& writing) {
  TrackPiece out;
  out.start = piece.path.front().from;
  out.end = piece.path.back().to;
  out.subfield = subfield;
  out.track = piece.track;
  out.stop_at_start = piece.stop_at_from;
  out.stop_at_end = piece.stop_at_to;
  out.after_crossing = piece.after_crossing;
  for (const TrackDetour& detour : piece.detours)
    out.detours.push_back({detour.path, detour.side, detour.obstacles});
  if (writing.curved) out.curve = piece.path;
  // Where they keep to their tracks swaths of one family have no ground in common; add_overlaps() looks at
  // the rest.
  out.overlap_m2 = writing.width_m * piece.length_m - piece.inside_m2;
  return out;
}

/// The part of the ground each piece lies in. What crossings join lies in one.
std::vector<int> subfields_of(const Region& parts, const std::vector<LaidPiece>& pieces, double width_m) {
  std::vector<int> out;
  for (const LaidPiece& piece : pieces)
    out.push_back(piece.after_crossing ? out.back() : subfield_of(parts, piece, width_m));
  return out;
}

}  // namespace

int subfield_of(const Region& parts, const LaidPiece& piece, double width_m) {
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

std::vector<TrackPiece> track_pieces(const LaidTracks& tracks, const Region& parts, const Writing& writing) {
  const std::vector<int> subfields = subfields_of(parts, tracks.pieces, writing.width_m);
  std::vector<TrackPiece> out;
  for (std::size_t i = 0; i < tracks.pieces.size(); ++i)
    out.push_back(forwards(tracks.pieces[i], subfields[i], writing));
  return out;
}

Driven driven_tracks(const LaidTracks& tracks, const Region& parts, const Field& field,
                     const Writing& writing) {
  Driven out{{},
             subfields_of(parts, tracks.pieces, writing.width_m),
             std::vector<bool>(tracks.pieces.size(), false)};
  std::vector<std::size_t> by_part(tracks.pieces.size());
  std::iota(by_part.begin(), by_part.end(), std::size_t{0});
  std::stable_sort(by_part.begin(), by_part.end(),
                   [&](std::size_t a, std::size_t b) { return out.subfields[a] < out.subfields[b]; });
  std::vector<TrackPiece> pieces;
  for (const std::size_t i : by_part) pieces.push_back(forwards(tracks.pieces[i], out.subfields[i], writing));
  const std::vector<order::WorkedLine> lines = order::lines_of(pieces);
  const order::Tour tour = order::best_tour(lines, field, writing.width_m);
  std::vector<bool> back(lines.size());
  for (const order::End end : tour) back[order::line_of(end)] = !order::is_start(end);
  auto piece = by_part.begin();
  for (std::size_t line = 0; line < lines.size(); ++line)
    for (std::size_t k = 0; k < lines[line].size(); ++k) out.back[*piece++] = back[line];
  out.pieces = order::pieces_on(tour, lines);
  return out;
}

}  // namespace tramline
