#include "tramline/route/build/least_backing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/route/axle/axle_path.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"
#include "tramline/turns/outline/outline.h"

namespace tramline {
namespace {

/// An outline that has room may touch the edge of the land; this is more than all tolerances of that, m.
constexpr double kTouching_m = 0.05;
/// Lines are followed back as long as they turn by no more than this, as a sine.
constexpr double kBent = 0.5;
/// Headings parallel to a side to this sine do not lead to it.
constexpr double kParallel = 1e-6;
/// Distances backed are divided down to so much, m.
constexpr double kLeastDivided_m = 0.05;
/// Where so many divisions do not tell, nothing is known.
constexpr int kMostDivided = 10000;
/// Stretches meet without a kink where their headings differ by no more than this sine, and are no sharper
/// than the machine turns where their radii are no less than its own by more than this share.
constexpr double kNoKink = 1e-6, kSharper = 1e-6;
/// A side is far enough where no more than this is lacking, m.
constexpr double kFarEnough_m = 1e-3;

constexpr double kNever_s = std::numeric_limits<double>::infinity();

Pose backed(const LineExit& exit, double by_m) {
  return exit.line.empty() ? exit.pose : pose_on(exit.line, by_m);
}

bool straight(const SteeredStretch& stretch) {
  return stretch.curvature_at_start == 0 && stretch.curvature_at_end == 0;
}

double bent(const Pose& pose, Point ahead) {
  const Point heading = pose.heading.unit();
  return dot(heading, ahead) > 0 ? std::abs(cross(heading, ahead)) : 1;
}

/// Where the machine points when it leaves, or would point if it drove the way from its end.
Point outwards(const LineExit& exit) { return -exit.backing * exit.pose.heading.unit(); }

/// What the sides ask of one end of a way, m.
struct Needed {
  std::optional<double> back_m{};  ///< to back there so far at least; nullopt: nothing
  /// Or to back so far in all, at both ends together, to head for a side all the way.
  double or_in_all_m = kNever_s;
};

/// Where the way heads for a side at its other end too, it need not turn away from it, but then it cannot
/// lead away from it.
Needed needed_of(const LineExit& exit, const LineExit& other) {
  Needed out;
  for (const NearSide& side : exit.near) {
    const double towards = dot(outwards(other), side.inwards) + other.bent;
    if (towards > 0) {
      const double farther_m = dot(other.pose.at - exit.pose.at, side.inwards);
      if (farther_m <= 0) continue;
      const double own_towards = -dot(outwards(exit), side.inwards) + exit.bent;
      out.or_in_all_m = std::min(out.or_in_all_m, farther_m / std::max(towards, own_towards));
    }
    out.back_m = std::max(out.back_m.value_or(0), side.back_m);
  }
  return out;
}

}  // namespace

LeastBacking::LeastBacking(const Ring& outer, double beyond_m, const Machine& machine)
    : turning_(machine.turning), radius_m_(std::max(machine.radius_m, kLeastRadius_m)) {
  const Outline outline = outline_of(machine);
  assert(!outline.tows() && !turning_.reverse);
  double left_m = 0, right_m = 0;
  reach_m_ = 0;
  for (const Box& box : outline.on_machine) {
    left_m = std::max(left_m, box.max_y);
    right_m = std::max(right_m, -box.min_y);
    reach_m_ = std::max({reach_m_, std::abs(box.min_x), std::abs(box.max_x)});
  }
  aside_m_ = std::min(left_m, right_m);
  const Ring hull = hull_of(outer);
  strip_.width_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point next = hull[(i + 1) % hull.size()];
    const Point along = 1 / distance(hull[i], next) * (next - hull[i]);
    const Point inwards = left_of(along);
    sides_.push_back({hull[i] - beyond_m * inwards, inwards});
    double width_m = 0;
    for (const Point p : hull) width_m = std::max(width_m, dot(p - hull[i], inwards));
    if (width_m + 2 * beyond_m < strip_.width_m) strip_ = {along, width_m + 2 * beyond_m};
  }
}

double LeastBacking::lacks_m(const Side& side, const Pose& pose, double backing, Turned turned) const {
  const Point ahead = -backing * pose.heading.unit();
  if (-dot(ahead, side.inwards) <= kParallel) return 0;
  const double along = std::abs(cross(ahead, side.inwards));
  const double nearer_m = radius_m_ * (turned == Turned::kLeast ? 1 - along : 1 + along);
  return std::max(0.0, aside_m_ + nearer_m - kTouching_m - dot(pose.at - side.at, side.inwards));
}

