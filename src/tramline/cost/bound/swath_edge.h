#pragma once
// The inner edge of the swath of a detour about the place where it is displaced farthest.

namespace tramline {

/// A place that a detour passes, and the detour.
struct PassedPlace {
  double along = 0;    ///< its coordinate along the track, m
  double aside_m = 0;  ///< least displacement of the track there, > 0, where it is the largest of all
  double arc_m = 0;    ///< radius of the tightest arcs of the path, at least half a width
  double width_m = 0;  ///< of the swath
  double slack_m = 0;  ///< by how much the place may lie elsewhere along the track
};

/// How far beside the track's line the inner edge of the swath lies at least, `away_m` ≥ 0 along the track
/// from the place; half a width to the other side where it may be back on the track. The path is displaced at
/// least as far as one of two arcs: bent towards the track from the place on, and then back into it.
double inner_edge_m(const PassedPlace& place, double away_m);

}  // namespace tramline
