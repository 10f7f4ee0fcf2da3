#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/check/turning/turning_ground.h"

namespace tramline::check {
namespace {

/// Whether there is an obstacle without headland or land given up in the first millimetre ahead; for lines of
/// others, which are less exact, in the first centimetre.
bool blocked(const Case& c, Point end, Point heading) {
  const PieceFrame frame(end, end + heading);
  const double half = 0.5 * c.plan.machine.width_m;
  const bool of_lines = is_of_lines(c.plan);
  const Box beyond{-half, 0, half, of_lines ? kAheadOfLine_m : kLengthTolerance_m};
  return clipped(c.blocking, frame, beyond).area_m2 + clipped(c.given_up, frame, beyond).area_m2 >
         (of_lines ? kAheadOfLine_m2 : kTouch_m2);
}

/// The directions out of a piece, at its start and at its end.
Point heading_at_start(const TrackPiece& piece) {
  return piece.curve.empty() ? piece.start - piece.end : -1.0 * direction_at_start(piece.curve.front());
}
Point heading_at_end(const TrackPiece& piece) {
  return piece.curve.empty() ? piece.end - piece.start : direction_at_end(piece.curve.back());
}

void compare(bool flagged, bool found, const std::string& end_name, Point at, Violations& out) {
  if (flagged == found) return;
  out.push_back(
      {Rule::kStops,
       found ? fmt::format("the {} is not flagged as a stop, but lies against an obstacle or land given up",
                           end_name)
             : fmt::format("the {} is flagged as a stop, but nothing lies behind it", end_name),
       at, 1});
}

}  // namespace

namespace {

int stops_at_obstacles(const Case& c, Violations& out) {
  int stops = 0;
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    const bool at_start = blocked(c, piece.start, heading_at_start(piece));
    const bool at_end = blocked(c, piece.end, heading_at_end(piece));
    stops += (at_start ? 1 : 0) + (at_end ? 1 : 0);
    compare(piece.stop_at_start, at_start, "start of " + piece_name(i), piece.start, out);
    compare(piece.stop_at_end, at_end, "end of " + piece_name(i), piece.end, out);
  }
  return stops;
}

/// A quarter turn: straight on until the implement is lifted, then as tight as the machine steers.
SteeredPath quarter_turn(Point end, Point ahead, const Machine& machine, double sense) {
  const Turning& turning = machine.turning;
  const double back_m =
      turning.implement_offset_m + (turning.implement == Coupling::kTowed ? turning.drawbar_m : 0);
  const double quarter = std::numbers::pi / 2;
  double tightest = 1 / std::max(machine.radius_m, kLeastRadius_m);
  double steering_m = turning.turning_speed_mps * turning.steering_time_s;
  // where the steering alone turns farther, it is turned back before it has reached its limit
  const double share = std::min(1.0, std::sqrt(quarter / std::max(steering_m * tightest, kShortest_m)));
  tightest *= share;
  steering_m *= share;
  SteeredPath out;
  Pose at{end + back_m / length(ahead) * ahead, Heading::from_to({0, 0}, ahead)};
  const auto drive = [&](double length_m, double from, double to) {
    if (!(length_m > 0)) return;
    out.push_back({at, length_m, sense * from, sense * to});
    const MachinePlace place = places_along({out.back()}, machine, 0.01).back();
    at = {place.axle, Heading::from_to({0, 0}, place.ahead)};
  };
  drive(turning.lift_m, 0, 0);
  drive(steering_m, 0, tightest);
  drive(quarter / tightest - steering_m, tightest, tightest);
  drive(steering_m, tightest, 0);
  return out;
}

/// The distance between the places of the machine that are looked at, m.
constexpr double kPoses_m = 0.05;

/// A machine that takes up more room on every side.
Machine widened(Machine machine, double by_m) {
  machine.width_m += 2 * by_m;
  machine.turning.rear_overhang_m += by_m;
  if (machine.turning.vehicle_width_m > 0) {
    machine.turning.vehicle_width_m += 2 * by_m;
    machine.turning.front_overhang_m += by_m;
  }
  return machine;
}

/// By how much the better quarter turn of the plan's machine leaves the land, m, if it is as wide as
/// `outline`.
double missing_m(const Case& c, const TurningGround& ground, const Machine& outline, Point end, Point ahead) {
  double least = std::numeric_limits<double>::infinity();
  for (const double sense : {+1.0, -1.0}) {
    const SteeredPath path = quarter_turn(end, ahead, c.plan.machine, sense);
    least = std::min(least, ground.deepest(path, outline, kPoses_m).depth_m);
    if (least == 0) break;
  }
  return least;
}

/// A stop must be one for a machine that is wider by the distance between places: between two of them the
/// outline may meet a corner. Where none is flagged, a few millimetres decide nothing.
void compare_room(const Case& c, const TurningGround& ground, bool flagged, Point at, Point ahead,
                  const std::string& end_name, Violations& out) {
  constexpr double kOutside_m = 0.005;
  const Machine outline = flagged ? widened(c.plan.machine, kPoses_m) : c.plan.machine;
  const double missing = missing_m(c, ground, outline, at, ahead);
  if (flagged && missing == 0)
    out.push_back({Rule::kStops,
                   fmt::format("the {} is flagged as a stop, but the machine can turn there", end_name), at,
                   1});
  if (!flagged && missing > kOutside_m)
    out.push_back({Rule::kStops,
                   fmt::format("the {} is not flagged as a stop, but a turn leaves the land by {:.2f} m",
                               end_name, missing),
                   at, missing});
}

int stops_without_way_off(const Case& c, Violations& out) {
  const TurningGround ground(c.plan);
  const std::vector<TrackPiece>& pieces = c.plan.pieces;
  int stops = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const TrackPiece& piece = pieces[i];
    const bool crosses_next = i + 1 < pieces.size() && pieces[i + 1].after_crossing;
    stops += (piece.stop_at_start ? 1 : 0) + (piece.stop_at_end ? 1 : 0);
    if (piece.after_crossing)
      compare(piece.stop_at_start, false, "start of " + piece_name(i), piece.start, out);
    else
      compare_room(c, ground, piece.stop_at_start, piece.start, heading_at_start(piece),
                   "start of " + piece_name(i), out);
    if (crosses_next)
      compare(piece.stop_at_end, false, "end of " + piece_name(i), piece.end, out);
    else
      compare_room(c, ground, piece.stop_at_end, piece.end, heading_at_end(piece), "end of " + piece_name(i),
                   out);
  }
  return stops;
}

}  // namespace

int check_stops(const Case& c, Violations& out) {
  return c.plan.stop_rule == StopRule::kTouching ? stops_at_obstacles(c, out) : stops_without_way_off(c, out);
}

}  // namespace tramline::check
