#pragma once
// The headings of pieces on the page, where y points down.

#include "tramline/model/track.h"

namespace tramline::render {

/// Converts a unit vector of the field to the page.
inline Point on_page(Point along) { return {along.x, -along.y}; }

/// Unit vectors at both ends of a piece. Precondition: start != end.
Point heading_at_start(const TrackPiece& piece);
Point heading_at_end(const TrackPiece& piece);

}  // namespace tramline::render
