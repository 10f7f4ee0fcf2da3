#include "tramline/cost/tally_by_booleans.h"

#include <algorithm>

#include "tramline/cost/settled_areas.h"
#include "tramline/geometry/boolean.h"

namespace tramline {

Tally tally_by_booleans(const LaidTracks& tracks, const Region& body, double sagitta_m) {
  const double width_m = tracks.grid.width_m;
  Tally out;
  Region swaths;
  for (const LaidPiece& piece : tracks.pieces) {
    out.worked_m2 += width_m * piece.length_m;
    out.track_length_m += piece.length_m;
    out.stops += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
    out.crossings += piece.after_crossing ? 1 : 0;
    ++out.pieces;
    for (const PathSegment& segment : piece.path) swaths.push_back({band({segment}, width_m, sagitta_m), {}});
  }
  out.turns = std::max(0, out.pieces - 1 - out.crossings);
  settle_areas(out, area(intersection(unite(swaths), body)), area(body));
  return out;
}

}  // namespace tramline
