#pragma once
// The lines of a route: what is worked in one go, with the ways of the axle along it in both senses.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/headland.h"
#include "tramline/model/machine.h"
#include "tramline/route/order/lines.h"

namespace tramline {

/// The ways of the axle over a line in one sense: its first work and its last, the same where there is one.
struct DrivenSense {
  SteeredPath first;
  SteeredPath last;
};

/// A line that has two ends: the pieces of a track that crossings join, or an open headland pass.
struct RouteLine {
  std::optional<std::size_t> pass{};    ///< index into Headland::passes; nullopt: a line of tracks
  std::array<DrivenSense, 2> senses{};  ///< [0] from its start, [1] from its end

  /// The sense in which it is driven where it is entered by this end.
  const DrivenSense& entered_by(order::End end) const { return senses[order::is_start(end) ? 0 : 1]; }
  /// The sense in which it is driven where it is left by this end.
  const DrivenSense& left_by(order::End end) const { return senses[order::is_start(end) ? 1 : 0]; }
};

RouteLine route_line(const order::WorkedLine& line, const Turning& turning);
/// Precondition: the pass is open.
RouteLine route_line(const HeadlandPass& pass, std::size_t number, const Turning& turning);

/// The poses between which ways lead: where the axle is when the work ends at an end, and when it begins
/// there.
Pose pose_left_by(const RouteLine& line, order::End end);
Pose pose_entered_by(const RouteLine& line, order::End end);

}  // namespace tramline
