#pragma once
// Headland passes round obstacles that may be worked among the tracks.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/point.h"
#include "tramline/model/headland.h"
#include "tramline/model/track.h"

namespace tramline {

/// The closed passes of these that go round obstacles alone, those along one boundary together: no other pass
/// follows their boundary. Indices into Headland::passes.
std::vector<std::vector<std::size_t>> passes_round_obstacles(const Headland& headland,
                                                             const std::vector<std::size_t>& passes);

/// A track in driving order: its pieces, and where the axle is when the work on it begins and ends.
struct DrivenTrack {
  const std::vector<TrackPiece>* pieces = nullptr;
  Pose entered;
  Pose left;
};

/// Behind which track these passes are worked with the shortest way aside, of the last of those that end
/// beside one of them, on whose land they turn, and all that follow but the last of all. `places`: on the
/// passes. nullopt: there is no such track. O(t·p) for t tracks and p places.
std::optional<std::size_t> track_before(const std::vector<DrivenTrack>& tracks,
                                        const std::vector<Point>& places, double width_m);

}  // namespace tramline
