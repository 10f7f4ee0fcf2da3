#pragma once
// The line of one track, straight or curved: where it would be driven if nothing stood in its way.

#include <optional>
#include <variant>

#include "tramline/check/lines/parallel_line.h"
#include "tramline/check/lines/straight_line.h"

namespace tramline::check {

/// What rules ask of the line of a track, whatever its shape. Of a parallel it refers to the reference, which
/// has to outlive it.
class TrackLine {
 public:
  explicit TrackLine(const StraightLine& line) : line_(line) {}
  explicit TrackLine(const ParallelLine& line) : line_(line) {}

  /// Where a point lies on the line, up to kLengthTolerance_m; nullopt where it is off it.
  std::optional<TrackPlace> place_of(Point p) const;
  /// Forwards from one place to another: passed where a corner leaves the second out. A line that comes back
  /// to where it began is followed once round.
  Walk walk(const TrackPlace& from, const TrackPlace& to) const;
  /// What is driven along the line from one point to another; nullopt where it does not lead from the one to
  /// the other. Points may be a millimetre off. Which way along a curve is told by the heading at the first:
  /// such a line may be closed.
  std::optional<Path> between(Point from, Point heading, Point to) const;
  /// Could the line come back to where it began?
  bool may_close() const;

 private:
  std::variant<StraightLine, ParallelLine> line_;
};

}  // namespace tramline::check
