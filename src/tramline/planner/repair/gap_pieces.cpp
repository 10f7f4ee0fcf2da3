#include "tramline/planner/repair/gap_pieces.h"

#include <utility>

namespace tramline {

std::vector<TrackPiece> pieces_of(const GapLine& line, const StripGrid& grid, std::size_t subfield,
                                  int track) {
  std::vector<TrackPiece> out;
  const double across = grid.centre(0);
  for (const LaidPiece& piece : line.pieces) {
    TrackPiece driven;
    driven.start = grid.frame.to_field({across, piece.from});
    driven.end = grid.frame.to_field({across, piece.to});
    driven.subfield = subfield;
    driven.track = track;
    driven.stop_at_start = piece.stop_at_from;
    driven.stop_at_end = piece.stop_at_to;
    driven.after_crossing = piece.after_crossing;
    out.push_back(std::move(driven));
  }
  return out;
}

}  // namespace tramline
