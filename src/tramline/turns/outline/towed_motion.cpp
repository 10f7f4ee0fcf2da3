#include "tramline/turns/outline/towed_motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "tramline/turns/outline/tolerances.h"

namespace tramline {
namespace {

/// What one step of the motion along a stretch needs of the hitch. Anticlockwise positive; in the frame of
/// the machine, by the way of its axle.
struct HitchOnCircle {
  HitchOnCircle(double machine_curvature, double hitch_m)
      : aside(-machine_curvature * hitch_m),
        speed(std::sqrt(1 + aside * aside)),
        curvature(machine_curvature / speed) {}
  double aside;      ///< tangent of the angle from the machine's heading to the direction of motion
  double speed;      ///< way of the hitch by that of the axle
  double curvature;  ///< of the way of the hitch, 1/m

  Point direction(Point machine_ahead) const {
    return (1 / speed) * (machine_ahead + aside * left_of(machine_ahead));
  }
};

/// From one unit vector to the other, anticlockwise positive, in (−π, π].
double angle_from_to(Point from, Point to) { return std::atan2(cross(from, to), dot(from, to)); }

struct SineRange {
  double least;
  double most;
};

SineRange sines_between(double one, double other) {
  constexpr double pi = std::numbers::pi;
  const double low = std::min(one, other), high = std::max(one, other);
  const double first = std::sin(low), last = std::sin(high);
  const auto reaches = [&](double angle) {
    return angle + 2 * pi * std::ceil((low - angle) / (2 * pi)) <= high;
  };
  return {reaches(-0.5 * pi) ? -1 : std::min(first, last), reaches(0.5 * pi) ? 1 : std::max(first, last)};
}

double tightest_curvature(const SteeredStretch& stretch) {
  return std::max(std::abs(stretch.curvature_at_start), std::abs(stretch.curvature_at_end));
}

/// An even motion between two placements that drives `way`, with the bounds that follow from those of the
/// derivatives. If the velocity changes by no more than M and the angular velocity by no more than N for each
/// metre of the way h, and the even motion has the velocity of the middle, the headings differ by at most
/// N h²/8 (linear interpolation), velocities by M times the distance from the middle, and places by at most
/// M h²/4 + N h²/12 · |way|.
MotionPiece even_between(const Placement& from, const Placement& to, double way, double change_of_velocity,
                         double change_of_turning, double h) {
  MotionPiece out;
  out.even = {from, way, angle_from_to(from.ahead, to.ahead)};
  out.off_m = change_of_velocity * h * h / 4 + change_of_turning * h * h * std::abs(way) / 12;
  out.off_rad = change_of_turning * h * h / 8;
  return out;
}

}  // namespace

TowedMotion::TowedMotion(const SteeredPath& path, const Outline& outline)
    : TowedMotion(
          path, outline,
          path.empty() ? Heading::clockwise_from_north(Angle::degrees(0)) : path.front().start.heading) {}

TowedMotion::TowedMotion(const SteeredPath& path, const Outline& outline, Heading drawbar_at_start)
    : path_(path), hitch_m_(outline.hitch_m), drawbar_m_(outline.drawbar_m) {
  assert(outline.tows());
  Point drawbar = drawbar_at_start.unit();
  starts_.reserve(path_.size());
  for (std::size_t i = 0; i < path_.size(); ++i) {
    const SteeredStretch& on = path_[i];
    assert(on.gear == Gear::kForward);
    starts_.push_back({drawbar});
    if (on.clothoid()) integrate(on, starts_.back());
    const Placement machine = placed(end_of(on));
    drawbar = drawbar_at(i, on.length_m, machine);
    angle_at_end_rad_ = angle_from_to(drawbar, machine.ahead);
  }
}

Placement TowedMotion::implement_of(const Placement& machine, Point drawbar) const {
  return {machine.at - hitch_m_ * machine.ahead - drawbar_m_ * drawbar, drawbar};
}

Placement TowedMotion::implement(std::size_t stretch, double after_m) const {
  assert(stretch < path_.size());
  const Placement machine = placed(pose_after(path_[stretch], after_m));
  return implement_of(machine, drawbar_at(stretch, after_m, machine));
}

Pose TowedMotion::pose(double after_m) const {
  std::size_t stretch = 0;
  for (; stretch + 1 < path_.size() && after_m >= path_[stretch].length_m; ++stretch)
    after_m -= path_[stretch].length_m;
  const Placement out = implement(stretch, std::clamp(after_m, 0.0, path_[stretch].length_m));
  return {out.at, Heading::from_to({0, 0}, out.ahead)};
}

Angle TowedMotion::angle_at_end() const { return Angle::radians(angle_at_end_rad_); }

Point TowedMotion::drawbar_at(std::size_t stretch, double after_m, const Placement& machine) const {
  const SteeredStretch& on = path_[stretch];
  if (!on.clothoid()) return drawbar_on_circle(stretch, after_m, machine);
  const Start& start = starts_[stretch];
  if (start.bent.empty()) return start.drawbar;
  const auto place = std::min(static_cast<std::size_t>(after_m / start.step_m), start.bent.size() - 1);
  const double from = static_cast<double>(place) * start.step_m;
  const Point bent = drawbar_step(on, start.bent[place], from, after_m - from);
  return bent.x * machine.ahead - bent.y * left_of(machine.ahead);
}

Point TowedMotion::drawbar_on_circle(std::size_t stretch, double after_m, const Placement& machine) const {
  const SteeredStretch& on = path_[stretch];
  const HitchOnCircle hitch(on.curvature_at_start, hitch_m_);
  const Point before = hitch.direction(on.start.heading.unit());
  const double sine = cross(starts_[stretch].drawbar, before);
  const double cosine = dot(starts_[stretch].drawbar, before);
  // of half the angle, but for a factor
  const double x = cosine >= 0 ? sine : 1 - cosine;
  const double y = cosine >= 0 ? 1 + cosine : sine;
  const double k = hitch.curvature * drawbar_m_;
  const double ways = driving_sense(on.gear) * after_m * hitch.speed / drawbar_m_;
  const double square = 1 - k * k;
  double c = 1, s = 0.5 * ways;
  if (square > 0) {
    const double root = std::sqrt(square);
    const double less = std::expm1(-root * std::abs(ways));
    c = 0.5 * (2 + less);
    s = std::copysign(-0.5 * less / root, ways);
  } else if (square < 0) {
    const double root = std::sqrt(-square);
    c = std::cos(0.5 * root * ways);
    s = std::sin(0.5 * root * ways) / root;
  }
  const double x_after = c * x + s * (k * y - x), y_after = c * y + s * (y - k * x);
  const double norm = x_after * x_after + y_after * y_after;
  const double sine_after = 2 * x_after * y_after / norm;
  const double cosine_after = (y_after - x_after) * (y_after + x_after) / norm;
  const Point direction = hitch.direction(machine.ahead);
  return cosine_after * direction - sine_after * left_of(direction);
}

/// The angle b from the drawbar to the machine's heading, as (cos b, sin b), after a step on a clothoid, by
/// the rule of Runge and Kutta. By the way s of the machine's axle db/ds = κ − (sin b − κ l cos b)/L, and the
/// vector turns by as much: no sine has to be computed.
Point TowedMotion::drawbar_step(const SteeredStretch& on, Point bent, double from_m, double step_m) const {
  const auto rate = [&](double after, Point at) {
    const double curvature = curvature_at(on, from_m + after);
    return (curvature - (at.y - curvature * hitch_m_ * at.x) / drawbar_m_) * left_of(at);
  };
  const double step = driving_sense(on.gear) * step_m;
  const Point k1 = rate(0, bent);
  const Point k2 = rate(0.5 * step_m, bent + 0.5 * step * k1);
  const Point k3 = rate(0.5 * step_m, bent + 0.5 * step * k2);
  const Point k4 = rate(step_m, bent + step * k3);
  const Point out = bent + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  return (1 / length(out)) * out;
}

void TowedMotion::integrate(const SteeredStretch& on, Start& out) const {
  if (!(on.length_m > 0)) return;
  const double fastest =
      tightest_curvature(on) + (1 + tightest_curvature(on) * std::abs(hitch_m_)) / drawbar_m_;
  const double steps = std::ceil(on.length_m * fastest / kDrawbarStep_rad) + 1;
  out.step_m = on.length_m / steps;
  const Point ahead = on.start.heading.unit();
  Point bent{dot(out.drawbar, ahead), cross(out.drawbar, ahead)};
  for (double i = 0; i < steps; ++i) {
    out.bent.push_back(bent);
    bent = drawbar_step(on, bent, i * out.step_m, out.step_m);
  }
}

/// With b from the drawbar to the machine's heading, the velocity is cos b + κ l sin b and the turning
/// (sin b − κ l cos b)/L.
TowedMotion::Bounds TowedMotion::bounds_on(std::size_t stretch) const {
  const SteeredStretch& on = path_[stretch];
  const double curvature = tightest_curvature(on);
  const double velocity = 1 + curvature * std::abs(hitch_m_);
  const double turning = velocity / drawbar_m_;
  const double change = velocity * (curvature + turning) + std::abs(curvature_change(on) * hitch_m_);
  return {velocity, turning, change, change / drawbar_m_};
}

double TowedMotion::pieces(std::size_t stretch) const {
  return std::max(1.0, std::ceil(0.5 * path_[stretch].length_m * bounds_on(stretch).turning));
}

MotionPiece TowedMotion::motion(std::size_t stretch, double from_m, double to_m) const {
  assert(from_m <= to_m && (to_m - from_m) * bounds_on(stretch).turning < std::numbers::pi);
  return path_[stretch].clothoid() ? on_clothoid(stretch, from_m, to_m) : on_circle(stretch, from_m, to_m);
}

/// On a circle the angle a tends to one side throughout the piece, which narrows the bounds: velocity is
/// cos a, angular velocity sin(a)/L.
MotionPiece TowedMotion::on_circle(std::size_t stretch, double from_m, double to_m) const {
  const SteeredStretch& on = path_[stretch];
  const HitchOnCircle hitch(on.curvature_at_start, hitch_m_);
  const Placement machine = placed(pose_after(on, from_m));
  const Point drawbar = drawbar_at(stretch, from_m, machine);
  const Placement from = implement_of(machine, drawbar);
  const Placement to = implement(stretch, to_m);
  const double ways = driving_sense(on.gear) * (to_m - from_m) * hitch.speed;
  const double angle = angle_from_to(drawbar, hitch.direction(machine.ahead));
  const double middle = 0.5 * (from_m + to_m);
  const Placement halfway = placed(pose_after(on, middle));
  const double velocity = dot(drawbar_at(stretch, middle, halfway), hitch.direction(halfway.ahead));
  const double angle_after = angle + hitch.curvature * ways - angle_from_to(drawbar, to.ahead);
  const SineRange sines = sines_between(angle, angle_after);
  const double fastest = std::max(std::abs(hitch.curvature - sines.least / drawbar_m_),
                                  std::abs(hitch.curvature - sines.most / drawbar_m_));
  const double steepest = std::max(std::abs(sines.least), std::abs(sines.most));
  return even_between(from, to, ways * velocity, steepest * fastest, fastest / drawbar_m_, std::abs(ways));
}

MotionPiece TowedMotion::on_clothoid(std::size_t stretch, double from_m, double to_m) const {
  const SteeredStretch& on = path_[stretch];
  const double h = to_m - from_m, middle = 0.5 * (from_m + to_m);
  const Placement machine = placed(pose_after(on, middle));
  const double angle = angle_from_to(drawbar_at(stretch, middle, machine), machine.ahead);
  const double velocity = std::cos(angle) + curvature_at(on, middle) * hitch_m_ * std::sin(angle);
  const Bounds bounds = bounds_on(stretch);
  return even_between(implement(stretch, from_m), implement(stretch, to_m),
                      driving_sense(on.gear) * h * velocity, bounds.change_of_velocity,
                      bounds.change_of_turning, h);
}

}  // namespace tramline
