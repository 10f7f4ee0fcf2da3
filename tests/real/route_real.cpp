// Plans the whole route over real fields, writes each plan to a file, reads it back and verifies it; and
// looks for places where the machine leaves the land, by a road of its own.
//
//   route_real WIDTH RADIUS KIND [curated|all[/EVERY[/FIRST]] [PASSES [PREFIX [DUMP]]]]
//
// The curated fields, or all of them; or every so many of them, from number FIRST on, counted from 0. PASSES:
// of the headlands of field and obstacles, or auto, which is the default. Fields whose id begins with PREFIX
// alone, where it is given. Prints a line for every field, and a summary; exit code 1 where a plan does not
// hold or a leg that is said to fit leaves the land. DUMP: a folder for the legs as text.

#include <fmt/format.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "real/real_fields.h"
#include "support/off_the_land.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {
namespace {

namespace fs = std::filesystem;

constexpr double kOff_m = 0.005;

/// The processor time of this thread, s: others may use the machine meanwhile.
double processor_s() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Fared {
  bool planned = false;
  std::size_t legs = 0, back_outs = 0, without_room = 0, outside = 0, faults = 0;
  double gap = 0, field_ha = 0, plan_s = 0;
  std::size_t corners = 0;
  bool plain = false;  ///< convex and without obstacles
};

bool is_convex(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
    if (cross(b - a, c - b) < 0) return false;
  }
  return true;
}

std::size_t corners_of(const Field& field) {
  std::size_t out = field.outer.size();
  for (const Obstacle& obstacle : field.obstacles) out += obstacle.shape.outer.size();
  return out;
}

