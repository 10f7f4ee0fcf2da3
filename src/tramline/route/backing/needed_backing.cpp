#include "tramline/route/backing/needed_backing.h"

#include <algorithm>
#include <cmath>

namespace tramline {
namespace {

/// Lines that are parallel to a side but for rounding lead away from it by no more than this sine: less than
/// the verifier takes for such.
constexpr double kLeadsAway = 1e-7;

/// Where the machine points when it leaves, or would point if it drove the way from its end.
Point outwards(const LineExit& exit) { return -exit.backing * exit.pose.heading.unit(); }

/// How far a way gets towards a side at the least while it heads for it all along and gets so far aside, m.
/// The sines are those of the headings at its ends, from straight at the side to where it gets. Over a length
/// it is turned aside nowhere by more than by arcs of radius r from both ends, and by no more than π/2: by
/// these it gets farthest aside, and towards the side least far.
double advances_m(double aside_m, double sine, double sine_to, double radius_m) {
  const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine)),
               cosine_to = std::sqrt(std::max(0.0, 1 - sine_to * sine_to));
  if (aside_m <= radius_m * std::abs(cosine - cosine_to)) return 0;
  const double flattest = std::max(0.0, 0.5 * (cosine + cosine_to - aside_m / radius_m));
  return std::max(0.0, radius_m * (2 * std::sqrt(1 - flattest * flattest) - sine - sine_to));
}

/// Of ways that head for a side near to one end, and lead away from it at neither.
HeadsAllAlong all_along(const NearSide& side, const LineExit& exit, const LineExit& other, double farther_m,
                        double radius_m) {
  const double own_towards = -dot(outwards(exit), side.inwards) + exit.bent;
  const double towards = dot(outwards(other), side.inwards) + other.bent;
  HeadsAllAlong out;
  out.in_all_m = out.here_only_m = out.there_only_m = farther_m / std::max(towards, own_towards);
  if (exit.bent > 0 || other.bent > 0) return out;
  constexpr double kLess_m = 1e-3;  // than the verifier may ask for
  const Point along = left_of(side.inwards);
  const double apart_m = (exit.backing < 0 ? 1 : -1) * dot(other.pose.at - exit.pose.at, along);
  const double sine = dot(exit.pose.heading.unit(), along), sine_to = dot(other.pose.heading.unit(), along);
  const auto only_m = [&](const LineExit& backing, double sine_of_it, double towards_of_it) {
    // How far aside the way gets from where it backs so far at the least, and at the most.
    const double from_m = apart_m + out.in_all_m * sine_of_it, to_m = apart_m + backing.length_m * sine_of_it;
    if (from_m * to_m <= 0) return out.in_all_m;
    const double sign = from_m > 0 ? 1 : -1, aside_m = std::min(std::abs(from_m), std::abs(to_m));
    const double least_m = advances_m(aside_m, sign * sine, sign * sine_to, radius_m) - kLess_m;
    return (farther_m + std::max(0.0, least_m)) / towards_of_it;
  };
  out.here_only_m = std::max(out.in_all_m, only_m(exit, sine, own_towards));
  out.there_only_m = std::max(out.in_all_m, only_m(other, sine_to, towards));
  return out;
}

}  // namespace

NeededBacking needed_backing(const LineExit& exit, const LineExit& other, double radius_m) {
  NeededBacking out;
  HeadsAllAlong& least = out.or_all_along;
  for (const NearSide& side : exit.near) {
    if (dot(outwards(other), side.inwards) + other.bent > kLeadsAway) {
      const double farther_m = dot(other.pose.at - exit.pose.at, side.inwards);
      if (farther_m <= 0) continue;
      const HeadsAllAlong ways = all_along(side, exit, other, farther_m, radius_m);
      least.in_all_m = std::min(least.in_all_m, ways.in_all_m);
      least.here_only_m = std::min(least.here_only_m, ways.here_only_m);
      least.there_only_m = std::min(least.there_only_m, ways.there_only_m);
    }
    out.back_m = std::max(out.back_m.value_or(0), side.back_m);
  }
  return out;
}

}  // namespace tramline
