#include "tramline/cost/tally_by_booleans.h"

#include <algorithm>

#include "tramline/cost/settled_areas.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {

namespace {

/// The driven path in the field's frame.
Path driven_path(const LaidPiece& piece, const StripGrid& grid) {
  Path out = piece.path;
  if (out.empty()) {
    const double across = grid.centre(piece.track);
    double at = piece.from;
    for (const TrackDetour& detour : piece.detours) {
      if (detour.from > at) out.push_back({{across, at}, {across, detour.from}, 0});
      out.insert(out.end(), detour.path.begin(), detour.path.end());
      at = detour.to;
    }
    if (piece.to > at) out.push_back({{across, at}, {across, piece.to}, 0});
  }
  return moved(out, [&grid](Point p) { return grid.frame.to_field(p); });
}

}  // namespace

Tally tally_by_booleans(const std::vector<LaidTracks>& tracks, const Region& body, double sagitta_m) {
  Tally out;
  Region swaths;
  for (const LaidTracks& family : tracks) {
    const double width_m = family.grid.width_m;
    out.subfields += family.pieces.empty() ? 0 : 1;
    for (const LaidPiece& piece : family.pieces) {
      out.worked_m2 += width_m * piece.length_m;
      out.track_length_m += piece.length_m;
      out.stops += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
      out.crossings += piece.after_crossing ? 1 : 0;
      ++out.pieces;
      for (const PathSegment& segment : driven_path(piece, family.grid))
        swaths.push_back({band({segment}, width_m, sagitta_m), {}});
    }
  }
  out.turns = std::max(0, out.pieces - 1 - out.crossings);
  settle_areas(out, area(intersection(unite(swaths), body)), area(body));
  return out;
}

}  // namespace tramline
