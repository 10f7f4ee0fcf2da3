#pragma once
// The lines of tracks that follow a curve: where a track would be if nothing stood in its way.

#include <cassert>
#include <optional>
#include <vector>

#include "tramline/check/lines/track_line.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// A reference from both sides, and the lines at (k + ½) working widths from it, k being the track's number;
/// none where the reference is nothing that tracks can follow.
class TrackLines {
 public:
  TrackLines() = default;
  TrackLines(const Path& reference, const Machine& machine);

  bool known() const { return !sides_.empty(); }
  /// Of a track's number. Precondition: known().
  ParallelLine line(int track) const;
  /// The reference seen so that the track lies to its right. Precondition: known().
  const ReferenceSide& side_of(int track) const {
    assert(known());
    return sides_[track < 0 ? 1 : 0];
  }
  /// How far from the reference a track runs, m.
  double off_m(int track) const;
  /// Numbers of tracks on whose lines a place may be, nearest first. Precondition: known().
  std::vector<int> tracks_near(Point p) const;

 private:
  double width_m_ = 0;
  double least_radius_m_ = 0;
  std::vector<ReferenceSide> sides_;          ///< its right, and its left looking back
  std::vector<std::vector<double>> looks_m_;  ///< along each
};

/// Those of a plan, by subfield.
class PlanLines {
 public:
  explicit PlanLines(const Plan& plan);

  /// None where no piece of the subfield is curved, or where there is no such subfield.
  const TrackLines& of(std::size_t subfield) const;
  /// The line that a piece keeps to but for its detours: the straight one through its ends, or that of its
  /// curved track, nullopt where that is not known. Precondition: the piece is sound (check_pieces).
  std::optional<TrackLine> along(const TrackPiece& piece) const;

 private:
  std::vector<TrackLines> lines_;         ///< of each reference; the first are none
  std::vector<std::size_t> by_subfield_;  ///< index into lines_
};

/// Is a place on the path, up to a millimetre?
bool holds(const Path& path, Point p);

}  // namespace tramline::check
