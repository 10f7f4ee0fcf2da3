#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/check/turning/turning_ground.h"

namespace tramline::check {
namespace {

class TurnCheck {
 public:
  TurnCheck(const Case& c, const PlannedTurn& turn, const TurningGround& ground, Violations& out)
      : plan_(c.plan), turning_(c.plan.machine.turning), turn_(turn), ground_(ground), out_(out) {}

  void run() {
    if (turn_.manoeuvre.path.empty()) {
      if (turn_.state == TurnState::kFits) add("has no path", 0);
      return;
    }
    if (!sound()) return;
    check_joints();
    check_ends();
    check_steering();
    check_time();
    if (turn_.state == TurnState::kFits) check_room();
  }

 private:
  const SteeredPath& path() const { return turn_.manoeuvre.path; }

  void add(const std::string& what, double amount) { add_at(what, at_, amount); }
  void add_at(const std::string& what, Point at, double amount) {
    out_.push_back(
        {Rule::kTurns, fmt::format("the turn after piece {} {}", turn_.after + 1, what), at, amount});
  }

  /// Numbers that the other checks can reckon with.
  bool sound() {
    for (const SteeredStretch& stretch : path()) {
      const double numbers = stretch.length_m + stretch.curvature_at_start + stretch.curvature_at_end +
                             stretch.start.at.x + stretch.start.at.y + stretch.start.heading.degrees();
      if (std::isfinite(numbers) && stretch.length_m >= 0 && stretch.length_m <= kFarthest_m) continue;
      add("has a stretch without a sound length, curvature or place", 0);
      return false;
    }
    at_ = path().front().start.at;
    return true;
  }

  void require_pose(const Pose& is, Point at, Point ahead, const char* where) {
    const double off_m = distance(is.at, at);
    const double turned_deg =
        Angle::radians(std::acos(std::clamp(dot(is.heading.unit(), (1 / length(ahead)) * ahead), -1.0, 1.0)))
            .degrees();
    if (off_m > kLengthTolerance_m) add_at(fmt::format("is {:.3f} m off {}", off_m, where), is.at, off_m);
    if (turned_deg > kHeadingTolerance_deg)
      add_at(fmt::format("is turned by {:.1f}° to {}", turned_deg, where), is.at, turned_deg);
  }

  void check_joints() {
    for (std::size_t i = 0; i + 1 < path().size(); ++i) {
      const MachinePlace end = places_along({path()[i]}, plan_.machine, kPoses_m).back();
      require_pose(path()[i + 1].start, end.axle, end.ahead, "the end of the stretch before");
    }
  }

  void check_ends() {
    if (turn_.after + 1 >= plan_.pieces.size()) {
      add("follows no piece that another one follows", 0);
      return;
    }
    const TrackPiece& from = plan_.pieces[turn_.after];
    const TrackPiece& to = plan_.pieces[turn_.after + 1];
    const Point out = from.curve.empty() ? from.end - from.start : direction_at_end(from.curve.back());
    const Point in = to.curve.empty() ? to.end - to.start : direction_at_start(to.curve.front());
    const double back_m =
        turning_.implement_offset_m + (turning_.implement == Coupling::kTowed ? turning_.drawbar_m : 0);
    const auto moved = [&](Point at, Point ahead) { return at + back_m / length(ahead) * ahead; };
    require_pose(path().front().start, moved(from.end, out), out, "the end of its piece");
    const MachinePlace last = places_along({path().back()}, plan_.machine, kPoses_m).back();
    require_pose({last.axle, Heading::from_to({0, 0}, last.ahead)}, moved(to.start, in), in,
                 "the start of the next piece");
  }

  void check_steering() {
    const double tightest = (1 + kRadiusShare) / std::max(plan_.machine.radius_m, kLeastRadius_m);
    for (const SteeredStretch& stretch : path()) {
      const double most = std::max(std::abs(stretch.curvature_at_start), std::abs(stretch.curvature_at_end));
      if (most > tightest)
        add_at(fmt::format("has a radius of {:.2f} m", 1 / most), stretch.start.at, 1 / most);
      if (stretch.gear == Gear::kReverse && !turning_.reverse)
        add_at("is driven in reverse, which this machine may not do", stretch.start.at, stretch.length_m);
    }
    if (!(turning_.steering_time_s > 0)) return;
    for (std::size_t i = 0; i < path().size(); ++i) check_rate(i);
  }

  /// The curvature changes no faster than the machine steers, and jumps only while it stands.
  void check_rate(std::size_t i) {
    const SteeredStretch& stretch = path()[i];
    const double speed =
        stretch.gear == Gear::kForward ? turning_.turning_speed_mps : turning_.reverse_speed_mps;
    const double most = 1 / (plan_.machine.radius_m * turning_.steering_time_s * speed);
    const double rate = std::abs(stretch.curvature_at_end - stretch.curvature_at_start) /
                        std::max(stretch.length_m, kShortest_m);
    if (rate > (1 + kTimeShare) * most && stretch.clothoid())
      add_at("is steered faster than the machine can", stretch.start.at, rate);
    if (i + 1 == path().size() || path()[i + 1].gear != stretch.gear) return;
    const double jump = std::abs(path()[i + 1].curvature_at_start - stretch.curvature_at_end);
    if (jump > kTimeShare / plan_.machine.radius_m)
      add_at("has a jump of curvature", path()[i + 1].start.at, jump);
  }

  /// By its own reckoning, as of the legs of routes.
  void check_time() {
    double time_s = turning_.gear_change_s * gear_changes_of(path());
    for (const SteeredStretch& stretch : path())
      time_s += stretch.length_m /
                (stretch.gear == Gear::kForward ? turning_.turning_speed_mps : turning_.reverse_speed_mps);
    if (std::abs(time_s - turn_.time_s) > kTimeShare * std::max(1.0, time_s))
      add(fmt::format("takes {:.3f} s, not {:.3f} s", time_s, turn_.time_s), turn_.time_s - time_s);
  }

  /// Tracks are worked forwards, before the turn and after it.
  static int gear_changes_of(const SteeredPath& path) {
    int out = path.back().gear == Gear::kReverse ? 1 : 0;
    Gear gear = Gear::kForward;
    for (const SteeredStretch& stretch : path) {
      out += stretch.gear != gear ? 1 : 0;
      gear = stretch.gear;
    }
    return out;
  }

  void check_room() {
    const Excursion off = ground_.deepest(path(), plan_.machine, kPoses_m);
    if (off.depth_m > kOutside_m)
      add_at(fmt::format("leaves the land by {:.2f} m", off.depth_m), off.at, off.depth_m);
  }

  const Plan& plan_;
  const Turning& turning_;
  const PlannedTurn& turn_;
  const TurningGround& ground_;
  Violations& out_;
  Point at_{};
};

}  // namespace

void check_turns(const Case& c, Violations& out) {
  if (c.plan.turns.empty()) return;
  const TurningGround ground(c.plan);
  for (const PlannedTurn& turn : c.plan.turns) TurnCheck(c, turn, ground, out).run();
}

}  // namespace tramline::check
