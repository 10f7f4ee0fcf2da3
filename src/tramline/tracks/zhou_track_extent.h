#pragma once
// The stretches of a polyline in whose row there is any body to work: Zhou §2.3.4.

#include <vector>

#include "tramline/geometry/interval.h"
#include "tramline/geometry/path/path.h"

namespace tramline {

/// Buffer, intersection and projection: the swath of the width along `path`, cut to one part of the body,
/// falls into pieces (of Zhou fig. 8 the cases "partial" and "crossing"; the body is the field's inner border
/// less the obstacles'), and each reaches along the path from the first to the last foot of its vertices.
/// Pieces that overlap along the path are one. A vertex as near to several places of the path, as on the
/// bisector of a kink, has a foot at each (kEquidistant_m). Land within kWidthTolerance of the swath's sides
/// does not count, nor do pieces shorter than a millimetre. Positions in metres along the path. Precondition:
/// straight segments only. A polygon boolean, and O(v·n) for v vertices of the pieces.
Intervals zhou_track_extent(const Path& path, double width_m, const Polygon& body);

}  // namespace tramline
