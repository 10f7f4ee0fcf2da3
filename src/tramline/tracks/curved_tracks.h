#pragma once
// Tracks parallel to a curve, over one subfield or several (Zhou algorithm 2, with the end rules of straight
// tracks).

#include <vector>

#include "tramline/geometry/offset/parallel.h"
#include "tramline/tracks/end_rule.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// The land that curved tracks have to heed. Frame: the field's.
struct CurvedGround {
  EdgeIndex body;                ///< land to be covered; passable land may lie in it
  EdgeIndex hard{Region{}};      ///< no swath enters it: obstacles, given-up land
  EdgeIndex field{Region{}};     ///< no swath leaves it; without edges: swaths may leave
  EdgeIndex passable{Region{}};  ///< crossed with the work interrupted
  EdgeIndex beyond{Region{}};  ///< not part of the field: no swath enters it, and an end before it is no stop
};

/// The tracks of `parallel` that may be driven somewhere under the end rule. Exact up to 1e-8 m along arcs
/// and up to rounding along straight lines. Closed tracks blocked by hard land begin in the middle of their
/// longest stretch. Precondition: regions of the ground oriented; the width `parallel` was made with.
TrackFamily curved_tracks(const std::vector<FamilyTrack>& parallel, double width_m,
                          const CurvedGround& ground, const EndCriterion& criterion);

/// The pieces driven on these tracks without detours.
LaidTracks curved_pieces(const std::vector<FamilyTrack>& parallel, double width_m, const CurvedGround& ground,
                         const EndCriterion& criterion, double min_length_m);

/// The tracks parallel to a reference that may reach the box.
/// Precondition: the reference leaves the box behind at both ends (extended_line.h).
StripRange tracks_over(const Path& reference, const Box& box, double width_m);

}  // namespace tramline
