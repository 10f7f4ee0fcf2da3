#include <fmt/format.h>

#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// Whether there is an obstacle without headland or land given up in the first millimetre ahead; for lines of
/// others, which are less exact, in the first centimetre.
bool blocked(const Case& c, Point end, Point heading) {
  const PieceFrame frame(end, end + heading);
  const double half = 0.5 * c.plan.machine.width_m;
  const bool of_lines = is_of_lines(c.plan);
  const Box beyond{-half, 0, half, of_lines ? kAheadOfLine_m : kLengthTolerance_m};
  return clipped(c.blocking, frame, beyond).area_m2 + clipped(c.given_up, frame, beyond).area_m2 >
         (of_lines ? kAheadOfLine_m2 : kTouch_m2);
}

/// The directions out of a piece, at its start and at its end.
Point heading_at_start(const TrackPiece& piece) {
  return piece.curve.empty() ? piece.start - piece.end : -1.0 * direction_at_start(piece.curve.front());
}
Point heading_at_end(const TrackPiece& piece) {
  return piece.curve.empty() ? piece.end - piece.start : direction_at_end(piece.curve.back());
}

void compare(bool flagged, bool found, const std::string& end_name, Point at, Violations& out) {
  if (flagged == found) return;
  out.push_back(
      {Rule::kStops,
       found ? fmt::format("the {} is not flagged as a stop, but lies against an obstacle or land given up",
                           end_name)
             : fmt::format("the {} is flagged as a stop, but nothing lies behind it", end_name),
       at, 1});
}

}  // namespace

int check_stops(const Case& c, Violations& out) {
  int stops = 0;
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    const bool at_start = blocked(c, piece.start, heading_at_start(piece));
    const bool at_end = blocked(c, piece.end, heading_at_end(piece));
    stops += (at_start ? 1 : 0) + (at_end ? 1 : 0);
    compare(piece.stop_at_start, at_start, "start of " + piece_name(i), piece.start, out);
    compare(piece.stop_at_end, at_end, "end of " + piece_name(i), piece.end, out);
  }
  return stops;
}

}  // namespace tramline::check
