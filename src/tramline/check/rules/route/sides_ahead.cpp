#include "tramline/check/rules/route/sides_ahead.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tramline::check {
namespace {

/// Lines that lead away from a side by no more than this sine are parallel to it: what rounding does to them.
constexpr double kParallel = 1e-6;

/// What a way comes nearer to a side by that it heads for all along while it gets aside by `aside_m`, its
/// heading at first and last `leans` and `leans_to` to that side (rad): it is turned aside by as much as arcs
/// from both ends allow, to an angle that is found by halving.
double comes_nearer_m(double aside_m, double leans, double leans_to, double radius_m) {
  const auto aside_by_m = [&](double most) {
    return radius_m * (std::cos(leans) + std::cos(leans_to) - 2 * std::cos(most));
  };
  double less = std::max(std::abs(leans), std::abs(leans_to)), most = 0.5 * std::numbers::pi;
  if (aside_m <= aside_by_m(less)) return 0;
  if (aside_m >= aside_by_m(most)) less = most;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (less + most);
    (aside_by_m(middle) > aside_m ? most : less) = middle;
  }
  return std::max(0.0, radius_m * (2 * std::sin(less) - std::sin(leans) - std::sin(leans_to)));
}

Instead heading_all_along(const SideAhead& side, const WayEnd& end, const WayEnd& other, double nearer_m,
                          double radius_m) {
  const double arrives = dot(other.off, side.inwards) + other.turns;
  const double leaves = end.turns - dot(end.off, side.inwards);
  Instead out;
  out.together_m = out.here_m = out.there_m = nearer_m / std::max(arrives, leaves);
  if (std::max(end.turns, other.turns) > kTurnsByRounding) return out;
  // From where the way begins to where it ends, with one end backed by so much.
  const auto leads = [&](const WayEnd& backs, double by_m) {
    const Point here = (&backs == &end ? end.backed(by_m) : end.at).at,
                there = (&backs == &other ? other.backed(by_m) : other.at).at;
    return end.sense < 0 ? there - here : here - there;
  };
  const auto alone_m = [&](const WayEnd& backs, double gains) {
    const Point side_by_side{side.inwards.y, -side.inwards.x};
    const double least_m = dot(leads(backs, out.together_m), side_by_side),
                 most_m = dot(leads(backs, backs.follows_m), side_by_side);
    if (out.together_m > backs.follows_m || std::signbit(least_m) != std::signbit(most_m))
      return out.together_m;
    const Point aside = least_m < 0 ? -1 * side_by_side : side_by_side;
    const auto lean = [&](const WayEnd& of) {
      return std::asin(std::clamp(dot(of.at.heading.unit(), aside), -1.0, 1.0));
    };
    const double aside_m = std::min(std::abs(least_m), std::abs(most_m));
    return (nearer_m + comes_nearer_m(aside_m, lean(end), lean(other), radius_m)) / gains;
  };
  out.here_m = std::max(out.together_m, alone_m(end, leaves));
  out.there_m = std::max(out.together_m, alone_m(other, arrives));
  return out;
}

}  // namespace

Asked asked(const WayEnd& end, const WayEnd& other, double radius_m) {
  Asked out;
  for (const SideAhead& side : end.sides) {
    if (dot(other.off, side.inwards) + other.turns > kParallel) {
      const double nearer_m = dot(other.at.at - end.at.at, side.inwards);
      if (nearer_m <= 0) continue;
      const Instead ways = heading_all_along(side, end, other, nearer_m, radius_m);
      out.instead.together_m = std::min(out.instead.together_m, ways.together_m);
      out.instead.here_m = std::min(out.instead.here_m, ways.here_m);
      out.instead.there_m = std::min(out.instead.there_m, ways.there_m);
    }
    out.back_m = std::max(out.back_m.value_or(0), side.back_m);
  }
  return out;
}

}  // namespace tramline::check
