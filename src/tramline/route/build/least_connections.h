#pragma once
// The least times between the ends of lines, the gates and the closed passes of a route.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/route/backing/least_backing.h"
#include "tramline/route/build/ring_places.h"
#include "tramline/route/build/route_lines.h"
#include "tramline/route/certificate/connection_bounds.h"
#include "tramline/route/connection/least_seconds.h"

namespace tramline {

/// Where a route has to start or to end.
struct RouteGate {
  Point at;
  std::size_t phase = 0;  ///< the first or the last
};

/// What a bound of a route joins, in the numbering of RouteProof. A route works tracks and passes in phases:
/// all tracks of a part of the land and then all passes there, or the other way round, and then those of the
/// next. Passes round obstacles that are worked between tracks are in the phase of these.
struct RouteMembers {
  std::vector<RouteLine> lines;          ///< tracks, then open passes
  std::vector<std::size_t> line_phases;  ///< of each line
  std::vector<RouteGate> gates;
  std::vector<RingPlaces> rings;         ///< closed passes
  std::vector<std::size_t> ring_phases;  ///< of each ring
};

/// Lower bounds of connections. A route makes just one connection from each phase to the next. These cost
/// between_phases_s() more here together, and a bound has to be made less by as much: so the least tree has
/// no more of them, either. Rings more than 1.5 widths apart are as far apart as they lie. Not for several
/// threads.
class LeastConnections final : public order::ConnectionBounds {
 public:
  /// `least` outlives the connections. `backing`: for land whose sides bound ways, by a machine of which it
  /// holds; else nullopt.
  LeastConnections(RouteMembers members, double width_m, const LeastSeconds& least,
                   std::optional<LeastBacking> backing);

  std::size_t lines() const override { return members_.lines.size(); }
  std::size_t gates() const override { return members_.gates.size(); }
  std::size_t rings() const override { return members_.rings.size(); }
  double between(std::size_t a, std::size_t b) const override;
  double least(std::size_t a, std::size_t b) const override;

  /// 0 where there is one phase.
  double between_phases_s() const { return between_phases_s_; }

 private:
  std::size_t phase(std::size_t node) const;
  double change_s(std::size_t a, std::size_t b) const;
  double one_way(std::size_t left, std::size_t entered) const;
  const RouteGate& gate(std::size_t node) const { return members_.gates[node - 2 * lines()]; }
  std::size_t ring(std::size_t node) const { return node - 2 * lines() - gates(); }
  double to_gate(std::size_t end, std::size_t gate) const;
  double distance_to_ring(std::size_t node, std::size_t ring) const;
  double to_ring(std::size_t node, std::size_t ring) const;
  double known_to_ring(std::size_t node, std::size_t ring) const;

  RouteMembers members_;
  const LeastSeconds& least_;
  std::optional<LeastBacking> backing_;
  double next_rings_m_;
  double between_phases_s_ = 0;
  std::vector<Pose> left_;       ///< by end
  std::vector<Pose> entered_;    ///< by end
  bool same_both_ways_ = false;  ///< what is driven from the end of a way takes as long
  // The same as LeastBacking knows them, by end, where there is one.
  std::vector<LineExits> exits_left_;
  std::vector<LineExits> exits_entered_;
  // By ring and node: from it, m, and the least time, s, once it was asked for.
  std::vector<std::vector<double>> apart_m_;
  mutable std::vector<std::vector<double>> known_s_;
};

}  // namespace tramline
