#pragma once
// The tally of tracks, computed in another way.

#include "tramline/model/tally.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// As tally_of(), detours included, through polygon booleans with chords for arcs: for tests. Slow.
Tally tally_by_booleans(const std::vector<LaidTracks>& tracks, const Region& body,
                        double sagitta_m = kChordSagitta);

}  // namespace tramline
