#include "tramline/route/backing/least_backing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/route/axle/axle_path.h"
#include "tramline/route/backing/needed_backing.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"
#include "tramline/turns/outline/outline.h"

namespace tramline {
namespace {

/// An outline that has room may touch the edge of the land; this is more than all tolerances of that, m.
constexpr double kTouching_m = 0.05;
/// Headings parallel to a side to this sine do not lead to it.
constexpr double kParallel = 1e-6;
/// Lines that are straight but for rounding turn by no more than this sine: less than the verifier takes for
/// such.
constexpr double kNotBent = 1e-7;
/// A side is far enough where no more than this is lacking, m.
constexpr double kFarEnough_m = 1e-3;

constexpr double kNever_s = std::numeric_limits<double>::infinity();

bool straight(const SteeredStretch& stretch) {
  return stretch.curvature_at_start == 0 && stretch.curvature_at_end == 0;
}

}  // namespace

LeastBacking::LeastBacking(const Ring& outer, double beyond_m, const Machine& machine, double stop_s,
                           Places places)
    : terms_{machine.turning, 2 * machine.turning.gear_change_s + stop_s,
             std::max(machine.radius_m, kLeastRadius_m)} {
  const Outline outline = outline_of(machine);
  assert(!outline.tows() && !terms_.turning.reverse);
  double left_m = 0, right_m = 0;
  reach_m_ = 0;
  for (const Box& box : outline.on_machine) {
    left_m = std::max(left_m, box.max_y);
    right_m = std::max(right_m, -box.min_y);
    reach_m_ = std::max({reach_m_, std::abs(box.min_x), std::abs(box.max_x)});
  }
  aside_m_ = std::min(left_m, right_m);
  behind_m_ = ahead_m_ = -reach_m_;
  for (const Box& box : outline.on_machine)
    if (std::min(box.max_y, -box.min_y) >= aside_m_) {
      behind_m_ = std::max(behind_m_, -box.min_x);
      ahead_m_ = std::max(ahead_m_, box.max_x);
    }
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
  if (places == Places::kNotFollowed) return;
  std::vector<Point> corners;
  for (const Box& box : outline.on_machine) {
    const auto of_box = corners_of(box);
    corners.insert(corners.end(), of_box.begin(), of_box.end());
  }
  reach_.emplace(sides_, corners, terms_.radius_m);
}

double LeastBacking::lacks_m(const Side& side, const Pose& pose, double backing, Turned turned) const {
  const Point ahead = -backing * pose.heading.unit();
  if (-dot(ahead, side.inwards) <= kParallel) return 0;
  const double along = std::abs(cross(ahead, side.inwards));
  const double nearer_m = terms_.radius_m * (turned == Turned::kLeast ? 1 - along : 1 + along);
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
  return kNowhere_m;
}

/// What is driven from the exit on, back out of an end or into a beginning.
LineExit LeastBacking::exit_of(GentleRun run, const Pose& pose, double backing, double straight_on_m) const {
  LineExit out;
  out.pose = pose;
  out.backing = backing;
  out.line = std::move(run.line);
  out.bent = run.bent > kNotBent ? run.bent : 0;
  out.length_m = length(out.line);
  out.whole = run.to_end;
  out.behind_m = run.begins_m;
  const Pose lifted = moved_on(out.pose, -backing * straight_on_m);
  const Point off = -backing * out.pose.heading.unit();
  for (const Side& side : sides_) {
    if (lacks_m(side, lifted, backing, Turned::kLeast) > 0)
      out.near.push_back({side.inwards, back_m(side, out, Turned::kLeast)});
    if (out.bent > 0) continue;
    const Point left_along = left_of(side.inwards);
    const Point along = dot(off, left_along) >= 0 ? left_along : -1 * left_along;
    if (dot(off, along) < kParallel) continue;  // straight at it: no way is shorter
    if (std::abs(dot(off, side.inwards)) <= kParallel)
      out.one_way.push_back({side.inwards, along, 0, kNowhere_m});
    else if (lacks_m(side, lifted, backing, Turned::kOtherWay) > 0)
      out.one_way.push_back({side.inwards, along, std::acos(std::min(1.0, dot(off, along))),
                             back_m(side, out, Turned::kOtherWay)});
  }
  return out;
}

/// What is reached off the end of a line is what leads to it on the way to its beginning, all along it.
std::shared_ptr<const PlacesByHeading> LeastBacking::places_from(const Pose& pose, double sense) const {
  constexpr double kSame = 1e-9;
  for (const Followed& known : followed_)
    if (known.sense == sense && distance(known.from.at, pose.at) < kSame &&
        distance(known.from.heading.unit(), pose.heading.unit()) < kSame)
      return known.places;
  followed_.push_back({pose, sense, std::make_shared<const PlacesByHeading>(reach_->from(pose, sense))});
  return followed_.back().places;
}

LineExits LeastBacking::exits_of(const SteeredPath& line, double backing, double straight_on_m) const {
  const Pose& pose = line.front().start;
  LineExits out{exit_of(first_run(line, terms_.radius_m), pose, backing, straight_on_m)};
  const auto bend = std::ranges::find_if_not(line, straight);
  if (out.whole.bent > 0 && bend != line.begin()) {
    GentleRun until_it_bends = first_run({line.begin(), bend}, terms_.radius_m);
    until_it_bends.to_end = false;
    out.straight = exit_of(std::move(until_it_bends), pose, backing, straight_on_m);
  }
  if (std::optional<GentleRun> run = longest_run_behind_bends(line, terms_.radius_m)) {
    const Pose begins = run->line.front().start;
    out.behind_bend = exit_of(*std::move(run), begins, backing, 0);
  }
  if (reach_)
    out.reached = {places_from(line.front().start, -backing), places_from(end_of(line.back()), backing),
                   line};
  return out;
}

LineExits LeastBacking::left(const SteeredPath& work) const {
  assert(!work.empty());
  return exits_of(retraced(work), -1, terms_.turning.lift_m);
}

LineExits LeastBacking::entered(const SteeredPath& work) const {
  assert(!work.empty());
  return exits_of(work, 1, terms_.turning.lower_m);
}

/// The least that an outline takes up across a strip and turns by across it, from a heading to the opposite
/// one, is as if both were as far off the strip as the lines ever are.
LeastBacking::Along LeastBacking::on_strip(const LineExit& left, const LineExit& entered) const {
  const Point from = left.pose.heading.unit(), to = entered.pose.heading.unit();
  const double aslant = std::abs(cross(from, strip_.along)) + left.bent;
  const double aslant_to = std::abs(cross(to, strip_.along)) + entered.bent;
  if (std::max(aslant, aslant_to) >= 1) return Along::kFree;
  const double along = std::sqrt(1 - aslant * aslant) + std::sqrt(1 - aslant_to * aslant_to);
  const double turning_m =
      (terms_.radius_m + aside_m_) * along - reach_m_ * (aslant + aslant_to) - kTouching_m;
  if (strip_.width_m >= turning_m) return Along::kFree;
  return (dot(from, strip_.along) > 0) == (dot(to, strip_.along) > 0) ? Along::kSameWay
                                                                      : Along::kOppositeWays;
}

/// How far the beginning lies behind the end along the strip; 0 where it does not.
double LeastBacking::lacking_m(const LineExit& left, const LineExit& entered) const {
  const bool along = dot(left.pose.heading.unit(), strip_.along) > 0;
  return std::max(0.0, dot(left.pose.at - entered.pose.at, along ? strip_.along : -1 * strip_.along));
}

/// The machine gets to the beginning of the one line from where it has backed to on the other, or from the
/// end of that to where it begins to back into the one.
LeastBacking::OneStop LeastBacking::one_stop(const LineExits& left, const LineExits& entered) {
  if (!left.reached || !entered.reached) return {};
  const ExitReach &from = *left.reached, &to = *entered.reached;
  OneStop out{may_meet(*to.off, from.line), may_meet(*from.off, to.line), may_meet(*from.beyond, *to.off),
              may_meet(*from.off, *to.beyond)};
  const bool none = may_meet(*to.off, left.whole.pose) && may_meet(*from.off, entered.whole.pose);
  const bool one = out.out || out.in || out.out_and_on || out.in_and_on;
  out.least_stops = none ? 0 : one ? 1 : 2;
  return out;
}

/// Ways that back no farther than the lines are followed. Where no stop at one end alone does, they back at
/// the other.
double LeastBacking::least_along(const BackedWays& ways, const LineExit& left, const LineExit& entered,
                                 Along along, const OneStop& may) const {
  if (along == Along::kOppositeWays) return kNever_s;
  const NeededBacking at_left = needed_backing(left, entered, terms_.radius_m),
                      at_entered = needed_backing(entered, left, terms_.radius_m);
  const double in_all_m = along == Along::kSameWay ? lacking_m(left, entered) : 0;
  const std::optional<double> out_anyhow = may.in ? std::nullopt : std::optional(0.0),
                              in_anyhow = may.out ? std::nullopt : std::optional(0.0);
  const double turning_s =
      ways.least_s({std::max(at_left.back_m, out_anyhow), std::max(at_entered.back_m, in_anyhow), in_all_m, 0,
                    0, may.least_stops},
                   kNever_s);
  const HeadsAllAlong &of_left = at_left.or_all_along, &of_entered = at_entered.or_all_along;
  const double or_in_all_m = std::min(of_left.in_all_m, of_entered.in_all_m);
  if (or_in_all_m == kNowhere_m) return turning_s;
  return ways.least_s({out_anyhow, in_anyhow, std::max(in_all_m, or_in_all_m),
                       std::min(of_left.here_only_m, of_entered.there_only_m),
                       std::min(of_left.there_only_m, of_entered.here_only_m), may.least_stops},
                      turning_s);
}

/// From a pose that leads away from a side, backing on (`sense` +1), or forward on from one that leads to it
/// (-1), while it has room. At an angle φ₀ to the side it reaches φ ≤ φ₀ not before it is r (cos φ − cos φ₀)
/// nearer, and at φ the corners a aside and b towards the side are a cos φ + b sin φ nearer than the axle.
LeastBacking::Aslant LeastBacking::aslant(const Side& side, const Pose& pose, double sense) const {
  const Aslant parallel{0, kNowhere_m};
  const double steep = dot(sense * pose.heading.unit(), side.inwards);
  if (steep <= kParallel) return parallel;
  const double angle = std::asin(std::min(1.0, steep));
  const double room_m = dot(pose.at - side.at, side.inwards) + kTouching_m;
  const double towards_m = sense > 0 ? behind_m_ : ahead_m_;
  const double takes_m = std::hypot(terms_.radius_m + aside_m_, towards_m);
  const double most_at = std::atan2(towards_m, terms_.radius_m + aside_m_);
  const double given_m = room_m + terms_.radius_m * std::cos(angle);
  if (given_m >= takes_m || most_at >= angle) return parallel;
  const double flattest = std::min(angle, most_at + std::acos(given_m / takes_m));
  if (flattest <= kParallel) return parallel;
  const double least_m = std::min(aside_m_ * std::cos(flattest) + towards_m * std::sin(flattest), towards_m);
  return {flattest, std::max(0.0, room_m - least_m) / std::tan(flattest)};
}

/// Whether the machine may back all along a line and on, stop, and go forward to the other end of the way;
/// or, the other way round, go forward from it, stop, and back all along the line.
bool LeastBacking::one_stop_may_do(const LineExit& exit, const LineExit& other) const {
  constexpr double kFarther_m = 1e-3, kSteeper = 1e-6;  // than the verifier may know of
  const Pose beyond = backed(exit, exit.length_m);
  for (const Side& side : sides_) {
    const Aslant aslant_to = aslant(side, beyond, -exit.backing);
    if (aslant_to.flattest == 0) continue;
    // Both lead away from the side, and between is no place at which the machine is parallel to it.
    const double apart_m = std::abs(cross(other.pose.at - beyond.at, side.inwards));
    const double aside_m = aslant_to.aside_m + aslant(side, other.pose, -exit.backing).aside_m;
    if (apart_m > aside_m + kFarther_m) return false;
    // It heads for a side that the other leads away from, and is too near to.
    for (const NearSide& near : other.near) {
      const double skew = std::asin(std::min(1.0, std::abs(cross(side.inwards, near.inwards))));
      if (dot(side.inwards, near.inwards) < 0 && skew + kSteeper < aslant_to.flattest) return false;
    }
  }
  return true;
}

/// Ways that back farther along one of them, by whatever way from there.
double LeastBacking::least_beyond(const LineExit& left, const LineExit& entered, const OneStop& may) const {
  const double fastest_mps = std::max(terms_.turning.turning_speed_mps, terms_.turning.reverse_speed_mps);
  const auto seconds = [&](const LineExit& exit, const LineExit& other, const Pose& from, const Pose& to,
                           bool may_along, bool may_on) {
    const bool one_may_do = may_on ? !exit.whole || one_stop_may_do(exit, other) : !exit.whole && may_along;
    const int stops = std::max(may.least_stops, one_may_do ? 1 : 2);
    return stops * terms_.stop_s + (exit.behind_m + exit.length_m) / terms_.turning.reverse_speed_mps +
           reeds_shepp_length(from, to, terms_.radius_m) / fastest_mps -
           other.behind_m / terms_.turning.turning_speed_mps;
  };
  return std::min(
      seconds(left, entered, backed(left, left.length_m), entered.pose, may.out, may.out_and_on),
      seconds(entered, left, left.pose, backed(entered, entered.length_m), may.in, may.in_and_on));
}

double LeastBacking::between(const LineExits& left, const LineExits& entered, double known_s) const {
  const OneStop may = one_stop(left, entered);
  const double anyhow_s =
      least_behind_bends(left, entered, may.least_stops, least_of_lines(left, entered, {}, known_s));
  return may.all() ? anyhow_s : least_of_lines(left, entered, may, anyhow_s);
}

double LeastBacking::to_ring(const LineExits& exits, std::span<const SteeredPath> ring,
                             const LeastOnFrom& on_s, double known_s) const {
  const auto driven_to = [&](const SteeredPath& line) { return may_meet(*exits.reached->off, line); };
  if (!exits.reached || std::ranges::any_of(ring, driven_to)) return known_s;
  return std::max(known_s, least_backed_first_s(terms_, exits.whole, on_s));
}

double LeastBacking::least_of_lines(const LineExits& left, const LineExits& entered, const OneStop& may,
                                    double known_s) const {
  const double least_s = least_between(left.whole, entered.whole, may, known_s);
  if (!left.straight && !entered.straight) return least_s;
  return least_between(left.straight.value_or(left.whole), entered.straight.value_or(entered.whole), may,
                       least_s);
}

/// Any way, with the bends driven before it and behind it as far as it does not back round them, leads from
/// behind the one to behind the other, and stops as often.
double LeastBacking::least_behind_bends(const LineExits& left, const LineExits& entered, int least_stops,
                                        double known_s) const {
  if (!left.behind_bend && !entered.behind_bend) return known_s;
  OneStop may;
  may.least_stops = least_stops;
  return least_between(left.behind_bend.value_or(left.whole), entered.behind_bend.value_or(entered.whole),
                       may, known_s);
}

double LeastBacking::least_between(const LineExit& left, const LineExit& entered, const OneStop& may,
                                   double known_s) const {
  const Along along = on_strip(left, entered);
  const BackedWays ways(terms_, left, entered);
  if (may.all() && along == Along::kFree && !ways.loop() &&
      !needed_backing(left, entered, terms_.radius_m).back_m &&
      !needed_backing(entered, left, terms_.radius_m).back_m)
    return known_s;
  const double beyond_s = least_beyond(left, entered, may);
  if (beyond_s <= known_s) return known_s;
  return std::max(known_s, std::min(beyond_s, least_along(ways, left, entered, along, may)) - kDivided_s);
}

}  // namespace tramline
