#pragma once
// Drives a route work by work.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/route/build/leg_list.h"
#include "tramline/route/build/planned_route.h"
#include "tramline/route/build/route_lines.h"
#include "tramline/route/connection/connector.h"
#include "tramline/route/connection/squeezed_way.h"
#include "tramline/route/passes/pass_entries.h"
#include "tramline/route/passes/worked_pass.h"

namespace tramline {

/// Headland passes that are ordered together.
struct PassGroup {
  std::vector<std::size_t> passes{};  ///< indices into Headland::passes
  bool as_lines = false;              ///< they have two ends, like tracks
  std::optional<Point> ahead{};       ///< where the route goes once they are worked, if no other work follows
};

/// A route up to where it has been planned.
struct RouteSoFar {
  LegList legs;
  SteeredPath left{};      ///< what was driven forward to the end of the work so far; empty at the beginning
  std::size_t pieces = 0;  ///< driven so far
  order::Tour tour{};      ///< of the lines driven so far
  bool leaves_part = false;  ///< the way to the next work leads from one part of the land to another
  std::size_t lacking = 0;   ///< ways without room
  double cost_s = 0;         ///< of all ways
};

/// Ways without room, and what all cost, with that to where the route goes next at least: of two routes over
/// the same works the one of less effort is better. O(1).
std::pair<std::size_t, double> effort(const RouteSoFar& route, std::optional<Point> ahead,
                                      const LeastSeconds& least);

/// What a route is made of and found with. All references outlive it.
struct RouteContext {
  const std::vector<order::WorkedLine>& lines;
  const std::vector<RouteLine>& route_lines;  ///< of the lines
  const EntriesByPass& entries;
  const Connector& connector;
  SqueezedWays& squeezed;
  const LeastSeconds& least;
};

/// Goes from work to work, and keeps what was driven. Not for several threads.
class RouteDriver {
 public:
  /// `start`: the gate.
  RouteDriver(const RouteTask& task, const RouteContext& context, std::optional<Point> start);

  const RouteSoFar& so_far() const { return so_far_; }
  /// Takes back what was driven since, or puts it in place of what was driven otherwise.
  void go_back_to(RouteSoFar before) { so_far_ = std::move(before); }
  void leave_part() { so_far_.leaves_part = true; }

  /// The way from where the route is, or from its gate, to the beginning of a work; empty where it begins
  /// there.
  Way way_to(const SteeredPath& work) const;

  /// A way that was found to a work, as it is driven from where the route is: backing no farther than it has
  /// to, and along the land where there is no room.
  Way as_driven(Way way, const SteeredPath& work);

  /// Goes a way as it is, and over a line that is entered by this end.
  void drive_line(const Way& way, order::End entered);
  /// Goes a way as_driven(), and over a pass. False where that is another way than the one given.
  bool drive_pass(Way way, std::size_t pass, const PassEntry& entry);
  /// Drives passes in the order that takes least (pass_tour()).
  void drive_passes(const PassGroup& group);
  /// To the gate at the end, once there is work behind.
  void drive_to(Point gate);

  PassTask pass_task(const PassGroup& group) const;
  const DrivenSense& sense_of(order::End entered) const {
    return context_.route_lines[order::line_of(entered)].entered_by(entered);
  }
  const RouteContext& context() const { return context_; }
  const RouteTask& task() const { return task_; }

 private:
  void add(const Way& way);
  void follow(const Way& way, const SteeredPath& work);

  const RouteTask& task_;
  RouteContext context_;
  std::optional<Point> start_;
  RouteSoFar so_far_;
};

}  // namespace tramline
