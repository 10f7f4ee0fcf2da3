#include "tramline/check/rules/route/backed_ways.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "tramline/check/turning/shortest_ways.h"

namespace tramline::check {
namespace {

constexpr double kFoundTo_s = 0.02, kFoundToShare = 0.001;
constexpr double kSmallest_m = 0.01;
/// Where so many parts do not tell, as with speeds that no machine has, what they are known to take counts.
constexpr int kMostParts = 20000;

/// Distances backed, out of one line and into the other.
struct Distances {
  double out_m = 0, in_m = 0;
};
struct Range {
  Distances least, most;
  bool out = false, in = false;
  double together_m = 0;  ///< both at least
  int stops = 0;          ///< at least
  double at_least_s = 0;
};
struct Later {
  bool operator()(const Range& a, const Range& b) const { return a.at_least_s > b.at_least_s; }
};

/// The least of ways that back out and in by distances in some ranges, the most promising split first. Behind
/// a bend they have backed round it before they back, or drive forward from there over work that is no way.
struct Search {
  const WayCosts& costs;
  const WayEnd& from;
  const WayEnd& to;
  std::vector<TurnedRound> rounds = turned_round(from, to);
  std::priority_queue<Range, std::vector<Range>, Later> open{};
  double found_s = kNever_s;

  /// What is driven forward where all of the range backs so far at the most.
  double forward_m(const Range& range, const Distances& most) const {
    const bool bends = from.behind_m + to.behind_m > 0;
    const double lift_m = range.out || bends ? 0 : costs.turning.lift_m,
                 lower_m = range.in || bends ? 0 : costs.turning.lower_m;
    const Pose begins = moved_on(from.backed(most.out_m), lift_m),
               ends = moved_on(to.backed(most.in_m), -lower_m);
    double out_m = least_forward_m(begins, ends, costs.radius_m);
    for (const TurnedRound& round : rounds)
      if (most.out_m <= round.from.back_m && most.in_m <= round.to.back_m)
        out_m = std::max(out_m, round_m(round, begins, ends));
    return lift_m + lower_m + out_m;
  }

  /// As long as the turns at least, and as what is left to drive once they are driven, straight: the headings
  /// of turns at radius r add up to r times the difference of their normals.
  double round_m(const TurnedRound& round, const Pose& begins, const Pose& ends) const {
    // A turn of less than half a circle from one heading to another leads to where the difference of the
    // headings, turned by a quarter of a circle, does.
    const auto turn = [&](Point a, Point b) {
      const double sense = cross(a, b) >= 0 ? 1 : -1;
      const Point c = b - a;
      return costs.radius_m * sense * Point{c.y, -c.x};
    };
    const Point u = round.from.parallel;
    const Point turns = turn(from.off, u) + turn(-1 * u, -1 * to.off), leads = ends.at - begins.at;
    const Point half =
        2 * costs.radius_m * round.from.inwards;  // across, towards the land or towards the edge
    const double left_m = std::min(distance(leads, turns + half), distance(leads, turns - half));
    return costs.radius_m * (round.from.turned + round.to.turned + std::numbers::pi) + left_m;
  }

  double seconds(const Range& range, const Distances& at, double ahead_m) const {
    const int turns_back = range.out && range.in && ahead_m > 0 ? 2 : range.out || range.in ? 1 : 0;
    const int stops = std::max(range.stops, turns_back);
    const double bends_back_m = (range.out ? from.behind_m : 0) + (range.in ? to.behind_m : 0);
    const double bends_ahead_m = from.behind_m + to.behind_m - bends_back_m;
    return stops * costs.stop_s +
           (bends_back_m + std::max(at.out_m + at.in_m, range.together_m)) / costs.turning.reverse_speed_mps +
           (std::max(0.0, ahead_m) - bends_ahead_m) / costs.turning.turning_speed_mps;
  }

  /// Where it backed less far, the machine could come forward to from farther back.
  void push(Range range) {
    if (range.most.out_m + range.most.in_m < range.together_m) return;
    const double spans_m = range.most.out_m - range.least.out_m + range.most.in_m - range.least.in_m;
    const double farthest_m = forward_m(range, range.most);
    found_s = std::min(found_s, seconds(range, range.most, farthest_m));
    if (range.least.out_m + range.least.in_m >= range.together_m)
      found_s = std::min(found_s, seconds(range, range.least, forward_m(range, range.least)));
    range.at_least_s = seconds(range, range.least, farthest_m - spans_m);
    open.push(range);
  }

