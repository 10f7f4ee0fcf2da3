#pragma once
// The line of one track, straight or curved: its course if there were no obstacles.

#include <optional>
#include <variant>

#include "tramline/check/lines/parallel_line.h"
#include "tramline/check/lines/straight_line.h"

namespace tramline::check {

/// The queries of rules about the line of a track of any shape. For a parallel it refers to the reference,
/// which has to outlive it.
class TrackLine {
 public:
  explicit TrackLine(const StraightLine& line) : line_(line) {}
  explicit TrackLine(const ParallelLine& line) : line_(line) {}

  /// The position of a point on the line, to within kLengthTolerance_m; nullopt where the point is off the
  /// line.
  std::optional<TrackPosition> position_of(Point p) const;
  /// Walks forwards from one position to another; the walk ends as kPassed where a corner skips the second. A
  /// closed line is followed at most once round.
  Walk walk(const TrackPosition& from, const TrackPosition& to) const;
  /// The path along the line from one point to another; nullopt where the line does not lead from the one to
  /// the other. Points may be a millimetre off. On a curve, which may be closed, the heading at the first
  /// point determines the direction.
  std::optional<Path> between(Point from, Point heading, Point to) const;
  /// Whether the line could be closed.
  bool may_close() const;

 private:
  std::variant<StraightLine, ParallelLine> line_;
};

}  // namespace tramline::check
