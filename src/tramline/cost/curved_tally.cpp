#include "tramline/cost/curved_tally.h"

#include <algorithm>

#include "tramline/cost/settled_areas.h"
#include "tramline/geometry/boolean.h"

namespace tramline {
namespace {

Tally counts(const LaidTracks& tracks, double width_m) {
  Tally out;
  for (const LaidPiece& piece : tracks.pieces) {
    out.worked_m2 += width_m * piece.length_m;
    out.track_length_m += piece.length_m;
    out.stops += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
    out.crossings += piece.after_crossing ? 1 : 0;
    ++out.pieces;
  }
  out.turns = std::max(0, out.pieces - 1 - out.crossings);
  return out;
}

}  // namespace

Tally curved_tally(const LaidTracks& tracks, double width_m, double body_m2, double by_detours_m2) {
  Tally out = counts(tracks, width_m);
  double inside = by_detours_m2;
  for (const LaidPiece& piece : tracks.pieces) inside += piece.inside_m2;
  settle_areas(out, inside, body_m2);
  return out;
}

Tally curved_tally_by_booleans(const LaidTracks& tracks, double width_m, const Region& body,
                               double sagitta_m) {
  Tally out = counts(tracks, width_m);
  Region swaths;
  for (const LaidPiece& piece : tracks.pieces)
    for (const PathSegment& segment : piece.path) swaths.push_back({band({segment}, width_m, sagitta_m), {}});
  const double useful = area(intersection(unite(swaths), body));
  settle_areas(out, useful, area(body));
  return out;
}

}  // namespace tramline