  void push_all(const BackedAsAsked& asked) {
    for (const bool out : {false, true})
      for (const bool in : {false, true}) {
        if ((asked.out_m && !out) || (asked.in_m && !in)) continue;
        // From behind a bend it may have backed round part of that alone.
        if (asked.stops > 0 && !out && !in && from.behind_m + to.behind_m == 0) continue;
        Range all;
        all.out = out;
        all.in = in;
        const double alone_m = out && !in ? asked.out_alone_m : in && !out ? asked.in_alone_m : 0;
        all.together_m = std::max(asked.together_m, alone_m);
        all.stops = asked.stops;
        if (out) all.least.out_m = asked.out_m.value_or(0), all.most.out_m = from.follows_m;
        if (in) all.least.in_m = asked.in_m.value_or(0), all.most.in_m = to.follows_m;
        if (all.least.out_m <= all.most.out_m && all.least.in_m <= all.most.in_m) push_split(all);
      }
  }

  /// Where there is room to turn the other way there are other ways: ranges of their own.
  void push_split(const Range& all) {
    for (const TurnedRound& round : rounds) {
      Range near = all, far = all;
      if (round.from.back_m > all.least.out_m && round.from.back_m < all.most.out_m)
        near.most.out_m = far.least.out_m = round.from.back_m;
      else if (round.to.back_m > all.least.in_m && round.to.back_m < all.most.in_m)
        near.most.in_m = far.least.in_m = round.to.back_m;
      else
        continue;
      push_split(near);
      push_split(far);
      return;
    }
    push(all);
  }

  double least_s(double known_s) {
    double out_s = found_s;
    for (int parts = 0; !open.empty() && parts < kMostParts; ++parts) {
      const Range range = open.top();
      open.pop();
      out_s = std::min(range.at_least_s, found_s);
      const double out_m = range.most.out_m - range.least.out_m, in_m = range.most.in_m - range.least.in_m;
      const double near_s = std::max(kFoundTo_s, kFoundToShare * found_s);
      if (out_s >= std::min(known_s, found_s - near_s) || std::max(out_m, in_m) < kSmallest_m) break;
      Range near = range, far = range;
      if (out_m > in_m)
        near.most.out_m = far.least.out_m = range.least.out_m + 0.5 * out_m;
      else
        near.most.in_m = far.least.in_m = range.least.in_m + 0.5 * in_m;
      push(near);
      push(far);
    }
    return out_s;
  }
};

}  // namespace

Pose WayEnd::backed(double by_m) const {
  return pose_of(course->line().place(from_m + sense * (behind_m + by_m)));
}

std::vector<TurnedRound> turned_round(const WayEnd& from, const WayEnd& to) {
  std::vector<TurnedRound> out;
  for (const SideBeside& one : from.beside)
    for (const SideBeside& other : to.beside) {
      const bool same_heading = one.inwards == other.inwards && dot(one.parallel, other.parallel) > 0;
      if (same_heading && one.turned + other.turned > 0) out.push_back({one, other});
    }
  return out;
}

double least_backed_s(const WayCosts& costs, const WayEnd& from, const WayEnd& to,
                      const std::vector<BackedAsAsked>& ways, double known_s) {
  Search search{costs, from, to};
  for (const BackedAsAsked& asked : ways) search.push_all(asked);
  return search.least_s(known_s);
}

/// The most promising of equal parts is halved first.
double least_backed_first_s(const WayCosts& costs, const WayEnd& end,
                            const std::function<double(const Pose&)>& on_s) {
  const auto back_s = [&](double by_m) { return by_m / costs.turning.reverse_speed_mps; };
  struct Stretch {
    double near_m = 0, far_m = 0, at_least_s = 0;
    bool operator<(const Stretch& other) const { return at_least_s > other.at_least_s; }
  };
  std::priority_queue<Stretch> open;
  double found_s = on_s(end.at);
  const auto push = [&](double near_m, double far_m) {
    const double from_far_s = on_s(end.backed(far_m));
    found_s = std::min(found_s, back_s(far_m) + from_far_s);
    open.push(
        {near_m, far_m, back_s(near_m) + from_far_s - (far_m - near_m) / costs.turning.turning_speed_mps});
    return from_far_s;
  };
  // From where the line is no longer followed the way may go on in reverse, without another stop.
  const double beyond_s = back_s(end.follows_m) + std::max(0.0, push(0, end.follows_m) - costs.stop_s);
  double out_s = found_s;
  for (int parts = 0; parts < kMostParts; ++parts) {
    const Stretch all = open.top();
    open.pop();
    out_s = std::min(all.at_least_s, found_s);
    const bool found = out_s >= found_s - std::max(kFoundTo_s, kFoundToShare * found_s);
    if (found || all.far_m - all.near_m < kSmallest_m) break;
    const double middle_m = 0.5 * (all.near_m + all.far_m);
    push(all.near_m, middle_m);
    push(middle_m, all.far_m);
  }
  return costs.stop_s + std::min(out_s, beyond_s);
}

}  // namespace tramline::check
