#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tramline/check/rules/route/route_facts.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/check/turning/turning_ground.h"

namespace tramline::check {
namespace {

/// A machine that has no room at a gate begins or ends beside it, at most so far away, m. It has room where
/// in one of so many headings it can drive on so far, m.
constexpr double kMostBesideGate_m = 100;
constexpr int kGateHeadings = 8;
constexpr double kDrivesOn_m = 1;
/// Where legs and their stretches meet the machine may be turned by this, degrees. Works, and ways back along
/// them, may have small kinks.
constexpr double kTurnedAtJoint_deg = 0.1;
constexpr double kAny_deg = 360;

bool is_sound(const RouteLeg& leg) {
  const double own = leg.time_s + leg.missing_m + leg.lateral_error_m;
  if (leg.path.empty() || !std::isfinite(own) || leg.time_s < 0 || leg.missing_m < 0) return false;
  return std::all_of(leg.path.begin(), leg.path.end(), [](const SteeredStretch& stretch) {
    const double numbers = stretch.length_m + stretch.curvature_at_start + stretch.curvature_at_end +
                           stretch.start.at.x + stretch.start.at.y + stretch.start.heading.degrees();
    return std::isfinite(numbers) && stretch.length_m >= 0 && stretch.length_m <= kFarthest_m;
  });
}

class LegsCheck {
 public:
  LegsCheck(const Case& c, Violations& out)
      : plan_(c.plan), turning_(c.plan.machine.turning), legs_(c.plan.route.legs), out_(out) {}

  void run() {
    Gear before = Gear::kForward;
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      check_joints(i);
      check_gear(i);
      check_steering(i);
      check_time(i, before);
      before = legs_[i].gear;
    }
    check_gate("start", plan_.settings.route.start, legs_.front().path.front().start.at);
    check_gate("end", plan_.settings.route.end, last_place(legs_.back().path).at);
    if (!plan_.settings.route.start) require_work(0, "begins");
    if (!plan_.settings.route.end) require_work(legs_.size() - 1, "ends");
  }

 private:
  void add(std::size_t leg, const std::string& what, Point at, double amount) {
    out_.push_back({Rule::kRouteLegs, fmt::format("{} {}", leg_name(plan_, leg), what), at, amount});
  }

  /// Without a gate there is nowhere to come from or to go to.
  void require_work(std::size_t leg, const char* what) {
    if (!legs_[leg].work && !legs_[leg].pass)
      add(leg, fmt::format("{} the route without a gate", what), legs_[leg].path.front().start.at,
          length(legs_[leg]));
  }

  void check_joint(std::size_t leg, const LinePlace& is, const LinePlace& before, double most_deg) {
    const double off_m = distance(is.at, before.at), turned = turned_deg(is.ahead, before.ahead);
    if (off_m > kLengthTolerance_m) add(leg, fmt::format("jumps by {:.3f} m", off_m), is.at, off_m);
    if (turned > most_deg) add(leg, fmt::format("turns by {:.2f}° on the spot", turned), is.at, turned);
  }

  static bool along_work(const RouteLeg& leg) { return leg.work || leg.pass; }

  void check_joints(std::size_t i) {
    const SteeredPath& path = legs_[i].path;
    if (i > 0) {
      const bool goes_on = along_work(legs_[i - 1]) && along_work(legs_[i]);
      check_joint(i, first_place(path), last_place(legs_[i - 1].path),
                  goes_on ? kAny_deg : kTurnedAtJoint_deg);
    }
    const double within_deg = may_have_kinks(i) ? kAny_deg : kTurnedAtJoint_deg;
    for (std::size_t k = 0; k + 1 < path.size(); ++k)
      check_joint(
          i, {path[k + 1].start.at, path[k + 1].start.heading.unit()}, last_place({path[k]}),
          legs_[i].kind == LegKind::kBackOut ? std::max(within_deg, kHeadingTolerance_deg) : within_deg);
  }

  /// Tracks and passes made as papers make them have kinks, which the rule of drivable paths reports.
  bool may_have_kinks(std::size_t leg) const {
    if (legs_[leg].kind == LegKind::kWork) return true;
    return legs_[leg].pass || (leg > 0 && legs_[leg - 1].pass && legs_[leg].kind == LegKind::kBackOut);
  }

  void check_gear(std::size_t i) {
    const RouteLeg& leg = legs_[i];
    for (const SteeredStretch& stretch : leg.path)
      if (stretch.gear != leg.gear) return add(i, "changes gear on its way", stretch.start.at, 0);
    const Point at = leg.path.front().start.at;
    if (leg.kind == LegKind::kBackOut && leg.gear != Gear::kReverse) add(i, "backs out forwards", at, 0);
    if (leg.gear != Gear::kReverse) return;
    if (leg.kind != LegKind::kBackOut && !turning_.reverse)
      add(i, "is driven in reverse, which this machine may not do", at, length(leg));
    if (tows(turning_)) add(i, "is driven in reverse with a drawbar in tow", at, length(leg));
  }

