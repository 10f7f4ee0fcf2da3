#pragma once
// The pieces driven in the strips of one subfield.

#include <vector>

#include "tramline/model/detour.h"
#include "tramline/tracks/strips.h"

namespace tramline {

/// A stretch shorter than this is nothing: a detour may begin where its stretch does, and two passable
/// obstacles may all but touch.
inline constexpr double kNoPiece_m = 1e-3;

/// A detour of a strip's track, in the grid's plane, running along the strip; or of a curved track, in the
/// field's frame.
struct StripDetour {
  double from = 0;  ///< coordinates along, of the two ends on the centre line; positions along a curved one
  double to = 0;
  Path path;
  double length_m = 0;  ///< of the path
  Passing side = Passing::kLeft;
  std::vector<int> obstacles;  ///< indices into Field::obstacles
};

/// A piece in its strip: coordinates along the grid's direction, from < to.
struct StripPiece {
  int strip = 0;
  double from = 0;
  double to = 0;
  bool stop_at_from = false;
  bool stop_at_to = false;
  bool after_crossing = false;         ///< a passable obstacle, and nothing else, lies before `from`
  double inside_m2 = 0;                ///< area of the straight parts' swath inside their own subfield
  std::vector<StripDetour> detours{};  ///< along the strip, not overlapping
};

/// Where the piece runs straight: before, between and after its detours.
Intervals straight_parts(const StripPiece& piece);
/// Length of the path driven, m.
double length(const StripPiece& piece);

/// One subfield with its tracks.
struct SubfieldTracks {
  StripGrid grid;
  std::vector<StripPiece> pieces;   ///< by strip, then along
  std::vector<StripPiece> dropped;  ///< shorter than the machine's least length (S1.14)
};

/// A stretch of a strip, or several that detours join.
struct JoinedStretch {
  Interval whole;
  std::vector<StripDetour> detours{};
};

/// The stretches of a strip as the detours join them. Preconditions as for append_pieces.
std::vector<JoinedStretch> joined_stretches(const Intervals& stretches,
                                            const std::vector<StripDetour>& detours);

/// What is driven in one go, or would be were it longer: between two crossings.
struct LaidPart {
  Interval whole;
  std::vector<StripDetour> detours{};
  double length_m = 0;  ///< of the path
  bool driven = false;
  bool after_crossing = false;
};

/// A joined stretch, interrupted by passable obstacles: what is shorter than the least length is dropped from
/// both ends inwards.
std::vector<LaidPart> laid_parts(const JoinedStretch& joined, const Intervals& passable, double min_length_m);

/// The pieces of one joined stretch; see append_pieces.
void append_joined(const Strip& strip, const JoinedStretch& joined, double min_length_m, SubfieldTracks& out);

/// The pieces of one strip, whose stretches the detours join; passable obstacles interrupt them. What is
/// shorter than the least length is dropped, from both ends of a joined stretch inwards: what lies
/// between two pieces that are driven is driven. Appended to `pieces` and `dropped`.
/// Preconditions: detours are sorted and do not overlap; each begins and ends within a stretch and lies
/// clear of passable obstacles.
void append_pieces(const Strip& strip, const std::vector<StripDetour>& detours, double min_length_m,
                   SubfieldTracks& out);

/// All strips without detours: every stretch ends before anything hard (S1.40).
SubfieldTracks cut_pieces(const Strips& strips, double min_length_m);

}  // namespace tramline
