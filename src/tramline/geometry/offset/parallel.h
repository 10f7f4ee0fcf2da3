#pragma once
// Tracks parallel to a reference line (Zhou algorithm 2, not recursive): each is made from the line itself,
// so that the hundredth costs as much as the first and has no more rounding in it.
//
// The track at distance t follows the points that are t from the reference and whose normals reach on to t +
// w/2 without coming nearer to another part of it. So swaths of one family, w apart, never overlap: every
// point of the plane has one nearest point on the reference, except where two fronts meet.
//
// Where fronts meet at a corner, a disc of radius ρ = max(r, w/2) rolls round it: an arc of radius ρ about
// the point where the fronts at t + ρ meet joins the two branches. There the track is the boundary of E
// dilated by ρ, with E the points at t + ρ or more from the reference: never tighter than ρ, never nearer
// than t. A corner sharper than the limit is not driven round: both branches end in it.

#include <functional>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/path/path.h"

namespace tramline {

/// The machine and the limits that a family of tracks is made for.
struct TrackLimits {
  double radius_m = 6;                          ///< least turning radius r, ≥ 0
  double width_m = 3;                           ///< working width and spacing w, > 0
  Angle sharpest_corner = Angle::degrees(120);  ///< corners that turn more end both branches

  double least_radius_m() const { return radius_m > 0.5 * width_m ? radius_m : 0.5 * width_m; }
};

/// A track is a path in the sense of the reference; a closed one ends where it begins.
struct ParallelTrack {
  Path path;
  bool closed = false;

  friend bool operator==(const ParallelTrack& a, const ParallelTrack& b) = default;
};

/// The tracks at a signed distance from the reference, positive to its right (Zhou §2.2), negative to its
/// left, ordered by the position along the reference where they begin. There are several where the reference
/// bends round so far that fronts meet. The land that the tracks at |offset| − w, |offset| − 2w … work at
/// their corners is left to them, as far as they can be in the way. The plane beyond the normals at the ends
/// gets no tracks: extend the reference first (extended_line.h). Preconditions: |offset| ≥ w/2; the
/// reference's tangents are continuous, it is no tighter than ρ and does not cross itself; its ends may touch
/// it. About O(n log n) for n segments; see offset_front().
std::vector<ParallelTrack> parallel(const Path& reference, double offset_m, const TrackLimits& limits);

/// Track `index` of a family, at the distance (index + ½)·w.
struct FamilyTrack {
  int index = 0;
  ParallelTrack track;
};

/// The tracks first … last of the family, by index, equal to those of parallel(); what they have in common is
/// computed once.
std::vector<FamilyTrack> parallel_family(const Path& reference, int first, int last,
                                         const TrackLimits& limits);

/// The same track by track, outwards from the reference: −1, −2 … first, then 0, 1 … last. `visit` gets the
/// index and its tracks, none or several; no more are made once it returns false.
void visit_family(const Path& reference, int first, int last, const TrackLimits& limits,
                  const std::function<bool(int index, std::vector<ParallelTrack> tracks)>& visit);

/// Length of the reference's segments moved by the signed distance to its right, none of them cut where it
/// meets others, m: tracks there are no longer except for what discs rolled round corners add. O(n).
double uncut_length(const Path& reference, double offset_m);

}  // namespace tramline