  /// Pieces, passes, and the ways back along them are as tight as they are: that is no matter of the route.
  void check_steering(std::size_t i) {
    const RouteLeg& leg = legs_[i];
    if (leg.work || leg.pass || leg.kind == LegKind::kBackOut) return;
    const double tightest = (1 + kRadiusShare) / std::max(plan_.machine.radius_m, kLeastRadius_m);
    for (const SteeredStretch& stretch : leg.path) {
      const double most = std::max(std::abs(stretch.curvature_at_start), std::abs(stretch.curvature_at_end));
      if (most > tightest)
        add(i, fmt::format("has a radius of {:.2f} m", 1 / most), stretch.start.at, 1 / most);
    }
    if (!(turning_.steering_time_s > 0)) return;
    for (std::size_t k = 0; k < leg.path.size(); ++k) check_rate(i, k);
  }

  /// The curvature changes no faster than the machine steers, and jumps only while it stands.
  void check_rate(std::size_t leg, std::size_t k) {
    const SteeredStretch& stretch = legs_[leg].path[k];
    const double speed =
        stretch.gear == Gear::kForward ? turning_.turning_speed_mps : turning_.reverse_speed_mps;
    const double radius_m = std::max(plan_.machine.radius_m, kLeastRadius_m);
    const double most = 1 / (radius_m * turning_.steering_time_s * speed);
    const double rate = std::abs(stretch.curvature_at_end - stretch.curvature_at_start) /
                        std::max(stretch.length_m, kShortest_m);
    if (stretch.clothoid() && rate > (1 + kTimeShare) * most)
      add(leg, "is steered faster than the machine can", stretch.start.at, rate);
    if (k + 1 == legs_[leg].path.size()) return;
    const SteeredStretch& next = legs_[leg].path[k + 1];
    const double jump = std::abs(next.curvature_at_start - stretch.curvature_at_end);
    if (jump > kTimeShare / radius_m) add(leg, "has a jump of curvature", next.start.at, jump);
  }

  /// By its own reckoning of length and speed: what plans are timed with is not asked.
  void check_time(std::size_t i, Gear before) {
    const RouteLeg& leg = legs_[i];
    double length_m = 0;
    for (const SteeredStretch& stretch : leg.path) length_m += stretch.length_m;
    const double idle = leg.gear == Gear::kForward ? turning_.turning_speed_mps : turning_.reverse_speed_mps;
    const double time_s = length_m / (leg.work ? turning_.working_speed_mps : idle) +
                          (leg.gear != before ? turning_.gear_change_s : 0);
    if (!(std::abs(time_s - leg.time_s) <= kTimeShare * std::max(1.0, time_s)))
      add(i, fmt::format("takes {:.3f} s, not {:.3f} s", time_s, leg.time_s), leg.path.front().start.at,
          leg.time_s - time_s);
  }

  void check_gate(const char* which, const std::optional<Point>& gate, Point at) {
    if (!gate) return;
    const double off_m = distance(*gate, at);
    const bool beside = off_m <= kMostBesideGate_m && !has_room_at(*gate);
    if (off_m <= kLengthTolerance_m || beside) return;
    out_.push_back({Rule::kRouteLegs,
                    fmt::format("the {} of the route is {:.3f} m from its gate", which, off_m), at, off_m});
  }

  bool has_room_at(Point gate) const {
    const TurningGround ground(plan_);
    for (int i = 0; i < kGateHeadings; ++i) {
      const Heading heading = Heading::clockwise_from_north(Angle::degrees(360.0 * i / kGateHeadings));
      const SteeredPath on{{{gate, heading}, kDrivesOn_m, 0, 0}};
      if (ground.deepest(on, plan_.machine, kPoses_m).depth_m <= kOutside_m) return true;
    }
    return false;
  }

  const Plan& plan_;
  const Turning& turning_;
  const std::vector<RouteLeg>& legs_;
  Violations& out_;
};

}  // namespace

bool check_route_is_sound(const Plan& plan, Violations& out) {
  const std::vector<RouteLeg>& legs = plan.route.legs;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (is_sound(legs[i])) continue;
    out.push_back({Rule::kRouteLegs,
                   fmt::format("{} has no path, or one without sound lengths, curvatures and places",
                               leg_name(plan, i)),
                   plan.field.outer.front(), 0});
    return false;
  }
  return true;
}

void check_route_legs(const Case& c, Violations& out) {
  if (c.plan.route.planned()) LegsCheck(c, out).run();
}

}  // namespace tramline::check