/// Far enough along the line, by steps that lead no farther: what is lacking changes by no more than twice
/// the distance backed, as the side comes nearer or farther and as the line turns.
double LeastBacking::back_m(const Side& side, const LineExit& exit, Turned turned) const {
  double begins_m = 0;
  for (const SteeredStretch& stretch : exit.line) {
    for (double at_m = 0; at_m < stretch.length_m;) {
      const Pose pose = pose_after(stretch, at_m);
      const double lacking_m = lacks_m(side, pose, exit.backing, turned);
      if (lacking_m <= kFarEnough_m) return begins_m + at_m;
      const double rate = straight(stretch) ? exit.backing * dot(pose.heading.unit(), side.inwards) : 2;
      at_m += rate > 0 ? lacking_m / rate : stretch.length_m;
    }
    begins_m += stretch.length_m;
  }
  return begins_m;
}

/// What is driven from the exit on, back out of an end or into a beginning.
LineExit LeastBacking::exit_of(const SteeredPath& line, double backing, double straight_on_m) const {
  LineExit out;
  out.pose = line.front().start;
  out.backing = backing;
  const Point ahead = out.pose.heading.unit();
  Point before = ahead;
  for (const SteeredStretch& stretch : line) {
    const Pose end = end_of(stretch);
    const double sharpest =
        std::max(std::abs(stretch.curvature_at_start), std::abs(stretch.curvature_at_end));
    if (stretch.clothoid() || bent(stretch.start, before) > kNoKink) break;
    if (sharpest * radius_m_ > 1 + kSharper) break;
    if (std::max(bent(stretch.start, ahead), bent(end, ahead)) > kBent) break;
    out.bent = std::max(out.bent, bent(end, ahead));
    out.line.push_back(stretch);
    before = end.heading.unit();
  }
  out.length_m = length(out.line);
  const Pose lifted = moved_on(out.pose, -backing * straight_on_m);
  const Point off = -backing * ahead;
  for (const Side& side : sides_) {
    if (lacks_m(side, lifted, backing, Turned::kLeast) > 0)
      out.near.push_back({side.inwards, back_m(side, out, Turned::kLeast)});
    if (out.bent > 0 || !(lacks_m(side, lifted, backing, Turned::kOtherWay) > 0)) continue;
    const Point left_along = left_of(side.inwards);
    const Point along = dot(off, left_along) >= 0 ? left_along : -1 * left_along;
    if (dot(off, along) < kParallel) continue;  // straight at it: no way is shorter
    out.one_way.push_back({side.inwards, along, std::acos(std::min(1.0, dot(off, along))),
                           back_m(side, out, Turned::kOtherWay)});
  }
  return out;
}

LineExit LeastBacking::left(const SteeredPath& work) const {
  assert(!work.empty());
  return exit_of(retraced(work), -1, turning_.lift_m);
}

LineExit LeastBacking::entered(const SteeredPath& work) const {
  assert(!work.empty());
  return exit_of(work, 1, turning_.lower_m);
}

/// The least that an outline takes up across a strip and turns by across it, from a heading to the opposite
/// one, is as if both were as far off the strip as the lines ever are.
LeastBacking::Along LeastBacking::on_strip(const LineExit& left, const LineExit& entered) const {
  const Point from = left.pose.heading.unit(), to = entered.pose.heading.unit();
  const double aslant = std::abs(cross(from, strip_.along)) + left.bent;
  const double aslant_to = std::abs(cross(to, strip_.along)) + entered.bent;
  if (std::max(aslant, aslant_to) >= 1) return Along::kFree;
  const double along = std::sqrt(1 - aslant * aslant) + std::sqrt(1 - aslant_to * aslant_to);
  const double turning_m = (radius_m_ + aside_m_) * along - reach_m_ * (aslant + aslant_to) - kTouching_m;
  if (strip_.width_m >= turning_m) return Along::kFree;
  return (dot(from, strip_.along) > 0) == (dot(to, strip_.along) > 0) ? Along::kSameWay
                                                                      : Along::kOppositeWays;
}

double LeastBacking::forward_m(const LineExit& left, const LineExit& entered, const Backed& all, double out_m,
                               double in_m) const {
  const double lift_m = all.out ? 0 : turning_.lift_m, lower_m = all.in ? 0 : turning_.lower_m;
  return lift_m + lower_m +
         dubins_length(moved_on(backed(left, out_m), lift_m), moved_on(backed(entered, in_m), -lower_m),
                       radius_m_);
}

