#pragma once
// The pieces driven on tracks.

#include <vector>

#include "tramline/model/detour.h"
#include "tramline/tracks/track.h"

namespace tramline {

/// A detour of a track. Its path lies in the frame of the family's grid and runs the way the track does.
struct TrackDetour {
  double from = 0;  ///< positions along the track, of the two ends
  double to = 0;
  Path path;
  double length_m = 0;  ///< of the path
  Passing side = Passing::kLeft;
  std::vector<std::size_t> obstacles;  ///< indices into Field::obstacles
};

/// A piece of one track, driven the way the track runs: positions along it, from < to.
struct LaidPiece {
  int track = 0;    ///< Track::index
  int branch = 0;   ///< Track::branch
  double from = 0;  ///< beyond the length of a closed track where the piece continues past its beginning
  double to = 0;
  Path path{};           ///< driven path on a curved track, detours included; empty on a straight one
  double length_m = 0;   ///< of the driven path, detours included
  double inside_m2 = 0;  ///< area of the swath inside the subfield where the piece keeps to its track
  bool stop_at_from = false;
  bool stop_at_to = false;
  bool after_crossing = false;         ///< a passable obstacle, and nothing else, lies before `from`
  std::vector<TrackDetour> detours{};  ///< along the track, not overlapping
  double short_at_from_m = 0;          ///< by so much cut_to() has cut it at `from`
  double short_at_to_m = 0;
};

/// The stretches in which the piece keeps to its track: before, between and after its detours.
Intervals parts_on_track(const LaidPiece& piece);

/// The same parts as paths in the frame of the grid. Precondition: the piece is one of a curved track.
std::vector<Path> paths_on_track(const LaidPiece& piece);

/// The piece between two positions along its track, of which none lies in or beyond one of its detours.
/// Preconditions: the piece is one of the track, which is not closed, and piece.from ≤ from < to ≤ piece.to.
LaidPiece cut_to(const Track& track, const LaidPiece& piece, double from, double to);

/// The pieces driven on the tracks of one family.
struct LaidTracks {
  StripGrid grid;
  std::vector<LaidPiece> pieces;   ///< by track, then along
  std::vector<LaidPiece> dropped;  ///< shorter than the machine's least length (Versleijen §2.2.1)
};

/// A stretch of a track, or several that detours join.
struct JoinedStretch {
  Interval whole;
  std::vector<TrackDetour> detours{};
};

/// The stretches of a track as joined by the detours. Preconditions as for append_pieces.
std::vector<JoinedStretch> joined_stretches(const Intervals& stretches,
                                            const std::vector<TrackDetour>& detours);

/// Appends the pieces of one joined stretch, which may lie across the beginning of a closed track; see
/// append_pieces.
void append_joined(const Track& track, const JoinedStretch& joined, double min_length_m, LaidTracks& out);

/// Appends the pieces of one track to `pieces` and `dropped`. Detours join its stretches; passable obstacles
/// interrupt them. Pieces shorter than the least length are dropped from both ends of a joined stretch
/// inwards: everything between two driven pieces is driven. A stretch across the beginning of a closed track
/// is one piece. Preconditions: detours are sorted and do not overlap; each begins and ends within a stretch
/// and lies clear of passable obstacles.
void append_pieces(const Track& track, const std::vector<TrackDetour>& detours, double min_length_m,
                   LaidTracks& out);

/// All tracks without detours: every stretch ends before anything hard (Versleijen fig. 20).
LaidTracks cut_pieces(const TrackFamily& family, double min_length_m);

}  // namespace tramline
