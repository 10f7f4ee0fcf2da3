#include "tramline/planner/driving_order.h"

#include "tramline/planner/order/best_tour.h"

namespace tramline {
namespace {

Detour detour_on_field(const TrackDetour& detour, const StripGrid& grid) {
  return {moved(detour.path, [&](Point p) { return grid.frame.to_field(p); }), detour.side, detour.obstacles};
}

TrackPiece piece_on_field(const LaidPiece& piece, const StripGrid& grid, int subfield, int first_strip) {
  const double across = grid.centre(piece.track);
  TrackPiece out;
  out.start = grid.frame.to_field({across, piece.from});
  out.end = grid.frame.to_field({across, piece.to});
  out.subfield = subfield;
  out.track = piece.track - first_strip;
  out.stop_at_start = piece.stop_at_from;
  out.stop_at_end = piece.stop_at_to;
  out.after_crossing = piece.after_crossing;
  for (const TrackDetour& detour : piece.detours) out.detours.push_back(detour_on_field(detour, grid));
  return out;
}

}  // namespace

std::vector<TrackPiece> track_pieces(const Candidate& candidate) {
  std::vector<TrackPiece> pieces;
  for (std::size_t i = 0; i < candidate.avoided.tracks.size(); ++i) {
    const LaidTracks& tracks = candidate.avoided.tracks[i];
    for (const LaidPiece& piece : tracks.pieces)
      pieces.push_back(piece_on_field(piece, tracks.grid, static_cast<int>(i), first_track(candidate, i)));
  }
  return pieces;
}

std::vector<TrackPiece> driving_order(const SearchTask& task, const Candidate& candidate) {
  const std::vector<order::WorkedLine> lines = order::lines_of(track_pieces(candidate));
  return order::pieces_on(order::best_tour(lines, task.field, task.machine.width_m), lines);
}

}  // namespace tramline
