#pragma once
// Random tracks, and all it takes to find ways between them.

#include <random>
#include <vector>

#include "properties/draws.h"
#include "tramline/route/build/lines_beside_boundaries.h"
#include "tramline/route/build/route_lines.h"
#include "tramline/route/connection/connector.h"
#include "tramline/route/connection/least_seconds.h"
#include "tramline/route/order/lines.h"

namespace tramline::testing {

/// Tracks from south to north over a field whose edges slope, with as much land beyond their ends.
struct Tracks {
  Field field;
  Region body;
  std::vector<order::WorkedLine> lines;
};

inline Tracks random_tracks(std::mt19937_64& random, double width_m) {
  const int count = any_of(random, 4, 12);
  const double depth_m = uniform(random, 6, 18), low = uniform(random, -0.3, 0.3),
               high = uniform(random, -0.3, 0.3);
  const double east = width_m * count;
  const auto corner = [&](double x, double slope, double y) { return Point{x, y + slope * x}; };
  Tracks out;
  out.field.outer = {corner(-depth_m, low, -depth_m), corner(east + depth_m, low, -depth_m),
                     corner(east + depth_m, high, 120 + depth_m), corner(-depth_m, high, 120 + depth_m)};
  out.body = {{{corner(0, low, 0), corner(east, low, 0), corner(east, high, 120), corner(0, high, 120)}, {}}};
  for (int i = 0; i < count; ++i) {
    const double x = width_m * (i + 0.5);
    TrackPiece piece{corner(x, low, 0), corner(x, high, 120)};
    piece.track = i;
    out.lines.push_back({piece});
  }
  return out;
}

/// Random tracks and all it takes to find ways between them. Its members refer to one another.
struct TracksToJoin {
  /// There may be walls round the first track, which nothing gets over.
  explicit TracksToJoin(std::mt19937_64& random, bool first_is_walled = false)
      : machine(machine_without_overhang(random)),
        tracks(random_tracks(random, machine.width_m)),
        land({{tracks.field.outer, first_is_walled ? walls() : std::vector<Ring>{}}}),
        ground(land, tracks.field, machine, tracks.body),
        roadmap(new_roadmap()),
        connector(ground, roadmap, {}),
        least(machine) {
    for (const order::WorkedLine& line : tracks.lines) lines.push_back(route_line(line, machine.turning));
  }
  TracksToJoin(const TracksToJoin&) = delete;
  TracksToJoin& operator=(const TracksToJoin&) = delete;

  /// On both sides of the first track and across its ends, a metre thick.
  std::vector<Ring> walls() const {
    const TrackPiece& first = tracks.lines.front().front();
    const double x = first.start.x, beside_m = 0.7 * machine.width_m;
    const double south = first.start.y - 2, north = first.end.y + 2;
    const auto box = [](double from_x, double from_y, double to_x, double to_y) {
      return Ring{{from_x, from_y}, {from_x, to_y}, {to_x, to_y}, {to_x, from_y}};
    };
    return {box(x - beside_m - 1, south, x - beside_m, north),
            box(x + beside_m, south, x + beside_m + 1, north),
            box(x - beside_m - 1, south - 1.5, x + beside_m + 1, south - 0.5),
            box(x - beside_m - 1, north + 0.5, x + beside_m + 1, north + 1.5)};
  }

  RoadmapOnDemand new_roadmap() const {
    return {[this] {
              return Roadmap(lines_beside_boundaries({}, tracks.field, ground), 0.75 * machine.radius_m);
            },
            ground};
  }

  static Machine machine_without_overhang(std::mt19937_64& random) {
    Machine out;
    out.width_m = uniform(random, 3, 7);
    out.radius_m = uniform(random, 3, 7);
    return out;
  }

  Machine machine;
  Tracks tracks;
  AllowedLand land;
  DrivingGround ground;
  RoadmapOnDemand roadmap;
  Connector connector;
  std::vector<RouteLine> lines;
  LeastSeconds least;
};

}  // namespace tramline::testing
