// Plans every curated real field with 0, 1 and 2 headland passes, with and without one round its obstacles,
// writes each plan to a file, reads it back and verifies it.
//
//   headland_plans WIDTH [PREFIX]
//
// Fields whose id begins with PREFIX alone, where it is given. Prints a line for every fault as it is found
// and a summary for each number of passes; exit code 1 where a plan does not hold. Fields without obstacles
// are not planned a second time for passes that they do not have.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "real/real_fields.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {
namespace {

namespace fs = std::filesystem;

enum class Fared { kLeftOut, kRefused, kHolds, kFails };

struct Passes {
  int headlands = 0;
  int round_obstacles = 0;
};

bool has_obstacles(const Field& field) {
  return std::any_of(field.obstacles.begin(), field.obstacles.end(),
                     [](const Obstacle& obstacle) { return obstacle.kind == ObstacleKind::kObstacle; });
}

/// A file of its own for each field, gone afterwards.
std::string scratch_file(const Field& field) {
  std::string name = fmt::format("tramline-{}-{}-{}.gpkg", ::getpid(), field.id, field.source.part);
  std::replace(name.begin(), name.end(), '/', '_');
  return (fs::temp_directory_path() / name).string();
}

Fared plan_and_verify(const Field& field, double width_m, Passes passes) {
  PlanSettings settings;
  settings.headlands = passes.headlands;
  settings.obstacle_headlands = passes.round_obstacles;
  const std::string file = scratch_file(field);
  std::vector<std::string> faults;
  try {
    io::write_plan(plan_field(field, {"", width_m, 6, -1}, {}, settings, 1), file);
    faults = faults_of_file(file, field);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::kBadInput) return Fared::kRefused;
    add_failure(error, faults);
  }
  std::error_code ignored;
  fs::remove(file, ignored);
  for (const std::string& fault : faults)
    fmt::print("  {} (w {:g} m, {} passes, {} round obstacles): {}\n", field.id, width_m, passes.headlands,
               passes.round_obstacles, fault);
  std::fflush(stdout);
  return faults.empty() ? Fared::kHolds : Fared::kFails;
}

int run(double width_m, const std::string& prefix) {
  const auto fields = read_or_say();
  if (!fields) return 0;
  std::ptrdiff_t failed = 0;
  for (const int headlands : {2, 1, 0})
    for (const int round_obstacles : {1, 0}) {
      const std::vector<Fared> fared = for_each_field(*fields, [&](const Field& field) {
        const bool same = round_obstacles > 0 && !has_obstacles(field);
        if (same || field.id.rfind(prefix, 0) != 0) return Fared::kLeftOut;
        return plan_and_verify(field, width_m, {headlands, round_obstacles});
      });
      const auto count = [&](Fared one) { return std::count(fared.begin(), fared.end(), one); };
      fmt::print("w {:g} m, {} headland passes, {} round obstacles: {} plans hold, {} fail, {} refused\n",
                 width_m, headlands, round_obstacles, count(Fared::kHolds), count(Fared::kFails),
                 count(Fared::kRefused));
      std::fflush(stdout);
      failed += count(Fared::kFails);
    }
  return failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace tramline::testing

int main(int count, char** words) {
  const double width_m = count > 1 ? std::atof(words[1]) : 0;
  if (width_m > 0) return tramline::testing::run(width_m, count > 2 ? words[2] : "");
  std::fprintf(stderr, "usage: headland_plans WIDTH [PREFIX]\n");
  return 2;
}
