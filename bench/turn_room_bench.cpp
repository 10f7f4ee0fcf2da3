// What the look for room costs: one turn on land of 200 edges, index apart.

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "tramline/turns/room/allowed_land.h"

namespace tramline::bench {
namespace {

constexpr double kPi = std::numbers::pi;

/// About 20 ha round the origin: a winding border of 180 vertices, and five ponds of four.
Region land() {
  Polygon out;
  for (int i = 0; i < 180; ++i) {
    const double angle = i * kPi / 90;
    const double radius = 250 + 15 * std::sin(5 * angle) + 1.5 * std::sin(40 * angle);
    out.outer.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  for (int i = 0; i < 5; ++i) {
    const Point at = turned({120, 0}, i * 1.2);
    out.holes.push_back({at, at + Point{0, 5}, at + Point{5, 5}, at + Point{5, 0}});
  }
  return {out};
}

/// An omega from one track to the next, from `start`: three arcs.
SteeredPath omega(const Pose& start, double radius, double width) {
  const double out = std::acos((2 * radius + width) / (4 * radius)), k = 1 / radius;
  SteeredPath path = {arc_from(start, radius * out, -k, Gear::kForward)};
  path.push_back(arc_from(end_of(path.back()), radius * (kPi + 2 * out), k, Gear::kForward));
  path.push_back(arc_from(end_of(path.back()), radius * out, -k, Gear::kForward));
  return path;
}

/// The same with steering from one arc to the next along 4 m.
SteeredPath steered(const SteeredPath& path) {
  SteeredPath out;
  Pose at = path.front().start;
  double curvature = 0;
  for (const SteeredStretch& stretch : path) {
    out.push_back({at, 4, curvature, stretch.curvature_at_start, Gear::kForward});
    at = end_of(out.back());
    curvature = stretch.curvature_at_start;
    out.push_back(arc_from(at, std::max(0.0, stretch.length_m - 4), curvature, Gear::kForward));
    at = end_of(out.back());
  }
  return out;
}

enum class Place { kMiddle, kEdge, kBeyond };

Pose start_at(Place place) {
  const double x = place == Place::kMiddle ? 20 : place == Place::kEdge ? 229 : 236;
  return {{x, 0}, Heading::clockwise_from_north(Angle::degrees(90))};
}

Machine machine(Coupling coupling) {
  Machine out;
  out.width_m = 6;
  out.turning.implement = coupling;
  out.turning.implement_offset_m = 1.5;
  out.turning.drawbar_m = coupling == Coupling::kTowed ? 5 : 0;
  out.turning.rear_overhang_m = 1;
  out.turning.front_overhang_m = 3;
  out.turning.vehicle_width_m = 2.5;
  return out;
}

void look(benchmark::State& state, const SteeredPath& path, Coupling coupling) {
  const AllowedLand allowed(land());
  const Outline outline = outline_of(machine(coupling));
  bool fits = false;
  for (auto _ : state) benchmark::DoNotOptimize(fits = allowed.fits(path, outline));
  state.counters["fits"] = fits ? 1 : 0;
}

void omega_mounted(benchmark::State& state) {
  look(state, omega(start_at(static_cast<Place>(state.range(0))), 6, 6), Coupling::kMounted);
}
BENCHMARK(omega_mounted)->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond);

void omega_steered(benchmark::State& state) {
  look(state, steered(omega(start_at(static_cast<Place>(state.range(0))), 6, 6)), Coupling::kMounted);
}
BENCHMARK(omega_steered)->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond);

void omega_towed(benchmark::State& state) {
  look(state, omega(start_at(static_cast<Place>(state.range(0))), 6, 6), Coupling::kTowed);
}
BENCHMARK(omega_towed)->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond);

void building(benchmark::State& state) {
  const Region region = land();
  for (auto _ : state) benchmark::DoNotOptimize(AllowedLand(region));
}
BENCHMARK(building)->Unit(benchmark::kMicrosecond);

void missing(benchmark::State& state) {
  const AllowedLand allowed(land());
  const Outline outline = outline_of(machine(Coupling::kMounted));
  const SteeredPath path = omega(start_at(Place::kBeyond), 6, 6);
  double sum = 0;
  for (auto _ : state) sum += allowed.missing_m(path, outline);
  state.counters["missing_m"] = sum / static_cast<double>(state.iterations());
}
BENCHMARK(missing)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace tramline::bench
