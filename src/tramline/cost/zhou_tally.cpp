#include "tramline/cost/zhou_tally.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "tramline/cost/settled_areas.h"
#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

/// A single polygon where the swath does not fold: it would have many times as many cells.
Region swath_of(const LaidPiece& piece, double width_m) {
  Polygon outline{kinked_band(piece.path, width_m), {}};
  if (!find_invalidity(outline)) return {std::move(outline)};
  return kinked_swaths({piece}, width_m);
}

}  // namespace

Region kinked_swaths(const std::vector<LaidPiece>& pieces, double width_m) {
  Region out;
  for (const LaidPiece& piece : pieces)
    for (Ring& cell : kinked_cells(piece.path, width_m)) out.push_back({std::move(cell), {}});
  return out;
}

ZhouTally zhou_tally(const LaidTracks& tracks, double width_m, const Region& body) {
  assert(std::ranges::none_of(tracks.pieces, [](const LaidPiece& piece) { return has_arcs(piece.path); }));
  ZhouTally out;
  Region swaths;
  for (const LaidPiece& piece : tracks.pieces) {
    for (Polygon& part : swath_of(piece, width_m)) swaths.push_back(std::move(part));
    out.tally.track_length_m += piece.length_m;
    out.tally.stops += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
    ++out.tally.pieces;
  }
  out.tally.turns = std::max(0, out.tally.pieces - 1);
  out.tally.worked_m2 = width_m * out.tally.track_length_m;
  out.worked = unite(swaths);
  settle_areas(out.tally, area(intersection(out.worked, body)), area(body));
  return out;
}

}  // namespace tramline
