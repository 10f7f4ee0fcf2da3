#pragma once
// The land of a strip that its own detour leaves.

#include "tramline/geometry/interval.h"

namespace tramline {

/// A place that a detour passes, and the detour.
struct PassedPlace {
  double along = 0;    ///< its coordinate along the track, m
  double aside_m = 0;  ///< least displacement of the track there, > 0, where it is the largest of all
  double arc_m = 0;    ///< radius of the tightest arcs of the path, at least half a width
  double width_m = 0;  ///< of the swath
  double slack_m = 0;  ///< by how much the place may lie elsewhere along the track
};

/// Least area, m², of the strip's land in these rows (all of it land, from side to side) that the swath does
/// not work. The path is displaced at least as far as one of two arcs: bent towards the track from the place
/// on, and then back into it. O(rows).
double vacated_m2(const PassedPlace& place, const Intervals& rows);

}  // namespace tramline
