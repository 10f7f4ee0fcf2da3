#include "tramline/render/page/page_headings.h"

#include <cassert>

namespace tramline::render {
namespace {

// A detour may begin and end anywhere, but does so along the line from start to end.
Point heading_of_line(const TrackPiece& piece) {
  return on_page((1 / distance(piece.start, piece.end)) * (piece.end - piece.start));
}

}  // namespace

Point heading_at_start(const TrackPiece& piece) {
  assert(!piece.curve.empty() || piece.start != piece.end);
  return piece.curve.empty() ? heading_of_line(piece) : on_page(direction_at_start(piece.curve.front()));
}

Point heading_at_end(const TrackPiece& piece) {
  return piece.curve.empty() ? heading_of_line(piece) : on_page(direction_at_end(piece.curve.back()));
}

}  // namespace tramline::render
