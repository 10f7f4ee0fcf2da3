#pragma once
// The line of one curved track by its definition: the points at one distance from the reference, and arcs
// round the corners where these meet at an angle.
// A point of the line lies straight across from a point of the reference as long as the swath there is
// nearest to that point of the reference, that is, as long as the point half a width beyond the line is no
// nearer to any other. Where not even a disc of the least radius ρ fits beyond the line, the line cuts the
// corner: the disc rolls on as far as it fits, and its edge joins both sides. Corners of more than 120° are
// not driven round. Everything is computed from the distances of single points from the reference; no
// parallel is constructed as a whole.

#include <optional>
#include <vector>

#include "tramline/check/lines/reference_side.h"
#include "tramline/check/lines/track_position.h"

namespace tramline::check {

/// The line at a given distance to the right of a reference. Refers to the reference, which has to outlive
/// it.
class ParallelLine {
 public:
  /// `looks_m`: sampling positions along the reference, ascending from its beginning to its end, so close
  /// together that no feature of the line begins and ends between two of them.
  ParallelLine(const ReferenceSide& reference, const std::vector<double>& looks_m, double off_m,
               double width_m, double least_radius_m);

  /// The position of a point on the line, to within kLengthTolerance_m; nullopt where the point is off the
  /// line.
  std::optional<TrackPosition> position_of(Point p) const;
  /// Walks forwards from one position to another; the walk ends as kPassed where a corner skips the second. A
  /// closed line is followed at most once round.
  Walk walk(const TrackPosition& from, const TrackPosition& to) const;
  /// Whether the line could be closed. It could where an end of the reference lies on the reference.
  bool may_close() const { return reference_.touches_itself(); }
  /// Whether the arc is one that rolls round a corner, given a point on it that is farther from the reference
  /// than the line.
  bool rolls_round_corner(const PathSegment& arc, Point on_arc) const;

 private:
  /// A corner where two sides of the line are joined; the disc touches both.
  struct Corner {
    double from_m = 0;  ///< along the reference
    double to_m = 0;
    Point centre;
    Path arc;  ///< of one segment, or empty
  };
  /// The extent of the line beside the reference without a corner.
  struct Stretch {
    double end_m = 0;
    std::optional<double> last_wide_m;  ///< the last position with room for the disc, if any
  };
  enum class Way { kForwards, kBackwards };

  bool fits(double along_m) const;       ///< whether a disc of the least radius fits
  bool is_driven(double along_m) const;  ///< whether the swath is nearest to its point of the reference, and
                                         ///< no tighter than can be driven
  template <class Holds>
  double last_that(Holds holds, double holds_m, double not_m) const;
  std::vector<double>::const_iterator first_look_after(double along_m) const;
  Stretch stretch(double from_m, Way way) const;
  std::optional<double> nearest_that_fits(double from_m, Way way) const;
  double edge_behind(double along_m, Way way) const;
  /// The other position on the reference that is touched by the disc at the edge of the stretch where it
  /// fits.
  std::optional<double> other_foot(double edge_m, Way way) const;
  std::optional<Corner> corner_from(double edge_m) const;
  /// The corner that has on its arc the point `p`, whose nearest position on the reference is `along_m`.
  std::optional<Corner> corner_with(Point p, double along_m) const;
  TrackPosition beside(double along_m) const;
  TrackPosition settled(const Foot& foot) const;

  const ReferenceSide& reference_;
  const std::vector<double>& looks_m_;
  double off_m_;
  double width_m_;
  double least_radius_m_;
};

}  // namespace tramline::check
