// Plans real fields for machines, with settings and between gates that are drawn at random, writes each plan
// to a file, reads it back and verifies it.
//
//   machines_real COUNT [SEED [NUMBER]]
//
// COUNT of all fields, drawn with SEED, which is 1 without further word; or of these the one of this NUMBER
// alone, counted from 0. Prints for every field all that was drawn, before it is planned, and whether it was;
// and a summary. Exit code 1 where a plan does not hold, whose file is left in place and named.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <random>
#include <string>

#include "properties/draws.h"
#include "real/real_fields.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {
namespace {

namespace fs = std::filesystem;
using Random = std::mt19937_64;

/// Machines that would drive farther than this over a field are left to the sweeps of one machine, m; of
/// those that tow or take time to steer, whose ways take longest to find, those that would drive so far.
constexpr double kMostTracks_m = 12000, kMostTowed_m = 3000;
constexpr std::array kWidths_m = {1.5, 3.0, 4.5, 6.0, 9.0, 12.0, 18.0, 24.0, 36.0};

bool one_in(Random& random, int count) { return any_of(random, 1, count) == 1; }

template <std::size_t N>
double one_of(Random& random, const std::array<double, N>& choice) {
  return choice[static_cast<std::size_t>(any_of(random, 0, N - 1))];
}

Turning random_turning(Random& random) {
  Turning out;
  out.reverse = one_in(random, 4);
  if (one_in(random, 4)) {
    out.lift_m = uniform(random, 0, 3);
    out.lower_m = uniform(random, 0, 3);
  }
  if (one_in(random, 4)) out.implement_offset_m = uniform(random, -1.5, 4);
  if (one_in(random, 5)) {
    out.implement = Coupling::kTowed;
    out.drawbar_m = uniform(random, 2, 7);
  }
  if (one_in(random, 4)) {
    out.front_overhang_m = uniform(random, 1, 4);
    out.rear_overhang_m = uniform(random, 0, 2);
    out.vehicle_width_m = 2.5;
  }
  if (one_in(random, 6)) out.steering_time_s = uniform(random, 0.5, 2);
  return out;
}

Machine random_machine(Random& random, double area_m2) {
  Machine out;
  out.radius_m = one_of(random, std::array{0.0, 1.0, 2.0, 3.0, 5.0, 6.0, 8.0, 10.0, 12.0});
  out.turning = random_turning(random);
  const bool slow = out.turning.implement == Coupling::kTowed || out.turning.steering_time_s > 0;
  // The widest for fields that are too large for all of them.
  const double least_m = std::min(area_m2 / (slow ? kMostTowed_m : kMostTracks_m), kWidths_m.back());
  do out.width_m = one_of(random, kWidths_m);
  while (out.width_m < least_m);
  if (one_in(random, 8)) out.min_length_m = uniform(random, 0, 40);
  out.rates.operation = static_cast<Operation>(any_of(random, 0, static_cast<int>(Operation::kDrone)));
  return out;
}

/// Most as by default; the others as a user may set them.
PlanSettings random_settings(Random& random, const Field& field) {
  PlanSettings out;
  out.turns = one_in(random, 8) ? TurnPlanning::kTurns : TurnPlanning::kRoute;
  const bool whole = out.turns == TurnPlanning::kRoute && !one_in(random, 8);
  out.aim = whole ? Aim::kWholeCost : Aim::kCost;
  out.boundary = one_in(random, 3) ? EdgeKind::kSoft : EdgeKind::kHard;
  out.headland_rule = out.obstacle_headland_rule = HeadlandRule::kTurns;
  if (one_in(random, 4)) {
    out.headland_rule = HeadlandRule::kPasses;
    out.headlands = any_of(random, 0, 3);
  }
  if (one_in(random, 4)) {
    out.obstacle_headland_rule = HeadlandRule::kPasses;
    out.obstacle_headlands = any_of(random, 0, 2);
  }
  if (one_in(random, 3)) out.shape = one_in(random, 2) ? TrackShape::kCurved : TrackShape::kAuto;
  if (one_in(random, 5)) out.end_rule = static_cast<EndRule>(any_of(random, 0, 3));
  if (one_in(random, 6)) out.clearance_m = uniform(random, 0, 2);
  if (one_in(random, 6)) out.avoid = Avoidance::kCut;
  if (one_in(random, 6)) out.turn_room_m = uniform(random, 0, 10);
  if (out.turns != TurnPlanning::kRoute) return out;
  if (one_in(random, 5)) out.route.passes = PassTime::kFirst;
  const auto corner = [&] {
    return field.outer[static_cast<std::size_t>(any_of(random, 0, static_cast<int>(field.outer.size()) - 1))];
  };
  if (one_in(random, 4)) out.route.start = corner();
  if (one_in(random, 4)) out.route.end = corner();
  return out;
}

std::string words_of(const Machine& machine, const PlanSettings& settings) {
  const Turning& turning = machine.turning;
  return fmt::format(
      "w {:g} r {:g} {}{} offset {:g} drawbar {:g} lift {:g} lower {:g} vehicle {:g} {:g} {:g} steering {:g} "
      "least {:g}; {} {} {} headlands {} {} obstacles {} {} {} {} clearance {:g} {} room {:g} {}{}{}",
      machine.width_m, machine.radius_m, name(machine.rates.operation), turning.reverse ? " reversing" : "",
      turning.implement_offset_m, turning.drawbar_m, turning.lift_m, turning.lower_m,
      turning.front_overhang_m, turning.rear_overhang_m, turning.vehicle_width_m, turning.steering_time_s,
      machine.min_length_m, name(settings.aim), name(settings.turns), name(settings.boundary),
      name(settings.headland_rule), settings.headlands, name(settings.obstacle_headland_rule),
      settings.obstacle_headlands, name(settings.shape), name(settings.end_rule), settings.clearance_m,
      name(settings.avoid), settings.turn_room_m,
      settings.route.passes == PassTime::kFirst ? "passes first" : "passes last",
      settings.route.start ? " start" : "", settings.route.end ? " end" : "");
}

struct Fared {
  bool planned = false;
  bool faulty = false;
};

Fared plan_and_verify(const Field& field, int number, Random random) {
  const Machine machine = random_machine(random, area_m2(field));
  const PlanSettings settings = random_settings(random, field);
  const std::string file =
      (fs::temp_directory_path() / fmt::format("tramline-{}-{}.gpkg", ::getpid(), random())).string();
  // Before the plan, so that a field that takes long tells which one it is.
  fmt::print("  {}: {} {}\n", number, field.id, words_of(machine, settings));
  std::fflush(stdout);
  Fared out;
  std::vector<std::string> faults;
  try {
    const Plan plan = plan_field(field, machine, {}, settings, 1);
    out.planned = true;
    io::write_plan(plan, file);
    faults = faults_of_file(file, field);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::kBadInput)
      fmt::print("  {}\n", error.what());
    else
      add_failure(error, faults);
  }
  out.faulty = !faults.empty();
  fmt::print("  {}: {}\n", number, out.planned ? "planned" : "refused");
  print_faults(field, faults);
  std::error_code ignored;
  if (out.faulty)
    fmt::print("  {}\n", file);
  else
    fs::remove(file, ignored);
  std::fflush(stdout);
  return out;
}

