#pragma once
// The quickest way with room from one place to another, along the lines of a roadmap and between them.

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "tramline/route/connection/driving_ground.h"
#include "tramline/route/connection/roadmap_ways.h"

namespace tramline {

inline constexpr double kAnyCost_s = std::numeric_limits<double>::infinity();

/// One of several ways to begin or to end: the pose that is driven from or to, and what lies before or behind
/// it.
struct WayEnd {
  Pose pose;
  SteeredPath path{};  ///< to the pose from where the way begins, or from the pose to where it ends
  double cost_s = 0;   ///< of `path`, changes of gear included
};

struct FoundWay {
  std::size_t begin = 0;  ///< index of the beginning chosen
  std::size_t end = 0;
  SteeredPath path{};  ///< all of it, from the first pose of the beginning to the last of the end
  double cost_s = 0;
};

/// Finds the way of least cost from any of the beginnings to any of the ends: shortest Dubins words between
/// them and poses of the roadmap, and along its lines. Only what has room is used. Words are tried for room
/// when the search comes to them (A* with costs that are lower bounds until then). From a beginning with a
/// path longer than RoadmapWays::longest_word_m() no word is longer than that. nullopt where none is found
/// within a fixed effort, or none costs less than `no_more_than_s`. Forward, but for the paths of the ends.
/// Deterministic.
std::optional<FoundWay> quickest_way(const std::vector<WayEnd>& begins, const std::vector<WayEnd>& ends,
                                     RoadmapWays& on_roadmap, const DrivingGround& ground,
                                     double no_more_than_s = kAnyCost_s);

}  // namespace tramline
