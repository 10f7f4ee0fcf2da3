#pragma once
// The convex polygons that a quad works.

#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/coverage/tiles/convex_piece.h"
#include "tramline/coverage/tiles/tile_frame.h"

namespace tramline::coverage {

/// Appends the pieces of a quad of either orientation: itself where it is convex, two triangles where it is
/// an arrow or crosses itself, nothing where it has no area on the grid. Pieces do not overlap.
void append_pieces(const Quad& quad, const TileFrame& frame, std::vector<ConvexPiece>& out);

}  // namespace tramline::coverage
