#pragma once
// The line of one curved track from its definition: the places at one distance from the reference, and round
// the corners where these meet at an angle, arcs.
//
// A place of the reference has its place of the line straight across from it, as long as the swath there is
// nearest to that place of the reference: the point half a width beyond the line is no nearer to any other.
// Where not even a disc of the least radius ρ fits beyond the line, the line cuts the corner: the disc rolls
// on as far as it fits, and its edge joins both sides. Corners of more than 120° are not driven round. All is
// found by asking how far single points are from the reference: no parallel is made as a whole.

#include <optional>
#include <vector>

#include "tramline/check/lines/reference_side.h"
#include "tramline/check/lines/track_place.h"

namespace tramline::check {

/// The line at a distance to the right of a reference. Refers to the reference, which has to outlive it.
class ParallelLine {
 public:
  /// `looks_m`: places along the reference, ascending from its beginning to its end, so near to one another
  /// that between two nothing begins and ends.
  ParallelLine(const ReferenceSide& reference, const std::vector<double>& looks_m, double off_m,
               double width_m, double least_radius_m);

  /// Where a point lies on the line, or so near to it as kLengthTolerance_m; nullopt where it is off it.
  std::optional<TrackPlace> place_of(Point p) const;
  /// Forwards from one place to another: passed where a corner leaves the second out. A line that comes back
  /// to where it began is followed once round.
  Walk walk(const TrackPlace& from, const TrackPlace& to) const;
  /// Could it come back to where it began? It could where an end of the reference lies on the reference.
  bool may_close() const { return reference_.touches_itself(); }
  /// Is the arc one that rolls round a corner, at a point on it that is farther from the reference than the
  /// line?
  bool rolls_round_corner(const PathSegment& arc, Point on_arc) const;

 private:
  /// Where two sides are joined: the disc touches the line at both.
  struct Corner {
    double from_m = 0;  ///< along the reference
    double to_m = 0;
    Point centre;
    Path arc;  ///< of one segment, or empty
  };
  /// How far the line goes on beside the reference.
  struct Stretch {
    double end_m = 0;
    std::optional<double> last_wide_m;  ///< the last place with room for the disc, if any
  };
  enum class Way { kForwards, kBackwards };

  bool fits(double along_m) const;  ///< a disc of the least radius
  bool is_driven(
      double along_m) const;  ///< the swath is nearest to its place, and no tighter than can be driven
  template <class Holds>
  double last_that(Holds holds, double holds_m, double not_m) const;
  std::vector<double>::const_iterator first_look_after(double along_m) const;
  Stretch stretch(double from_m, Way way) const;
  std::optional<double> nearest_that_fits(double from_m, Way way) const;
  double edge_behind(double along_m, Way way) const;
  /// The other place of the reference that the disc at the edge of where it fits touches.
  std::optional<double> other_foot(double edge_m, Way way) const;
  std::optional<Corner> corner_from(double edge_m) const;
  /// The corner with a point on its arc that is nearest to a place of the reference.
  std::optional<Corner> corner_with(Point p, double along_m) const;
  TrackPlace beside(double along_m) const;
  TrackPlace settled(const Foot& foot) const;

  const ReferenceSide& reference_;
  const std::vector<double>& looks_m_;
  double off_m_;
  double width_m_;
  double least_radius_m_;
};

}  // namespace tramline::check
