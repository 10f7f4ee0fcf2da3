#pragma once
// The ground that the straight swaths of a subfield work, as one region.

#include "tramline/geometry/region.h"
#include "tramline/tracks/strip_pieces.h"

namespace tramline {

/// The union of the swaths of all straight parts, in the field's frame: swaths of one grid share strip
/// lines, so that it is a walk along these, and no polygon boolean. Parts may touch in corners. O(n log n)
/// for n pieces.
Region worked_rows(const SubfieldTracks& tracks);

}  // namespace tramline
