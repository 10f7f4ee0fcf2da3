// Plans every curated real field on one thread and says what each took and what came of it.
//
//   speed_real [--all 1] [--every N] [--width W] [--radius R] [--headlands N] [--curved 1] [--only ID]
//              [--repeat N] [--scenario N] [--prices OVERLAP,UNCOVERED,TURN,STOP,SUBFIELD] [--sweep 1]
//              [--obstacles 1] [--whole 1] [--prove 1] [--most HECTARES]
//
// --all 1: every field of the registers instead; --every N: each N-th only; --obstacles 1: those with
// obstacles only. --scenario: Versleijen's, as best_real has them. --sweep 1: Versleijen's search, with the
// thresholds of his comparisons. --whole 1: the plan that the program makes without further options, of which
// the cost is that of the whole route, in euros. --prove 1: prices on the ground. --most: no larger fields. A
// line for every field, tab-separated: id, hectares, corners, obstacles, processor time in ms, cost, bound,
// cost and bound of undivided plans, directions tried, and a sum over every number of the plan's tracks and
// of its route, so that two builds can be compared by `diff` but for the times. Fields are planned side by
// side, as best_real does; the last lines have the quantiles of groups of fields, and how many fields a
// second of processor time holds.

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "real/real_fields.h"
#include "real/spread.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {
namespace {

struct Request {
  double width_m = 6, radius_m = 6;
  int headlands = 0;
  bool curved = false;
  std::string only;
  int repeat = 1;
  bool all = false;
  int every = 1;
  Objective prices{};
  bool sweep = false;
  bool with_obstacles = false;
  bool whole = false;
  bool prove = false;
  double most_hectares = 1e9;
};

struct Timed {
  std::string row;
  double seconds = 0;
  double hectares = 0;
  std::size_t corners = 0, obstacles = 0;
};

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// FNV-1a over the bits of numbers.
class Sum {
 public:
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int i = 0; i < 64; i += 8) sum_ = (sum_ ^ ((bits >> i) & 0xff)) * 0x100000001b3;
  }
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325;
};

std::uint64_t sum_of(const Plan& plan) {
  Sum sum;
  for (const TrackPiece& piece : plan.pieces)
    for (const PathSegment& segment : centre_line(piece))
      for (const double value :
           {segment.from.x, segment.from.y, segment.to.x, segment.to.y, segment.curvature})
        sum.add(value);
  for (const Encounter& encounter : plan.encounters) {
    sum.add(static_cast<double>(encounter.chosen));
    sum.add(encounter.left.cost);
    sum.add(encounter.right.cost);
  }
  for (const RouteLeg& leg : plan.route.legs)
    for (const SteeredStretch& stretch : leg.path)
      for (const double value :
           {stretch.start.at.x, stretch.start.at.y, stretch.start.heading.angle().radians(), stretch.length_m,
            stretch.curvature_at_start, leg.time_s, leg.missing_m})
        sum.add(value);
  return sum.value();
}

std::size_t corners_of(const Field& field) {
  std::size_t sum = field.outer.size();
  for (const Obstacle& obstacle : field.obstacles) sum += obstacle.shape.outer.size();
  return sum;
}

Timed timed(const Field& field, const Request& request) {
  if (!request.only.empty() && field.id != request.only) return {};
  if (request.with_obstacles && field.obstacles.empty()) return {};
  Timed out;
  out.hectares = 1e-4 * area(Polygon{field.outer, {}});
  if (out.hectares > request.most_hectares) return {};
  out.corners = corners_of(field);
  out.obstacles = field.obstacles.size();
  PlanSettings settings;
  settings.headlands = request.headlands;
  settings.prove = request.prove;
  if (request.curved) settings.shape = TrackShape::kAuto;
  if (request.sweep) {
    settings.strategy = Strategy::kSweep;
    settings.merge_threshold = Angle::degrees(15);
    settings.decomposition_threshold = Angle::degrees(205);
  }
  if (request.whole) {
    settings.headland_rule = settings.obstacle_headland_rule = HeadlandRule::kTurns;
    settings.boundary = EdgeKind::kHard;
    settings.shape = TrackShape::kAuto;
    settings.turns = TurnPlanning::kRoute;
    settings.aim = Aim::kWholeCost;
  }
  const std::string head =
      fmt::format("{}\t{:.2f}\t{}\t{}", field.id, out.hectares, out.corners, out.obstacles);
  const double start = thread_seconds();
  try {
    Plan plan;
    for (int i = 0; i < request.repeat; ++i)
      plan = plan_field(field, {"", request.width_m, request.radius_m, -1}, request.prices, settings, 1);
    out.seconds = (thread_seconds() - start) / request.repeat;
    out.row = fmt::format("{}\t{:.1f}\t{:.17g}\t{:.17g}\t{:.17g}\t{:.17g}\t{}\t{:016x}", head,
                          1e3 * out.seconds, request.whole ? whole_cost(plan).euros() : plan.cost,
                          request.whole ? plan.route.proof.bound_s : plan.proof.bound,
                          plan.proof.one_direction_cost, plan.proof.one_direction_bound,
                          plan.directions_tried, sum_of(plan));
  } catch (const Error& error) {
    out.seconds = thread_seconds() - start;
    out.row = fmt::format("{}\t{:.1f}\t{}", head, 1e3 * out.seconds, error.what());
  }
  return out;
}

