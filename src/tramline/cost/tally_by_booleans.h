#pragma once
// What curved tracks amount to, by another road.

#include "tramline/model/tally.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// As tally_of(), for pieces of curved tracks, through polygon booleans with chords for arcs: for tests.
/// Slow.
Tally tally_by_booleans(const LaidTracks& tracks, const Region& body, double sagitta_m = kChordSagitta);

}  // namespace tramline