std::string plain_name(const Field& field) {
  std::string name = fmt::format("{}-{}", field.id, field.source.part);
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

std::string scratch_file(const Field& field) {
  return (fs::temp_directory_path() / fmt::format("tramline-{}-{}.gpkg", ::getpid(), plain_name(field)))
      .string();
}

void print_line(std::ofstream& out, const char* kind, const std::vector<Point>& line) {
  out << kind;
  for (const Point p : line) out << fmt::format(" {:.3f},{:.3f}", p.x, p.y);
  out << "\n";
}

void dump(const Plan& plan, const std::string& folder) {
  std::ofstream out(fs::path(folder) / (plain_name(plan.field) + ".txt"));
  print_line(out, "field", plan.field.outer);
  for (const Obstacle& obstacle : plan.field.obstacles) print_line(out, "hole", obstacle.shape.outer);
  for (const RouteLeg& leg : plan.route.legs)
    if (!leg.path.empty())
      print_line(out,
                 fmt::format("{}{}{}", name(leg.kind), leg.gear == Gear::kReverse ? "-r" : "",
                             leg.missing_m > 0 ? "-x" : "")
                     .c_str(),
                 chords(trace(leg.path, 0.05), 0.05));
}

void look_at(const Plan& plan, Fared& out) {
  out.legs = plan.route.legs.size();
  for (const RouteLeg& leg : plan.route.legs) {
    if (leg.kind == LegKind::kBackOut) ++out.back_outs;
    if (lacks_room(leg, plan.machine)) ++out.without_room;
    if (leg.missing_m == 0 && !leg.work && !leg.path.empty() &&
        off_the_land_m(plan.field, plan.machine.width_m, leg.path) > kOff_m) {
      ++out.outside;
      fmt::print("  {}: a {} leg leaves the land by {:.3f} m\n", plan.field.id, name(leg.kind),
                 off_the_land_m(plan.field, plan.machine.width_m, leg.path));
    }
  }
  out.gap = gap(priced_time_s(plan.route), plan.route.proof.bound_s);
}

/// What is planned, of which fields, and where legs are written to.
struct Words {
  std::string fields = "curated";
  std::string passes = "auto";
  std::string prefix{};
  std::string folder{};
};

Fared plan_and_look(const Field& field, const Machine& machine, const Words& words) {
  const std::string& folder = words.folder;
  PlanSettings settings;
  if (words.passes == "auto")
    settings.headland_rule = settings.obstacle_headland_rule = HeadlandRule::kTurns;
  else
    settings.headlands = settings.obstacle_headlands = std::atoi(words.passes.c_str());
  settings.turns = TurnPlanning::kRoute;
  settings.aim = Aim::kWholeCost;
  Fared out;
  std::vector<std::string> faults;
  const std::string file = scratch_file(field);
  try {
    const double began_s = processor_s();
    const Plan plan = plan_field(field, machine, {}, settings, 1);
    out.plan_s = processor_s() - began_s;
    out.planned = true;
    out.field_ha = 1e-4 * area_m2(field);
    out.corners = corners_of(field);
    out.plain = field.obstacles.empty() && is_convex(field.outer);
    look_at(plan, out);
    if (!folder.empty()) dump(plan, folder);
    const RouteSums sums = sums_of(plan.route);
    fmt::print(
        "  {}: {} pieces, {} passes, {} legs, {:.0f} m working, {:.0f} m headland, {:.0f} m turning, {:.0f} "
        "m transit, {} back-outs, {} without room, gap {:.1f} %, {:.2f} €, {:.0f} ms\n",
        field.id, plan.pieces.size(), plan.headland.passes.size(), out.legs, sums.working_m, sums.headland_m,
        sums.turning_m, sums.transit_m, out.back_outs, out.without_room, 100 * out.gap,
        whole_cost(plan).euros(), 1000 * out.plan_s);
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
  out.faults = faults.size();
  print_faults(field, faults);
  std::fflush(stdout);
  return out;
}

/// The share of values that lie below it, from sorted ones.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void print_gaps(const char* what, const std::vector<double>& gaps) {
  fmt::print("gap of {} {}: median {:.2f} %, 95th of 100 {:.2f} %\n", gaps.size(), what,
             100 * quantile(gaps, 0.5), 100 * quantile(gaps, 0.95));
}

/// What stands between the slashes: "all/6/1" is all, 6 and 1.
std::vector<std::string> parts_of(const std::string& words) {
  std::vector<std::string> out(1);
  for (const char letter : words) {
    if (letter == '/')
      out.emplace_back();
    else
      out.back() += letter;
  }
  return out;
}

std::optional<RealFields> fields_of(const Words& words) {
  const std::vector<std::string> parts = parts_of(words.fields);
  std::optional<RealFields> out = parts.front() == "all" ? read_all_real_fields() : read_or_say();
  if (!out) {
    if (parts.front() == "all") fmt::print("{}\n", no_real_fields());
    return out;
  }
  const std::size_t every = parts.size() > 1 ? std::max(1, std::atoi(parts[1].c_str())) : 1;
  const std::size_t first = parts.size() > 2 ? std::max(0, std::atoi(parts[2].c_str())) : 0;
  std::vector<RawFeature>& features = out->dataset.layers.front().features;
  std::vector<RawFeature> chosen;
  for (std::size_t i = first; i < features.size(); i += every) chosen.push_back(std::move(features[i]));
  features = std::move(chosen);
  return out;
}

/// Of fields of at most 20 ha and 150 corners.
void print_times(const std::vector<Fared>& all) {
  std::vector<double> times_ms;
  for (const Fared& one : all)
    if (one.planned && one.field_ha <= 20 && one.corners <= 150) times_ms.push_back(1000 * one.plan_s);
  fmt::print("{} plans of at most 20 ha and 150 corners: median {:.0f} ms, 95th of 100 {:.0f} ms\n",
             times_ms.size(), quantile(times_ms, 0.5), quantile(times_ms, 0.95));
}

int run(const Machine& machine, const Words& words) {
  const auto fields = fields_of(words);
  if (!fields) return 0;
  const std::vector<Fared> all = for_each_field(*fields, [&](const Field& field) {
    return field.id.rfind(words.prefix, 0) == 0 ? plan_and_look(field, machine, words) : Fared{};
  });
  Fared sum;
  std::size_t planned = 0, faulty = 0, with_room = 0;
  std::vector<double> plain_gaps, other_gaps;
  for (const Fared& one : all) {
    if (!one.planned) continue;
    ++planned;
    faulty += one.faults > 0 ? 1 : 0;
    with_room += one.without_room == 0 ? 1 : 0;
    sum.legs += one.legs;
    sum.back_outs += one.back_outs;
    sum.without_room += one.without_room;
    sum.outside += one.outside;
    (one.plain ? plain_gaps : other_gaps).push_back(one.gap);
  }
  print_gaps("convex fields without obstacles", plain_gaps);
  print_gaps("other fields", other_gaps);
  print_times(all);
  fmt::print(
      "w {:g} m, r {:g} m{}: {} routes, {} faulty, {} with room everywhere; {} legs, {} back-outs, {} "
      "without room, {} outside the land\n",
      machine.width_m, machine.radius_m, machine.turning.reverse ? ", reversing" : "", planned, faulty,
      with_room, sum.legs, sum.back_outs, sum.without_room, sum.outside);
  return faulty == 0 && sum.outside == 0 ? 0 : 1;
}

}  // namespace
}  // namespace tramline::testing

int main(int count, char** words) {
  const auto machine = tramline::testing::machine_in_words(
      count, words, "route_real WIDTH RADIUS KIND [curated|all[/EVERY[/FIRST]] [PASSES [PREFIX [DUMP]]]]");
  if (!machine) return 2;
  return tramline::testing::run(*machine, {count > 4 ? words[4] : "curated", count > 5 ? words[5] : "auto",
                                           count > 6 ? words[6] : "", count > 7 ? words[7] : ""});
}
