#include "tramline/check/turning/driven_machine.h"

#include <algorithm>
#include <cmath>

namespace tramline::check {
namespace {

/// A towed implement is drawn in steps in which its hitch moves no farther than this, m.
constexpr double kDrawn_m = 0.005;
/// The machine turns by no more than this in one step, rad: by Simpson's rule its place is then off by
/// 1e-8 of the step at the most.
constexpr double kTurned_rad = 0.1;

/// A drawbar that deviates no more from the machine's heading is in line with it, rad.
constexpr double kInLine = 1e-6;

struct Motion {
  Point at;
  double heading = 0;  ///< anticlockwise from east, rad
};

double anticlockwise_from_east(Heading heading) { return std::atan2(heading.unit().y, heading.unit().x); }

/// One step on a stretch from `done_m`: the heading is exact, because the curvature is linear; the place
/// follows from Simpson's rule, to which that of Runge and Kutta comes down.
Motion stepped(const Motion& from, const SteeredStretch& stretch, double done_m, double step_m) {
  const double sense = stretch.gear == Gear::kForward ? 1 : -1;
  const double growth = (stretch.curvature_at_end - stretch.curvature_at_start) / stretch.length_m;
  const double curvature = stretch.curvature_at_start + growth * done_m;
  const auto heading_after = [&](double way) {
    return from.heading + sense * way * (curvature + 0.5 * growth * way);
  };
  const auto unit = [](double angle) { return Point{std::cos(angle), std::sin(angle)}; };
  if (curvature == 0 && growth == 0) return {from.at + sense * step_m * unit(from.heading), from.heading};
  const double last = heading_after(step_m);
  const Point mean = (1.0 / 6) * (unit(from.heading) + 4 * unit(heading_after(0.5 * step_m)) + unit(last));
  return {from.at + sense * step_m * mean, last};
}

/// The direction of a drawbar after its hitch has moved along a straight line: on a tractrix the tangent of
/// half the angle to that line falls by e for every length of the drawbar. So it is exact where the hitch
/// moves straight, and off by the square of the steps elsewhere, also where it pushes the bar and turns it
/// round.
Point drawn(Point ahead, Point way, double drawbar_m) {
  const double way_m = length(way);
  if (way_m == 0) return ahead;
  const Point along = 1 / way_m * way;
  const double cosine = dot(along, ahead), sine = cross(along, ahead), shrunk = std::exp(-way_m / drawbar_m);
  const double near = 1 + cosine, far = shrunk * shrunk * (1 - cosine);
  const Point out = (near - far) * along + 2 * shrunk * sine * left_of(along);
  return 1 / length(out) * out;
}

class Drawn {
 public:
  Drawn(const Machine& machine, const Motion& start) : turning_(machine.turning) {
    place_.ahead = {std::cos(start.heading), std::sin(start.heading)};
    place_.implement_ahead = place_.ahead;
    place_.implement = hitch(start) - turning_.drawbar_m * place_.ahead;
    move(start);
  }

  const MachinePlace& place() const { return place_; }
  bool in_line() const { return std::abs(cross(place_.ahead, place_.implement_ahead)) < kInLine; }

  void move(const Motion& to) {
    place_.axle = to.at;
    place_.ahead = {std::cos(to.heading), std::sin(to.heading)};
    if (tows(turning_)) {
      const Point hitch_before = place_.implement + turning_.drawbar_m * place_.implement_ahead;
      place_.implement_ahead = drawn(place_.implement_ahead, hitch(to) - hitch_before, turning_.drawbar_m);
      place_.implement = hitch(to) - turning_.drawbar_m * place_.implement_ahead;
    } else {
      place_.implement = hitch(to);
      place_.implement_ahead = place_.ahead;
    }
  }

 private:
  Point hitch(const Motion& at) const {
    return at.at - turning_.implement_offset_m * Point{std::cos(at.heading), std::sin(at.heading)};
  }

  const Turning& turning_;
  MachinePlace place_;
};

/// The four sides of a rectangle, or its one side where it has no depth.
void add_rectangle(Point middle, Point ahead, double forward_m, double back_m, double width_m,
                   std::vector<Side>& out) {
  if (width_m <= 0) {
    if (forward_m + back_m > 0) out.push_back({middle + forward_m * ahead, middle - back_m * ahead});
    return;
  }
  const Point across = 0.5 * width_m * left_of(ahead);
  const Point front = middle + forward_m * ahead, rear = middle - back_m * ahead;
  out.push_back({front + across, front - across});
  if (forward_m + back_m <= 0) return;
  out.push_back({rear + across, rear - across});
  out.push_back({front + across, rear + across});
  out.push_back({front - across, rear - across});
}

}  // namespace

bool tows(const Turning& turning) { return turning.implement == Coupling::kTowed && turning.drawbar_m > 0; }

std::vector<MachinePlace> places_along(const SteeredPath& path, const Machine& machine, double step_m) {
  std::vector<MachinePlace> out;
  if (path.empty()) return out;
  const Pose& start = path.front().start;
  Motion at{start.at, anticlockwise_from_east(start.heading)};
  Drawn drawn(machine, at);
  out.push_back(drawn.place());
  const bool towed = tows(machine.turning);
  for (const SteeredStretch& stretch : path) {
    const double tightest =
        std::max(std::abs(stretch.curvature_at_start), std::abs(stretch.curvature_at_end));
    const double even_m = std::min(step_m, tightest > 0 ? kTurned_rad / tightest : step_m);
    const double steps = std::max(1.0, std::ceil(stretch.length_m / even_m));
    if (!(stretch.length_m > 0)) continue;
    // Straight on behind the machine an implement follows in one step.
    const bool follows = !towed || (tightest == 0 && drawn.in_line());
    const double hitch_m = stretch.length_m * (1 + tightest * std::abs(machine.turning.implement_offset_m));
    const double within = follows ? 1 : std::max(1.0, std::ceil(hitch_m / steps / kDrawn_m));
    const double each_m = stretch.length_m / (steps * within);
    for (double i = 0; i < steps; ++i) {
      for (double k = 0; k < within; ++k) {
        at = stepped(at, stretch, (i * within + k) * each_m, each_m);
        drawn.move(at);
      }
      out.push_back(drawn.place());
    }
  }
  return out;
}

std::vector<Side> outline_at(const MachinePlace& place, const Machine& machine) {
  const Turning& turning = machine.turning;
  std::vector<Side> out;
  add_rectangle(place.implement, place.implement_ahead, 0, turning.rear_overhang_m, machine.width_m, out);
  add_rectangle(place.axle, place.ahead, turning.front_overhang_m, 0, turning.vehicle_width_m, out);
  if (tows(turning))
    out.push_back({place.implement, place.implement + turning.drawbar_m * place.implement_ahead});
  return out;
}

}  // namespace tramline::check
