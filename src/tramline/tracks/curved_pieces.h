#pragma once
// The pieces driven on a family of curved tracks over one subfield (S2.12, with the end rules of straight
// tracks).

#include <vector>

#include "tramline/geometry/parallel.h"
#include "tramline/geometry/path_profile.h"
#include "tramline/tracks/strip_pieces.h"

namespace tramline {

/// What the pieces of one subfield have to keep to. Frame: the field's.
struct CurvedGround {
  EdgeIndex body;                ///< what is to be covered; passable land may lie in it
  EdgeIndex hard{Region{}};      ///< no swath enters it: obstacles, given-up land
  EdgeIndex field{Region{}};     ///< no swath leaves it; a region without edges: any may
  EdgeIndex passable{Region{}};  ///< crossed with the work interrupted
  EdgeIndex beyond{Region{}};    ///< entered by no swath, and no stop either: it is not of the field
};

/// One path of a family, and where it may be driven. Positions are metres along the path.
struct CurvedTrack {
  int index = 0;   ///< the swath lies between index·w and (index + 1)·w right of the reference
  int branch = 0;  ///< which of the track's paths
  bool closed = false;
  Path path;
  double length_m = 0;
  PathProfile body;
  PathProfile hard;
  Intervals by_hard;      ///< where anything hard reaches into the swath
  Intervals by_passable;  ///< where a passable obstacle does
  Intervals stretches;    ///< what the end rule allows, less what is hard or beyond
};

/// A piece of one track, driven in the sense of the reference.
struct CurvedPiece {
  int track = 0;    ///< CurvedTrack::index
  int branch = 0;   ///< which of the track's paths
  double from = 0;  ///< positions along that path, m; beyond its length where it is closed and goes on
  double to = 0;
  Path path{};  ///< what is driven, detours included
  double length_m = 0;
  double inside_m2 = 0;       ///< area of the swath inside the body, without detours
  bool stop_at_from = false;  ///< something hard lies ahead
  bool stop_at_to = false;
  bool after_crossing = false;         ///< a passable obstacle, and nothing else, lies before `from`
  std::vector<StripDetour> detours{};  ///< along the track, not overlapping
};

struct CurvedTracks {
  std::vector<CurvedPiece> pieces;   ///< by track, branch and place
  std::vector<CurvedPiece> dropped;  ///< shorter than the least length (S1.14)
};

/// Where each track of a family may be driven under the end rule; those that may be somewhere. Exact up to
/// 1e-8 m along arcs and rounding along straight lines. Closed tracks that something hard blocks begin in
/// the middle of their longest stretch.
/// Precondition: regions of the ground oriented; the family's width.
std::vector<CurvedTrack> curved_tracks(const std::vector<FamilyTrack>& family, double width_m,
                                       const CurvedGround& ground, const EndCriterion& criterion);

/// The pieces of one track, whose stretches the detours join; passable obstacles interrupt them, and what is
/// too short is dropped, as on straight strips. A stretch across the place where a closed track begins comes
/// as one piece. Appended to `pieces` and `dropped`. Preconditions as for append_pieces of strips.
void append_pieces(const CurvedTrack& track, const std::vector<StripDetour>& detours, double min_length_m,
                   CurvedTracks& out);

/// The pieces of one joined stretch, which may lie across the beginning of a closed track.
void append_joined(const CurvedTrack& track, const JoinedStretch& joined, double min_length_m,
                   CurvedTracks& out);

/// All tracks without detours: cut before anything hard.
CurvedTracks cut_pieces(const std::vector<CurvedTrack>& tracks, double min_length_m);
CurvedTracks curved_pieces(const std::vector<FamilyTrack>& family, double width_m, const CurvedGround& ground,
                           const EndCriterion& criterion, double min_length_m);

/// Where a piece keeps to its track: before, between and after its detours.
Intervals parts_on_track(const CurvedPiece& piece);
/// The track between two positions; from beyond its length on, a closed one goes on from its beginning.
Path path_along(const CurvedTrack& track, double from, double to);
/// Area of the body within the track's swath between two such positions, m².
double inside_between(const CurvedTrack& track, double from, double to);

/// The tracks of a reference that may reach the box: the first and last k of its family.
struct TrackRange {
  int first = 0;
  int last = -1;
};
/// Precondition: the reference leaves the box behind at both ends (extended.h).
TrackRange tracks_over(const Path& reference, const Box& box, double width_m);

}  // namespace tramline
