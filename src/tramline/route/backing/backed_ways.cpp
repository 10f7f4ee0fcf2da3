#include "tramline/route/backing/backed_ways.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tramline/route/axle/axle_path.h"
#include "tramline/turns/manoeuvres/dubins.h"

namespace tramline {
namespace {

/// Where so many divisions do not tell, nothing is known.
constexpr int kMostDivided = 10000;
constexpr double kNoWay_s = std::numeric_limits<double>::infinity();

}  // namespace

double less_by_dividing_s(double found_s) { return std::max(kDivided_s, kDividedShare * found_s); }

Pose backed(const LineExit& exit, double by_m) {
  return exit.line.empty() ? exit.pose : pose_on(exit.line, by_m);
}

/// The sides along which a way turns to one heading at both ends. Where both ends are parallel to it that is
/// half a turn, of which Dubins knows.
BackedWays::BackedWays(const BackingTerms& terms, const LineExit& left, const LineExit& entered)
    : terms_(terms), left_(left), entered_(entered) {
  for (const OneWaySide& leaves : left.one_way)
    for (const OneWaySide& enters : entered.one_way)
      if (leaves.inwards == enters.inwards && dot(leaves.along, enters.along) > 0 &&
          leaves.angle + enters.angle > 0)
        loops_.push_back({leaves, enters});
}

/// The least length between ends that both turn to the same heading along a side. Measured from that heading
/// towards the side the machine turns from φ to 0 and to −π and then back by φ' of the other end, or from φ
/// to 0 and then on to π + φ'; any more turns come on top. A path through these headings θ is no shorter than
/// r Θ + |d − r V|, Θ being all it turns by, V the sum of the headings' unit vectors over that, and d where
/// it leads: its length is ∫(1 − p·h) ds + p·d for any p, of which for |p| ≤ 1 the first part is least where
/// it turns at radius r, and that is greatest for p along d − r V.
double BackedWays::loop_m(const Loop& loop, const Pose& from, const Pose& to) const {
  const Point u = loop.leaves.along, w = -1 * loop.leaves.inwards, leads = to.at - from.at;
  const double a = loop.leaves.angle, b = loop.enters.angle;
  const Point across = (std::sin(a) - std::sin(b)) * u;
  const Point away = across - (2 + std::cos(a) - std::cos(b)) * w;
  const Point towards = across + (2 - std::cos(a) + std::cos(b)) * w;
  return terms_.radius_m * (std::numbers::pi + a + b) +
         std::min(distance(leads, terms_.radius_m * away), distance(leads, terms_.radius_m * towards));
}

/// At the farther end of the distances backed, by no less anywhere between than as much longer as it backs
/// less: Dubins, or loops where it makes these all over the distances.
double BackedWays::forward_m(const Backed& backed_by) const {
  const double lift_m = behind_bends() || backed_by.out ? 0 : terms_.turning.lift_m,
               lower_m = behind_bends() || backed_by.in ? 0 : terms_.turning.lower_m;
  const Pose from = moved_on(backed(left_, backed_by.out_to), lift_m),
             to = moved_on(backed(entered_, backed_by.in_to), -lower_m);
  double out = dubins_length(from, to, terms_.radius_m);
  for (const Loop& loop : loops_)
    if (backed_by.out_to <= loop.leaves.back_m && backed_by.in_to <= loop.enters.back_m)
      out = std::max(out, loop_m(loop, from, to));
  return lift_m + lower_m + out;
}

/// Where it backs out and in and goes nowhere between it stops once.
double BackedWays::seconds(const Backed& all, double back_m, double forward_m) const {
  const bool both = all.out && all.in && forward_m > 0;
  const int stops = std::max(all.least_stops, all.out || all.in ? (both ? 2 : 1) : 0);
  return stops * terms_.stop_s + std::max(back_m, all.in_all) / terms_.turning.reverse_speed_mps +
         std::max(0.0, forward_m) / terms_.turning.turning_speed_mps + bend_s(left_, all.out) +
         bend_s(entered_, all.in);
}

/// What a way takes more than from behind the bend.
double BackedWays::bend_s(const LineExit& exit, bool backs) const {
  return backs ? exit.behind_m / terms_.turning.reverse_speed_mps
               : -exit.behind_m / terms_.turning.turning_speed_mps;
}

/// Parts of distances backed out and in, within each of which the same loops are made.
std::vector<BackedWays::Backed> BackedWays::parted(const Backed& all) const {
  std::vector<Backed> out{all};
  const auto part_at = [&](double Backed::*from_m, double Backed::*to_m, double at_m) {
    for (std::size_t i = 0, count = out.size(); i < count; ++i) {
      if (at_m <= out[i].*from_m || at_m >= out[i].*to_m) continue;
      Backed far = out[i];
      out[i].*to_m = far.*from_m = at_m;
      out.push_back(far);
    }
  };
  for (const Loop& loop : loops_) {
    part_at(&Backed::out_from, &Backed::out_to, loop.leaves.back_m);
    part_at(&Backed::in_from, &Backed::in_to, loop.enters.back_m);
  }
  return out;
}

/// By halving the distances backed (branch and bound). From farther back the machine could drive forward to
/// where it would have been, so the way from there is longer by no more than that.
double BackedWays::least_of(Backed all, double known_s) const {
  if (all.out_from > all.out_to || all.in_from > all.in_to) return kNoWay_s;
  double least_s = kNoWay_s, found_s = known_s + less_by_dividing_s(known_s);
  const auto try_at = [&](Backed part, double out_m, double in_m) {
    if (out_m + in_m < all.in_all) return;
    part.out_to = out_m;
    part.in_to = in_m;
    found_s = std::min(found_s, seconds(part, out_m + in_m, forward_m(part)));
  };
  const double least_in_all_m = std::max(all.in_all, all.out_from + all.in_from);
  const double out_first_m = std::min(all.out_to, least_in_all_m - all.in_from);
  if (least_in_all_m - out_first_m > all.in_to) return kNoWay_s;
  try_at(all, out_first_m, least_in_all_m - out_first_m);
  const double more_m =
      std::max(0.0, found_s - seconds(all, least_in_all_m, 0)) * terms_.turning.reverse_speed_mps;
  all.out_to = std::min(all.out_to, least_in_all_m - all.in_from + more_m);
  all.in_to = std::min(all.in_to, least_in_all_m - all.out_from + more_m);
  std::vector<Backed> open = parted(all);
  for (int divided = 0; !open.empty(); ++divided) {
    if (divided > kMostDivided) return 0;
    const Backed part = open.back();
    open.pop_back();
    if (part.out_to + part.in_to < part.in_all) continue;
    const double out_m = part.out_to - part.out_from, in_m = part.in_to - part.in_from;
    const double at_least_s = seconds(part, part.out_from + part.in_from, forward_m(part) - out_m - in_m);
    if (at_least_s >= found_s - less_by_dividing_s(found_s)) continue;
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
  return std::min(least_s, found_s - less_by_dividing_s(found_s));
}

double BackedWays::least_s(const AskedBacking& asked, double known_s) const {
  for (const bool out : {false, true})
    for (const bool in : {false, true}) {
      if ((asked.out_m && !out) || (asked.in_m && !in)) continue;
      // Behind a bend it may have backed along that alone.
      if (asked.least_stops > 0 && !out && !in && !behind_bends()) continue;
      Backed all;
      all.out = out;
      all.in = in;
      all.in_all = asked.in_all_m;
      all.least_stops = asked.least_stops;
      if (out != in) all.in_all = std::max(all.in_all, out ? asked.only_out_m : asked.only_in_m);
      if (out) all.out_from = asked.out_m.value_or(0), all.out_to = left_.length_m;
      if (in) all.in_from = asked.in_m.value_or(0), all.in_to = entered_.length_m;
      known_s = std::min(known_s, least_of(all, known_s));
    }
  return known_s;
}

}  // namespace tramline
