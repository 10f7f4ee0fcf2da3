#pragma once
// The obstacles and boundaries that detours have to respect, in the plane of one family of tracks.

#include <optional>
#include <vector>

#include "tramline/avoidance/obstacles/obstacle_classification.h"
#include "tramline/avoidance/refusal.h"
#include "tramline/geometry/path/path.h"
#include "tramline/geometry/strip/track_frame.h"
#include "tramline/model/plan.h"

namespace tramline {

struct TurnedHazard {
  Ring outline;
  Box box;
  std::optional<Circle> round;
};

struct Surroundings {
  std::vector<TurnedHazard> hazards;  ///< as ClassifiedGround::hazards
  std::vector<Ring> passable;         ///< all rings
  Ring field;                         ///< the outer ring
  EdgeKind boundary = EdgeKind::kSoft;
};

Surroundings turned_surroundings(const ClassifiedGround& ground, const Ring& field, EdgeKind boundary,
                                 const TrackFrame& frame);

/// A path as the centre line of a swath. Refers to the path.
struct SwathLine {
  SwathLine(const Path& of, double width)
      : path(of), width_m(width), reach(reach_of(of, width)), reaches(reaches_of(of, width)) {}
  const Path& path;
  double width_m;
  Box reach;                 ///< contains the swath
  std::vector<Box> reaches;  ///< contain the swaths of the segments
};

/// The fault of a swath: its centre line must not leave the field, nor the swath a hard boundary, nor may it
/// enter passable obstacles. Hazards are not tested. O(edges) boxes.
Refusal fault_of(const SwathLine& line, const Surroundings& around);

/// Whether the swath enters the hazard; touching it with an edge does not count.
bool runs_into(const SwathLine& line, const TurnedHazard& hazard);

}  // namespace tramline
