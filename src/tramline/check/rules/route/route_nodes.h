#pragma once
// What a route joins, and the least times of ways between: facts of the rule about its bound.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/check/rules/route/land_sides.h"
#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/plan.h"

namespace tramline::check {

enum class NodeKind { kLineEnd, kGate, kClosedPass };

/// An end of a track or of an open pass, a gate, or a closed pass, which may be left and entered at any of
/// its places.
struct RouteNode {
  NodeKind kind = NodeKind::kLineEnd;
  std::size_t phase = 0;      ///< of the route, in which it is worked; of a gate the first or the last
  std::vector<Pose> left;     ///< the axle, where the work ends there
  std::vector<Pose> entered;  ///< where the work begins there
  /// Of a line's end, where the sides of the land bound ways.
  std::optional<LineEnd> leaving{}, entering{};
  double step_m = 0;             ///< from each place of a closed pass to the next; 0: there is one place
  std::vector<LineStep> line{};  ///< of the closed pass, either way round, where the sides bound ways
};

/// A track, an open pass, a gate, or a closed pass.
struct RouteMember {
  std::size_t first = 0;  ///< of its nodes
  std::size_t count = 1;
};

struct RouteNodes {
  std::optional<LandSides> sides{};
  std::vector<RouteNode> nodes;  ///< in the numbering of RouteProof
  std::vector<RouteMember> members;
  double crossings_m = 0;  ///< straight on over passable obstacles within lines
};

/// Precondition: the route has legs with paths.
RouteNodes nodes_of_route(const Plan& plan);

/// The least times of ways between nodes, by the machine of a plan.
class LeastWays {
 public:
  /// `stop_s`: what a stop to back counts besides its time.
  LeastWays(const Machine& machine, double stop_s, std::optional<LandSides> sides);

  /// No way is quicker, in either direction, s; where that is `enough_s` or more, to that. Where one of them
  /// is a closed pass, ways from and to its places less the steps between these, along which the machine
  /// could drive; of closed passes 1.5 widths apart or more the straight way alone.
  double between(const RouteNode& a, const RouteNode& b, double enough_s) const;
  /// The straight way: at most as much.
  double straight_s(const RouteNode& a, const RouteNode& b) const;

 private:
  double least_s(const Pose& left, double lift_m, const Pose& entered, double lower_m, double known_s) const;
  double one_way_s(const RouteNode& from, const RouteNode& to, double enough_s) const;
  double steps_s(const RouteNode& a, const RouteNode& b) const;
  double with_stop_s(const RouteNode& from, const RouteNode& to) const;
  double least_of_places_s(const RouteNode& from, double lift_m, const RouteNode& to, double lower_m) const;

  Turning turning_;
  double width_m_;
  double radius_m_;
  bool reverses_;
  double fastest_mps_;
  double reversing_s_;  ///< changes of gear, and a stop where the machine does not turn in reverse
  std::optional<LandSides> sides_;
};

}  // namespace tramline::check
