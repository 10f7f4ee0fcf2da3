#pragma once
// What the pieces of one family of curved tracks amount to, in closed form.

#include "tramline/model/tally.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// Swaths of one family have no ground in common (parallel.h), so what they cover of the body is the sum of
/// what each does: worked = Σ w·L, overlap = Σ (w·L − inside), uncovered = body − Σ inside. Exact up to
/// rounding. The identity worked = body − uncovered + overlap holds by construction: what there is to check
/// is that no ground is worked twice, see curved_tally_by_booleans(). Detours have ground in common with
/// other swaths: `by_detours_m2` is what they cover of the body besides (covered_by_detours_m2). O(pieces).
Tally curved_tally(const LaidTracks& tracks, double width_m, double body_m2, double by_detours_m2 = 0);

/// The same through polygon booleans, with chords for arcs: for tests. Slow.
Tally curved_tally_by_booleans(const LaidTracks& tracks, double width_m, const Region& body,
                               double sagitta_m = kChordSagitta);

}  // namespace tramline
