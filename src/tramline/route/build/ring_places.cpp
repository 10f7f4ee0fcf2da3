#include "tramline/route/build/ring_places.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "tramline/route/passes/pass_entries.h"

namespace tramline {
namespace {

constexpr double kMostPlaces = 1000, kPerMetre = 2;
/// Lengths that are whole metres but for rounding have places for these alone.
constexpr double kRounding_m = 1e-3;
constexpr double kFar = std::numeric_limits<double>::infinity();

/// The least of `known` and the values of places. `crude` is at most as large as `value`; from one place to
/// the next neither falls by more than `most_fall`.
template <typename Crude, typename Value>
double least_of_places(std::size_t places, double most_fall, double known, Crude crude, Value value) {
  for (std::size_t i = 0; i < places;) {
    double here = crude(i);
    if (here < known) here = value(i, known);
    known = std::min(known, here);
    if (here == kFar) break;
    i += static_cast<std::size_t>((here - known) / most_fall) + 1;
  }
  return known;
}

/// The place of the least crude value: what is found there rules out most others.
template <typename Crude>
std::size_t nearest_place(std::size_t places, double most_fall, Crude crude) {
  std::size_t best = 0;
  double least = kFar;
  for (std::size_t i = 0; i < places;) {
    const double here = crude(i);
    if (here < least) {
      least = here;
      best = i;
    }
    i += static_cast<std::size_t>((here - least) / most_fall) + 1;
  }
  return best;
}

/// Every other place of a ring: near enough for distances, of which there are many.
struct EveryOther {
  explicit EveryOther(const RingPlaces& of)
      : ring(of),
        count((of.senses[0].size() + each - 1) / each),
        step_m(static_cast<double>(each) * of.step_m) {}
  Point place(std::size_t i) const { return ring.senses[0][i * each].at; }

  static constexpr std::size_t each = 2;
  const RingPlaces& ring;
  std::size_t count;
  double step_m;
};

double fall_s(const RingPlaces& ring, const LeastSeconds& least) {
  return ring.step_m / least.turning_speed_mps();
}

double crude_s(const Pose& from, const Pose& to, const LeastSeconds& least) {
  return distance(from.at, to.at) / least.fastest_mps();
}

double least_from_ring_to_ring(const RingPlaces& one, const RingPlaces& other, const LeastSeconds& least) {
  double out = kFar;
  for (const std::vector<Pose>& places : one.senses)
    for (const std::vector<Pose>& others : other.senses) {
      const auto reached = [&](std::size_t j) { return others[others.size() - 1 - j]; };
      out = least_of_places(
          places.size(), fall_s(one, least), out,
          [&](std::size_t i) { return least_distance_m(other, places[i].at) / least.fastest_mps(); },
          [&](std::size_t i, double best_s) {
            return least_of_places(
                others.size(), fall_s(other, least), best_s,
                [&](std::size_t j) { return crude_s(places[i], reached(j), least); },
                [&](std::size_t j, double known_s) {
                  return least.between(places[i], 0, reached(j), 0, known_s);
                });
          });
    }
  return std::max(0.0, out - fall_s(one, least) - fall_s(other, least));
}

}  // namespace

RingPlaces ring_places(const HeadlandPass& pass, const Turning& turning) {
  assert(is_closed(pass));
  RingPlaces out;
  const double length_m = length(pass.path);
  const double places = std::clamp(std::ceil(kPerMetre * (length_m - kRounding_m)), 1.0, kMostPlaces);
  for (const PassEntry& entry : entries_of(pass, length_m / (places - 0.5), turning))
    out.senses[entry.sense == Sense::kAlong ? 0 : 1].push_back(entry.entered);
  out.lines = {steered(pass.path), steered(reversed(pass.path))};
  out.step_m = length_m / places;
  return out;
}

double least_from_ring(const RingPlaces& ring, const Pose& entered, double lower_m,
                       const LeastSeconds& least) {
  double out = kFar;
  for (const std::vector<Pose>& places : ring.senses) {
    const auto crude = [&](std::size_t i) { return crude_s(places[i], entered, least); };
    const auto value = [&](std::size_t i, double known_s) {
      return least.between(places[i], 0, entered, lower_m, known_s);
    };
    out = std::min(out, value(nearest_place(places.size(), fall_s(ring, least), crude), out));
    out = least_of_places(places.size(), fall_s(ring, least), out, crude, value);
  }
  return std::max(0.0, out - fall_s(ring, least));
}

// The way to a place is a step longer at most than that to the one before: they are looked at backwards.
double least_to_ring(const Pose& left, double lift_m, const RingPlaces& ring, const LeastSeconds& least) {
  double out = kFar;
  for (const std::vector<Pose>& places : ring.senses) {
    const auto place = [&](std::size_t i) { return places[places.size() - 1 - i]; };
    const auto crude = [&](std::size_t i) { return crude_s(left, place(i), least); };
    const auto value = [&](std::size_t i, double known_s) {
      return least.between(left, lift_m, place(i), 0, known_s);
    };
    out = std::min(out, value(nearest_place(places.size(), fall_s(ring, least), crude), out));
    out = least_of_places(places.size(), fall_s(ring, least), out, crude, value);
  }
  return std::max(0.0, out - fall_s(ring, least));
}

double least_between_rings(const RingPlaces& one, const RingPlaces& other, const LeastSeconds& least) {
  return std::min(least_from_ring_to_ring(one, other, least), least_from_ring_to_ring(other, one, least));
}

double least_distance_m(const RingPlaces& ring, Point p) {
  const EveryOther some(ring);
  const auto from_p = [&](std::size_t i) { return distance(p, some.place(i)); };
  const double least_m = least_of_places(some.count, some.step_m, kFar, from_p,
                                         [&](std::size_t i, double) { return from_p(i); });
  return std::max(0.0, least_m - some.step_m);
}

double least_distance_m(const RingPlaces& one, const RingPlaces& other) {
  const EveryOther some(one);
  const auto from_place = [&](std::size_t i) { return least_distance_m(other, some.place(i)); };
  const double least_m = least_of_places(some.count, some.step_m, kFar, from_place,
                                         [&](std::size_t i, double) { return from_place(i); });
  return std::max(0.0, least_m - some.step_m);
}

}  // namespace tramline
