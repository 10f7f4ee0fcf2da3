#include "tramline/cost/strip_tally.h"

#include <algorithm>

#include "tramline/cost/settled_areas.h"
#include "tramline/cost/worked/border_overrun.h"

namespace tramline {

Tally tally_of(const std::vector<Subfield>& subfields, const std::vector<LaidTracks>& tracks, double body_m2,
               double by_detours_m2) {
  Tally tally;
  double useful_m2 = by_detours_m2;
  for (const LaidTracks& subfield : tracks) {
    tally.subfields += subfield.pieces.empty() ? 0 : 1;
    for (const LaidPiece& piece : subfield.pieces) {
      tally.track_length_m += piece.length_m;
      tally.worked_m2 += subfield.grid.width_m * piece.length_m;
      useful_m2 += piece.inside_m2;
      tally.pieces += 1;
      tally.crossings += piece.after_crossing ? 1 : 0;
      tally.stops += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
    }
  }
  useful_m2 += covered_by_neighbours_m2(subfields, tracks);
  tally.turns = std::max(0, tally.pieces - 1 - tally.crossings);
  settle_areas(tally, useful_m2, body_m2);
  return tally;
}

}  // namespace tramline
