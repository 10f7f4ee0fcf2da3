#pragma once
// The pieces driven on a family of curved tracks over one subfield (S2.12, with the end rules of straight
// tracks).

#include <vector>

#include "tramline/geometry/parallel.h"
#include "tramline/geometry/path_profile.h"
#include "tramline/tracks/end_rule.h"

namespace tramline {

/// What the pieces of one subfield have to keep to. Frame: the field's.
struct CurvedGround {
  EdgeIndex body;             ///< what is to be covered
  EdgeIndex hard{Region{}};   ///< no swath enters it: obstacles, given-up land
  EdgeIndex field{Region{}};  ///< no swath leaves it; a region without edges: any may
};

/// A stretch of one track, driven in the sense of the reference.
struct CurvedPiece {
  int track = 0;    ///< the swath lies between track·w and (track + 1)·w right of the reference
  int branch = 0;   ///< which of the track's paths
  double from = 0;  ///< positions along that path, m
  double to = 0;
  Path path;
  double length_m = 0;
  double inside_m2 = 0;       ///< area of the swath inside the body
  bool stop_at_from = false;  ///< something hard lies ahead
  bool stop_at_to = false;
};

struct CurvedTracks {
  std::vector<CurvedPiece> pieces;   ///< by track, branch and place
  std::vector<CurvedPiece> dropped;  ///< shorter than the least length (S1.14)
};

/// Where each track of a family may be driven under the end rule; cut before anything hard. Exact up to
/// 1e-8 m along arcs and rounding along straight lines.
/// Closed tracks begin where their path does; a stretch across that place comes as one piece.
/// Precondition: regions of the ground oriented; the family's width.
CurvedTracks curved_pieces(const std::vector<FamilyTrack>& family, double width_m, const CurvedGround& ground,
                           const EndCriterion& criterion, double min_length_m);

/// What the tracks of one number add to them, branch by branch.
void append_curved_pieces(int index, std::vector<ParallelTrack> tracks, double width_m,
                          const CurvedGround& ground, const EndCriterion& criterion, double min_length_m,
                          CurvedTracks& out);

/// The tracks of a reference that may reach the box: the first and last k of its family.
struct TrackRange {
  int first = 0;
  int last = -1;
};
/// Precondition: the reference leaves the box behind at both ends (extended.h).
TrackRange tracks_over(const Path& reference, const Box& box, double width_m);

}  // namespace tramline
