#pragma once
// Fewer cells: neighbours in the same state whose union is convex become one.

#include "tramline/coverage/tile.h"

namespace tramline::coverage {

/// Merges cells that share a whole edge, until no two can be. Corners no further than kStraight off the line
/// between their neighbours go; areas move in `totals` by what that does. The order of merging, and so the
/// result, depends on the cells alone. O(n log n) a round, few rounds.
void merge_cells(Tile& tile, Totals& totals);

/// Merges where the tile has grown to twice the cells it had after the last time.
void merge_when_due(Tile& tile, Totals& totals);

}  // namespace tramline::coverage
