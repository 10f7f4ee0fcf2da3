#pragma once
// Where detours may run, and how long they may be, whatever their tracks.

#include <cmath>
#include <vector>

#include "tramline/avoidance/obstacles/hazards.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// The terms of detours.
struct Detouring {
  double width_m = 1;
  double arc_m = 0;      ///< radius of the arcs that leave a track and return to it
  bool drivable = true;  ///< whether nothing of a detour is tighter
};

/// Obstacles of which one detour may go round several.
struct DetourGroup {
  Box box;
  std::vector<Point> corners{};
  int most_detours = 0;  ///< of one piece

  double diameter_m() const { return std::hypot(box.width(), box.height()); }
};

/// A detour that would run into a further obstacle goes round that one too, and two that would meet are one:
/// obstacles nearer to one another than detours reach are one group, and so are those between which the
/// ground ends.
std::vector<DetourGroup> detour_groups(const std::vector<Hazard>& hazards, const Region& ground,
                                       const Detouring& terms);

/// Where detours round a group may run, in the plane of tracks that run up.
struct GroupZone {
  Box box;              ///< of the obstacles: only tracks that meet it have detours
  Box land;             ///< that their detours work
  double longer_m = 0;  ///< by how much all detours of one piece are longer than their rows, at most
};

/// `turned`: the box of the group's corners in that plane. For all directions and offsets in which nothing
/// strays by more than stray_m.
GroupZone detour_zone(const DetourGroup& group, const Box& turned, const Detouring& terms, double stray_m);

/// Where a track leaves its subfield between two groups, one detour may go round both.
void reach_for_others(std::vector<GroupZone>& zones);

}  // namespace tramline
