#include "tramline/route/turning/stops.h"

#include "tramline/geometry/path/path.h"
#include "tramline/turns/turn_off.h"

namespace tramline {
namespace {

/// An end of a piece, and the direction out of it.
struct WayOut {
  Point end;
  Point ahead;
};

bool is_stop(const AllowedLand& land, const Machine& machine, const WayOut& out) {
  return !has_way_off(land, out.end, Heading::from_to({0, 0}, out.ahead), machine);
}

WayOut out_of_start(const TrackPiece& piece) {
  if (piece.curve.empty()) return {piece.start, piece.start - piece.end};
  return {piece.start, -1.0 * direction_at_start(piece.curve.front())};
}

WayOut out_of_end(const TrackPiece& piece) {
  if (piece.curve.empty()) return {piece.end, piece.end - piece.start};
  return {piece.end, direction_at_end(piece.curve.back())};
}

}  // namespace

int mark_stops(const AllowedLand& land, const Machine& machine, std::vector<TrackPiece>& pieces) {
  int stops = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    TrackPiece& piece = pieces[i];
    const bool crosses_next = i + 1 < pieces.size() && pieces[i + 1].after_crossing;
    piece.stop_at_start = !piece.after_crossing && is_stop(land, machine, out_of_start(piece));
    piece.stop_at_end = !crosses_next && is_stop(land, machine, out_of_end(piece));
    stops += (piece.stop_at_start ? 1 : 0) + (piece.stop_at_end ? 1 : 0);
  }
  return stops;
}

}  // namespace tramline