int run(int count, unsigned seed, std::optional<int> only) {
  auto fields = read_all_real_fields();
  if (!fields) {
    fmt::print("{}\n", no_real_fields());
    return 0;
  }
  std::vector<RawFeature>& features = fields->dataset.layers.front().features;
  const std::vector<RawFeature> all = features;
  Random draw(seed);
  int planned = 0, faulty = 0;
  for (int number = 0; number < count; ++number) {
    const RawFeature& feature =
        all[static_cast<std::size_t>(any_of(draw, 0, static_cast<int>(all.size()) - 1))];
    const Random random(draw());
    if (only && number != *only) continue;
    features = {feature};
    for (const Fared& one : for_each_field(
             *fields, [&](const Field& field) { return plan_and_verify(field, number, random); })) {
      planned += one.planned ? 1 : 0;
      faulty += one.faulty ? 1 : 0;
    }
  }
  fmt::print("seed {}: {} of {} fields planned, {} faulty\n", seed, planned, count, faulty);
  return faulty == 0 ? 0 : 1;
}

}  // namespace
}  // namespace tramline::testing

int main(int count, char** words) {
  const int fields = count > 1 ? std::atoi(words[1]) : 0;
  if (fields <= 0) {
    std::fputs("machines_real COUNT [SEED [NUMBER]]\n", stderr);
    return 2;
  }
  const unsigned seed = count > 2 ? static_cast<unsigned>(std::atoi(words[2])) : 1;
  return tramline::testing::run(fields, seed, count > 3 ? std::optional(std::atoi(words[3])) : std::nullopt);
}
