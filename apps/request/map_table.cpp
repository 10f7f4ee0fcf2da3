#include "request/map_table.h"

#include <set>

namespace tramline::app {

MapCell map_cell(const MapDirection& asked, const Plan& plan, double seconds) {
  MapCell out{asked, plan.machine, plan.track_tally, area(plan.body), plan.cost};
  out.seconds = seconds;
  std::set<std::size_t> with_tracks;
  for (const TrackPiece& piece : plan.pieces) with_tracks.insert(piece.subfield);
  for (const std::size_t subfield : with_tracks) out.directions.push_back(plan.subfields[subfield].direction);
  return out;
}

}  // namespace tramline::app
