#pragma once
// The lines of tracks that follow a curve: their courses if there were no obstacles.

#include <cassert>
#include <optional>
#include <vector>

#include "tramline/check/lines/track_line.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// A reference seen from both sides, and the lines at (k + ½) working widths from it, k being the track's
/// number. There are no lines where the reference is not one that tracks can follow.
class TrackLines {
 public:
  TrackLines() = default;
  TrackLines(const Path& reference, const Machine& machine);

  bool known() const { return !sides_.empty(); }
  /// The line of the track with this number. Precondition: known().
  ParallelLine line(int track) const;
  /// The reference seen so that the track lies to its right. Precondition: known().
  const ReferenceSide& side_of(int track) const {
    assert(known());
    return sides_[track < 0 ? 1 : 0];
  }
  /// The distance of a track from the reference, m.
  double off_m(int track) const;
  /// Numbers of the tracks on whose lines a point may lie, nearest first. Precondition: known().
  std::vector<int> tracks_near(Point p) const;

 private:
  double width_m_ = 0;
  double least_radius_m_ = 0;
  std::vector<ReferenceSide> sides_;          ///< its right side, and its left side seen in reverse
  std::vector<std::vector<double>> looks_m_;  ///< sampling positions along each side
};

/// The track lines of a plan, by subfield.
class PlanLines {
 public:
  explicit PlanLines(const Plan& plan);

  /// The lines of a subfield; without lines where no piece of the subfield is curved, or where there is no
  /// such subfield.
  const TrackLines& of(std::size_t subfield) const;
  /// The line that a piece follows except on its detours: the straight line through its ends, or that of its
  /// curved track; nullopt where that is not known. Precondition: the piece is sound (check_pieces).
  std::optional<TrackLine> along(const TrackPiece& piece) const;

 private:
  std::vector<TrackLines> lines_;         ///< for each reference; the first has no lines
  std::vector<std::size_t> by_subfield_;  ///< index into lines_
};

/// Whether a point is on the path, up to a millimetre.
bool holds(const Path& path, Point p);

}  // namespace tramline::check
