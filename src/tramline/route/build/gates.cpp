#include "tramline/route/build/gates.h"

#include <cmath>
#include <numbers>

namespace tramline {
namespace {

/// Places are tried on circles so far apart, and so many on each.
constexpr double kCircles_m = 1;
constexpr int kPlaces = 32;
constexpr int kHeadings = 8;
/// A machine that has room at a gate can drive on a little from there.
constexpr double kDrivesOn_m = 1;

bool has_room_at(Point at, const DrivingGround& ground) {
  for (int i = 0; i < kHeadings; ++i) {
    const Heading heading = Heading::clockwise_from_north(Angle::degrees(360.0 * i / kHeadings));
    if (ground.has_room({arc_from({at, heading}, kDrivesOn_m, 0, Gear::kForward)})) return true;
  }
  return false;
}

}  // namespace

std::optional<Point> with_room(const std::optional<Point>& gate, const DrivingGround& ground) {
  if (!gate || has_room_at(*gate, ground)) return gate;
  for (double away_m = kCircles_m; away_m <= kMostBesideGate_m; away_m += kCircles_m)
    for (int i = 0; i < kPlaces; ++i) {
      const double angle = 2 * std::numbers::pi * i / kPlaces;
      const Point at = *gate + away_m * Point{std::cos(angle), std::sin(angle)};
      if (has_room_at(at, ground)) return at;
    }
  return gate;
}

}  // namespace tramline