void keep_every(int step, std::vector<RawFeature>& features) {
  std::vector<RawFeature> kept;
  for (std::size_t i = 0; i < features.size(); i += static_cast<std::size_t>(step))
    kept.push_back(std::move(features[i]));
  features = std::move(kept);
}

/// Five numbers with commas between them.
Objective prices_in(const char* words) {
  Objective out;
  for (double* price : {&out.overlap, &out.uncovered, &out.turn, &out.stop, &out.subfield}) {
    char* end = nullptr;
    *price = std::strtod(words, &end);
    words = *end == ',' ? end + 1 : end;
  }
  return out;
}

template <class IsOne>
void print_group(const char* what, const std::vector<Timed>& all, const IsOne& is_one) {
  std::vector<double> ms;
  for (const Timed& one : all)
    if (!one.row.empty() && is_one(one)) ms.push_back(1e3 * one.seconds);
  if (!ms.empty())
    fmt::print("# {}: {} fields, median {:.1f} ms, nine tenths {:.1f}, most {:.1f}\n", what, ms.size(),
               median(ms), quantile(ms, 0.9), quantile(ms, 1));
}

void print_groups(const std::vector<Timed>& all) {
  const auto small = [](const Timed& one) { return one.hectares <= 20 && one.corners <= 150; };
  print_group("to 20 ha and 150 corners", all, small);
  print_group("all", all, [](const Timed&) { return true; });
  print_group("to 20 ha and 150 corners, no obstacle", all,
              [&](const Timed& one) { return small(one) && one.obstacles == 0; });
  print_group("to 20 ha and 150 corners, 1 to 3 obstacles", all,
              [&](const Timed& one) { return small(one) && one.obstacles >= 1 && one.obstacles <= 3; });
  print_group("to 20 ha and 150 corners, to 3 obstacles", all,
              [&](const Timed& one) { return small(one) && one.obstacles <= 3; });
  print_group("10 to 75 ha, 1 to 6 obstacles", all, [](const Timed& one) {
    return one.hectares >= 10 && one.hectares <= 75 && one.obstacles >= 1 && one.obstacles <= 6;
  });
}

int run(int argc, char** argv) {
  Request request;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string word = argv[i];
    if (word == "--width") request.width_m = std::atof(argv[i + 1]);
    if (word == "--radius") request.radius_m = std::atof(argv[i + 1]);
    if (word == "--headlands") request.headlands = std::atoi(argv[i + 1]);
    if (word == "--curved") request.curved = std::atoi(argv[i + 1]) != 0;
    if (word == "--all") request.all = std::atoi(argv[i + 1]) != 0;
    if (word == "--every") request.every = std::max(1, std::atoi(argv[i + 1]));
    if (word == "--only") request.only = argv[i + 1];
    if (word == "--repeat") request.repeat = std::atoi(argv[i + 1]);
    if (word == "--scenario") request.prices = scenario(std::atoi(argv[i + 1]));
    if (word == "--prices") request.prices = prices_in(argv[i + 1]);
    if (word == "--sweep") request.sweep = std::atoi(argv[i + 1]) != 0;
    if (word == "--whole") request.whole = std::atoi(argv[i + 1]) != 0;
    if (word == "--prove") request.prove = std::atoi(argv[i + 1]) != 0;
    if (word == "--most") request.most_hectares = std::atof(argv[i + 1]);
    if (word == "--obstacles") request.with_obstacles = std::atoi(argv[i + 1]) != 0;
  }
  auto fields = request.all ? read_all_real_fields() : read_real_fields();
  if (!fields) {
    fmt::print("{}\n", no_real_fields());
    return 0;
  }
  keep_every(request.every, fields->dataset.layers.front().features);
  const std::vector<Timed> all =
      for_each_field(*fields, [&](const Field& field) { return timed(field, request); });
  double seconds = 0;
  int count = 0;
  for (const Timed& one : all) {
    if (one.row.empty()) continue;
    fmt::print("{}\n", one.row);
    seconds += one.seconds;
    ++count;
  }
  print_groups(all);
  fmt::print("# {} fields in {:.2f} s of processor time: {:.1f} a second on one core\n", count, seconds,
             count / seconds);
  return 0;
}

}  // namespace
}  // namespace tramline::testing

int main(int argc, char** argv) { return tramline::testing::run(argc, argv); }
