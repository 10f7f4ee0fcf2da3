#include "tramline/planner/gap_pieces.h"

#include <utility>

namespace tramline {

void append_pieces(const GapLines& lines, int subfield, std::vector<TrackPiece>& out) {
  int number = 0;
  for (const GapLine& line : lines.lines) {
    const double across = lines.grid.centre(line.pieces.front().strip);
    for (const StripPiece& piece : line.pieces) {
      TrackPiece track;
      track.start = lines.grid.frame.to_field({across, piece.from});
      track.end = lines.grid.frame.to_field({across, piece.to});
      track.subfield = subfield;
      track.track = number;
      track.stop_at_start = piece.stop_at_from;
      track.stop_at_end = piece.stop_at_to;
      track.after_crossing = piece.after_crossing;
      out.push_back(std::move(track));
    }
    ++number;
  }
}

}  // namespace tramline