/// Where it backs out and in and goes nowhere between it changes gear once less.
double LeastBacking::seconds(const Backed& all, double back_m, double forward_m) const {
  const bool both = all.out && all.in && forward_m > 0;
  const int changes = all.out || all.in ? (both ? 4 : 2) : 0;
  return changes * turning_.gear_change_s + std::max(back_m, all.in_all) / turning_.reverse_speed_mps +
         std::max(0.0, forward_m) / turning_.turning_speed_mps;
}

double LeastBacking::less_s(double found_s) { return std::max(kDivided_s, kDividedShare * found_s); }

/// By halving the distances backed (branch and bound). From farther back the machine could drive forward to
/// where it would have been, so the way from there is longer by no more than that.
double LeastBacking::least_of(const LineExit& left, const LineExit& entered, Backed all,
                              double known_s) const {
  if (all.out_from > all.out_to || all.in_from > all.in_to) return kNever_s;
  double least_s = kNever_s, found_s = known_s + less_s(known_s);
  const auto try_at = [&](const Backed& part, double out_m, double in_m) {
    if (out_m + in_m < all.in_all) return;
    found_s = std::min(found_s, seconds(part, out_m + in_m, forward_m(left, entered, part, out_m, in_m)));
  };
  const double least_in_all_m = std::max(all.in_all, all.out_from + all.in_from);
  const double out_first_m = std::min(all.out_to, least_in_all_m - all.in_from);
  if (least_in_all_m - out_first_m > all.in_to) return kNever_s;
  try_at(all, out_first_m, least_in_all_m - out_first_m);
  const double more_m = std::max(0.0, found_s - seconds(all, least_in_all_m, 0)) * turning_.reverse_speed_mps;
  all.out_to = std::min(all.out_to, least_in_all_m - all.in_from + more_m);
  all.in_to = std::min(all.in_to, least_in_all_m - all.out_from + more_m);
  std::vector<Backed> open{all};
  for (int divided = 0; !open.empty(); ++divided) {
    if (divided > kMostDivided) return 0;
    const Backed part = open.back();
    open.pop_back();
    if (part.out_to + part.in_to < part.in_all) continue;
    const double out_m = part.out_to - part.out_from, in_m = part.in_to - part.in_from;
    const double farthest_m = forward_m(left, entered, part, part.out_to, part.in_to);
    const double at_least_s = seconds(part, part.out_from + part.in_from, farthest_m - out_m - in_m);
    if (at_least_s >= found_s - less_s(found_s)) continue;
    if (std::max(out_m, in_m) < kLeastDivided_m) {
      least_s = std::min(least_s, at_least_s);
      continue;
    }
    Backed near = part, far = part;
    if (out_m > in_m)
      near.out_to = far.out_from = part.out_from + 0.5 * out_m;
    else
      near.in_to = far.in_from = part.in_from + 0.5 * in_m;
    try_at(far, far.out_from, far.in_from);
    open.push_back(far);
    open.push_back(near);
  }
  return std::min(least_s, found_s - less_s(found_s));
}

/// How far the beginning lies behind the end along the strip; 0 where it does not.
double LeastBacking::lacking_m(const LineExit& left, const LineExit& entered) const {
  const bool along = dot(left.pose.heading.unit(), strip_.along) > 0;
  return std::max(0.0, dot(left.pose.at - entered.pose.at, along ? strip_.along : -1 * strip_.along));
}

/// Ways that back no farther than the lines are followed.
double LeastBacking::least_along(const LineExit& left, const LineExit& entered, Along along) const {
  if (along == Along::kOppositeWays) return kNever_s;
  const Needed at_left = needed_of(left, entered), at_entered = needed_of(entered, left);
  const double in_all_m = along == Along::kSameWay ? lacking_m(left, entered) : 0;
  const double turning_s =
      least_of_all(left, entered, {at_left.back_m, at_entered.back_m, in_all_m}, kNever_s);
  const double or_in_all_m = std::min(at_left.or_in_all_m, at_entered.or_in_all_m);
  if (or_in_all_m == kNever_s) return turning_s;
  return least_of_all(left, entered, {{}, {}, std::max(in_all_m, or_in_all_m)}, turning_s);
}

/// Backing out or in or both, as the land asks for; `known_s` where none of these takes less.
double LeastBacking::least_of_all(const LineExit& left, const LineExit& entered, const Asked& asked,
                                  double known_s) const {
  for (const bool out : {false, true})
    for (const bool in : {false, true}) {
      if ((asked.out_m && !out) || (asked.in_m && !in)) continue;
      Backed all;
      all.out = out;
      all.in = in;
      all.in_all = asked.in_all_m;
      if (out) all.out_from = asked.out_m.value_or(0), all.out_to = left.length_m;
      if (in) all.in_from = asked.in_m.value_or(0), all.in_to = entered.length_m;
      known_s = std::min(known_s, least_of(left, entered, all, known_s));
    }
  return known_s;
}

