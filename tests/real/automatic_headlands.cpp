// Plans every curated real field with headlands as its turns need them, writes each plan to a file, reads it
// back and verifies it; and looks for places where the machine leaves the land, by a road of its own.
//
//   automatic_headlands WIDTH RADIUS KIND [PREFIX]
//
// Fields whose id begins with PREFIX alone, where it is given. Prints a line for every field with a fault,
// a stop or a turn without room, and a summary; exit code 1 where a plan does not hold or a turn that is said
// to fit leaves the land.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "real/real_fields.h"
#include "support/off_the_land.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {
namespace {

namespace fs = std::filesystem;

/// So far off the land a place counts, m.
constexpr double kOff_m = 0.005;

struct Fared {
  bool planned = false;
  int turns = 0, stops = 0, without_room = 0, apart = 0, outside = 0, faults = 0;
  double missing_m = 0;
};

std::string scratch_file(const Field& field) {
  std::string name = fmt::format("tramline-{}-{}-{}.gpkg", ::getpid(), field.id, field.source.part);
  std::replace(name.begin(), name.end(), '/', '_');
  return (fs::temp_directory_path() / name).string();
}

void count_turns(const Plan& plan, Fared& out) {
  out.turns = plan.tally.turns;
  out.stops = plan.tally.stops;
  for (const PlannedTurn& turn : plan.turns) {
    if (turn.state == TurnState::kApart) ++out.apart;
    if (turn.state == TurnState::kNoRoom) {
      ++out.without_room;
      out.missing_m = std::max(out.missing_m, turn.missing_m);
    }
    if (turn.state == TurnState::kFits && !turn.manoeuvre.path.empty() &&
        off_the_land_m(plan.field, plan.machine.width_m, turn.manoeuvre.path) > kOff_m)
      ++out.outside;
  }
}

Fared plan_and_look(const Field& field, const Machine& machine) {
  PlanSettings settings;
  settings.headland_rule = settings.obstacle_headland_rule = HeadlandRule::kTurns;
  const std::string file = scratch_file(field);
  Fared out;
  std::vector<std::string> faults;
  try {
    const Plan plan = plan_field(field, machine, {}, settings, 1);
    out.planned = true;
    count_turns(plan, out);
    io::write_plan(plan, file);
    faults = faults_of_file(file, field);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::kBadInput) {
      fmt::print("  {}: {}\n", field.id, error.what());
      return out;
    }
    add_failure(error, faults);
  }
  std::error_code ignored;
  fs::remove(file, ignored);
  out.faults = static_cast<int>(faults.size());
  print_faults(field, faults);
  if (out.stops + out.without_room + out.outside > 0)
    fmt::print("  {}: {} turns, {} stops, {} without room (up to {:.1f} m missing), {} apart, {} outside\n",
               field.id, out.turns, out.stops, out.without_room, out.missing_m, out.apart, out.outside);
  std::fflush(stdout);
  return out;
}

int run(const Machine& machine, const std::string& prefix) {
  const auto fields = read_or_say();
  if (!fields) return 0;
  const std::vector<Fared> all = for_each_field(*fields, [&](const Field& field) {
    return field.id.rfind(prefix, 0) == 0 ? plan_and_look(field, machine) : Fared{};
  });
  Fared sum;
  int planned = 0, faulty = 0, with_room = 0;
  for (const Fared& one : all) {
    planned += one.planned ? 1 : 0;
    faulty += one.faults > 0 ? 1 : 0;
    with_room += one.planned && one.stops + one.without_room == 0 ? 1 : 0;
    sum.turns += one.turns;
    sum.stops += one.stops;
    sum.without_room += one.without_room;
    sum.apart += one.apart;
    sum.outside += one.outside;
  }
  fmt::print(
      "w {:g} m, r {:g} m{}: {} plans, {} faulty, {} with room everywhere; {} turns, {} stops ({:.2f} %), {} "
      "without room, {} apart, {} outside the land\n",
      machine.width_m, machine.radius_m, machine.turning.reverse ? ", reversing" : "", planned, faulty,
      with_room, sum.turns, sum.stops, 100.0 * sum.stops / std::max(1, sum.turns), sum.without_room,
      sum.apart, sum.outside);
  return faulty == 0 && sum.outside == 0 ? 0 : 1;
}

}  // namespace
}  // namespace tramline::testing

int main(int count, char** words) {
  const auto machine =
      tramline::testing::machine_in_words(count, words, "automatic_headlands WIDTH RADIUS KIND [PREFIX]");
  if (!machine) return 2;
  return tramline::testing::run(*machine, count > 4 ? words[4] : "");
}
