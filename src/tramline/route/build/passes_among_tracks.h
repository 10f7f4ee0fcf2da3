#pragma once
// Tracks in their order, and passes round obstacles among them.

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "tramline/route/build/route_driver.h"

namespace tramline {

/// Tracks in the order in which they are driven, and the way to each.
struct OrderedTracks {
  order::Tour tour{};            ///< over all lines
  std::vector<Way> found{};      ///< the ways
  std::vector<Way> as_driven{};  ///< the same once they have been driven
};

/// Passes that are worked between a track and the next one.
struct PassesAmongTracks {
  std::size_t behind = 0;  ///< place of the track in the order
  std::vector<std::size_t> passes{};
};

/// Drives the tracks, and passes among them. Ways that were driven before are not looked for again where
/// they lead from the same place.
void drive_tracks(RouteDriver& driver, OrderedTracks& tracks, const std::vector<PassesAmongTracks>& among);

/// Drives a part of the land from where the route was before it, with these passes among the tracks and all
/// others behind them.
using DrivePart = std::function<void(const std::vector<PassesAmongTracks>&)>;

/// Drives the part with those of its closed passes among the tracks that go round obstacles and with which
/// the route lacks room less often or costs less there: one obstacle after the other is tried. `tour`: the
/// tracks in their order. `ahead`: where the route goes behind the part. Drives as many routes as there are
/// obstacles, and one.
void drive_with_passes_among_tracks(RouteDriver& driver, const order::Tour& tour,
                                    const std::vector<std::size_t>& closed, std::optional<Point> ahead,
                                    const DrivePart& drive_part);

}  // namespace tramline