/// The least length between ends that both turn to the same heading along a side. Measured from that heading
/// towards the side the machine turns from φ to 0 and to −π and then back by φ' of the other end, or from φ
/// to 0 and then on to π + φ'; any more turns come on top. A path through these headings θ is no shorter than
/// r Θ + |d − r V|, Θ being all it turns by, V the sum of the headings' unit vectors over that, and d where
/// it leads: its length is ∫(1 − p·h) ds + p·d for any p, of which for |p| ≤ 1 the first part is least where
/// it turns at radius r, and that is greatest for p along d − r V.
double LeastBacking::loop_m(const LineExit& left, const OneWaySide& leaves, const LineExit& entered,
                            const OneWaySide& enters) const {
  const Point u = leaves.along, w = -1 * leaves.inwards;
  const Point leads = moved_on(entered.pose, -turning_.lower_m).at - moved_on(left.pose, turning_.lift_m).at;
  const double a = leaves.angle, b = enters.angle, turned = std::numbers::pi + a + b;
  const Point across = (std::sin(a) - std::sin(b)) * u;
  const Point away = across - (2 + std::cos(a) - std::cos(b)) * w;
  const Point towards = across + (2 - std::cos(a) + std::cos(b)) * w;
  const double straight_m = std::min(distance(leads, radius_m_ * away), distance(leads, radius_m_ * towards));
  return radius_m_ * turned + straight_m;
}

/// Ways between ends that turn to the same heading along a side: a loop, or back until one of them could turn
/// the other way.
double LeastBacking::least_loop(const LineExit& left, const LineExit& entered, double known_s) const {
  const double lifts_m = turning_.lift_m + turning_.lower_m, turning_mps = turning_.turning_speed_mps;
  double out_s = known_s;
  for (const OneWaySide& leaves : left.one_way)
    for (const OneWaySide& enters : entered.one_way) {
      if (!(leaves.inwards == enters.inwards) || dot(leaves.along, enters.along) < 0) continue;
      const double turning_m = loop_m(left, leaves, entered, enters);
      const double loop_s = (lifts_m + turning_m) / turning_mps;
      if (loop_s <= out_s) continue;
      // Where it backs less far than that, a loop is shorter by no more than it backs and the lifting lines.
      const double backed_m =
          std::min(leaves.back_m, left.length_m) + std::min(enters.back_m, entered.length_m);
      const double gained_s = std::max(0.0, 1 / turning_mps - 1 / turning_.reverse_speed_mps) * backed_m;
      const double backing_s = 2 * turning_.gear_change_s + (turning_m - lifts_m) / turning_mps - gained_s;
      double least_s = std::min(loop_s, backing_s);
      if (least_s <= out_s) continue;
      least_s = least_of_all(left, entered, {leaves.back_m, {}, 0}, least_s);
      least_s = least_of_all(left, entered, {{}, enters.back_m, 0}, least_s);
      out_s = std::max(out_s, least_s);
    }
  return out_s;
}

/// Ways that back farther along one of them, by whatever way from there.
double LeastBacking::least_beyond(const LineExit& left, const LineExit& entered) const {
  const double fastest_mps = std::max(turning_.turning_speed_mps, turning_.reverse_speed_mps);
  const auto rest_s = [&](const Pose& from, const Pose& to) {
    return reeds_shepp_length(from, to, radius_m_) / fastest_mps;
  };
  const double out_s =
      left.length_m / turning_.reverse_speed_mps + rest_s(backed(left, left.length_m), entered.pose);
  const double in_s =
      entered.length_m / turning_.reverse_speed_mps + rest_s(left.pose, backed(entered, entered.length_m));
  return 2 * turning_.gear_change_s + std::min(out_s, in_s);
}

double LeastBacking::between(const LineExit& left, const LineExit& entered, double known_s) const {
  const Along along = on_strip(left, entered);
  const bool free =
      along == Along::kFree && !needed_of(left, entered).back_m && !needed_of(entered, left).back_m;
  if (free && (left.one_way.empty() || entered.one_way.empty())) return known_s;
  const double beyond_s = least_beyond(left, entered);
  if (beyond_s <= known_s) return known_s;
  const double along_s = free ? known_s : std::max(known_s, least_along(left, entered, along) - kDivided_s);
  return std::max(known_s, std::min(beyond_s - kDivided_s, least_loop(left, entered, along_s)));
}

}  // namespace tramline
