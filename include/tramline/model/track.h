#pragma once

#include <cstddef>
#include <optional>

#include "tramline/geometry/path/path.h"
#include "tramline/model/detour.h"

namespace tramline {

/// One uninterrupted stretch driven with the work on: along the track from start to end, but for the detours,
/// and the flat-ended swath of the working width along that.
struct TrackPiece {
  Point start;
  Point end;
  std::size_t subfield = 0;  ///< index into Plan::subfields
  int track = 0;             ///< number of the strip within the subfield, from 0 at its origin edge
  bool stop_at_start = false;
  bool stop_at_end = false;
  /// The same track goes on beyond a passable obstacle that lies between the previous piece (in
  /// driving order) and this one: neither a turn nor a stop.
  bool after_crossing = false;
  std::vector<Detour> detours{};  ///< in driving order; they do not overlap
  /// What is driven where the track is curved, from start to end: lines and arcs, tangents continuous, the
  /// detours among them; or as in S2 straight lines with kinks and no detours. Empty: the straight line but
  /// for the detours.
  Path curve{};
  /// What of its swath lies outside the body or is worked by a piece before it, m² (S2.14); unknown in plans
  /// made by hand and in older files.
  std::optional<double> overlap_m2{};
};

/// What the machine follows, from start to end. Precondition: start != end.
Path centre_line(const TrackPiece& piece);
double length(const TrackPiece& piece);

/// The ground a piece works, counter-clockwise; arcs as chords (kChordSagitta), kinks as kinked_band() has
/// them. Precondition: start != end.
Ring swath(const TrackPiece& piece, double width_m);

/// The straight parts of a piece that is not curved: before, between and after its detours.
std::vector<PathSegment> straight_parts(const TrackPiece& piece);
/// Where a piece keeps to its track, be it curved or not: before, between and after its detours.
std::vector<Path> parts_on_track(const TrackPiece& piece);
/// The swath in parts that only touch: a rectangle for each straight part, a band for each detour; one band
/// where the piece is curved; what kinked_cells() gives where it has kinks.
std::vector<Ring> swath_parts(const TrackPiece& piece, double width_m, double sagitta_m = kChordSagitta);

}  // namespace tramline
