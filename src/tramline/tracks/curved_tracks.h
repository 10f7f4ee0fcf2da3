#pragma once
// Tracks parallel to a curve, over one subfield or several (S2.12, with the end rules of straight tracks).

#include <vector>

#include "tramline/geometry/offset/parallel.h"
#include "tramline/tracks/end_rule.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// What curved tracks have to keep to. Frame: the field's.
struct CurvedGround {
  EdgeIndex body;                ///< what is to be covered; passable land may lie in it
  EdgeIndex hard{Region{}};      ///< no swath enters it: obstacles, given-up land
  EdgeIndex field{Region{}};     ///< no swath leaves it; a region without edges: any may
  EdgeIndex passable{Region{}};  ///< crossed with the work interrupted
  EdgeIndex beyond{Region{}};    ///< entered by no swath, and no stop either: it is not of the field
};

/// Those tracks of `parallel` that may be driven somewhere under the end rule. Exact up to 1e-8 m along arcs
/// and rounding along straight lines. Closed tracks that something hard blocks begin in the middle of their
/// longest stretch. Precondition: regions of the ground oriented; the width `parallel` was made with.
TrackFamily curved_tracks(const std::vector<FamilyTrack>& parallel, double width_m,
                          const CurvedGround& ground, const EndCriterion& criterion);

/// What is driven on them without detours.
LaidTracks curved_pieces(const std::vector<FamilyTrack>& parallel, double width_m, const CurvedGround& ground,
                         const EndCriterion& criterion, double min_length_m);

/// The tracks parallel to a reference that may reach the box.
/// Precondition: the reference leaves the box behind at both ends (extended_line.h).
StripRange tracks_over(const Path& reference, const Box& box, double width_m);

}  // namespace tramline
