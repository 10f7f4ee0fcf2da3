#pragma once

#include <cstddef>
#include <optional>

#include "tramline/geometry/path/path.h"
#include "tramline/model/detour.h"

namespace tramline {

/// One uninterrupted stretch driven with the work on, along the track from start to end except on the
/// detours. It works the flat-ended swath of the working width along its path.
struct TrackPiece {
  Point start;
  Point end;
  std::size_t subfield = 0;  ///< index into Plan::subfields
  int track = 0;  ///< number of the strip within the subfield, from 0 at the subfield's origin edge
  bool stop_at_start = false;
  bool stop_at_end = false;
  /// The same track goes on beyond a passable obstacle that lies between the previous piece (in
  /// driving order) and this one: neither a turn nor a stop.
  bool after_crossing = false;
  std::vector<Detour> detours{};  ///< in driving order; they do not overlap
  /// The path of a curved track from start to end: lines and arcs with continuous tangents, detours included;
  /// or, as in Zhou, straight lines with kinks and without detours. Empty: a straight line except on the
  /// detours.
  Path curve{};
  /// The area of its swath that lies outside the body or is worked by an earlier piece, m² (Zhou §2.3.5);
  /// unknown in plans made by hand and in older files.
  std::optional<double> overlap_m2{};
};

/// The path that the machine follows, from start to end. Precondition: start != end.
Path centre_line(const TrackPiece& piece);
double length(const TrackPiece& piece);

/// The land a piece works, counter-clockwise; arcs as chords (kChordSagitta), kinks as in kinked_band().
/// Precondition: start != end.
Ring swath(const TrackPiece& piece, double width_m);

/// The straight parts of a piece that is not curved: before, between and after its detours.
std::vector<PathSegment> straight_parts(const TrackPiece& piece);
/// The parts of a straight or curved piece that lie on its track: before, between and after its detours.
std::vector<Path> parts_on_track(const TrackPiece& piece);
/// The swath in parts that touch but do not overlap: a rectangle for each straight part and a band for each
/// detour; for a curved piece one band; for a piece with kinks the result of kinked_cells().
std::vector<Ring> swath_parts(const TrackPiece& piece, double width_m, double sagitta_m = kChordSagitta);

}  // namespace tramline
