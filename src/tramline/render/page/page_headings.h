#pragma once
// Which way pieces run on the page, where y points down.

#include "tramline/model/track.h"

namespace tramline::render {

/// A unit vector of the field, on the page.
inline Point on_page(Point along) { return {along.x, -along.y}; }

/// Unit vectors at both ends of a piece. Precondition: start != end.
Point heading_at_start(const TrackPiece& piece);
Point heading_at_end(const TrackPiece& piece);

}  // namespace tramline::render
