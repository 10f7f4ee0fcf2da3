#pragma once
// The ground as detours meet it, in the turned plane of one grid.

#include <optional>
#include <string>
#include <vector>

#include "tramline/avoidance/ground.h"
#include "tramline/geometry/path.h"
#include "tramline/geometry/track_frame.h"

namespace tramline {

struct TurnedHazard {
  Ring outline;
  Box box;
  std::optional<Circle> round;
};

struct Surroundings {
  std::vector<TurnedHazard> hazards;  ///< as Ground::hazards
  std::vector<Ring> passable;         ///< all rings
  Ring field;                         ///< the outer ring
  bool hard_boundary = false;
};

Surroundings turned_surroundings(const Ground& ground, const Ring& field, bool hard_boundary,
                                 const TrackFrame& frame);

/// What is wrong with a path as the centre line of a swath of the given width, in a few words; empty
/// where nothing is: it must not leave the field, nor its swath a hard boundary, nor may the swath enter
/// passable obstacles. Hazards are not looked at. O(edges) boxes.
std::string fault_of(const Path& path, double width_m, const Surroundings& around);

/// Does the swath along the path enter the hazard? Never for one that its outline only touches.
bool runs_into(const Path& path, double width_m, const TurnedHazard& hazard);

}  // namespace tramline
