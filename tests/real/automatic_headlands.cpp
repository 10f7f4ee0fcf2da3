// Plans every curated real field with headlands as its turns need them, writes each plan to a file, reads it
// back and verifies it; and looks for places where the machine leaves the land, by a road of its own.
//
//   automatic_headlands WIDTH RADIUS forward|reversing [PREFIX]
//
// Fields whose id begins with PREFIX alone, where it is given. Prints a line for every field with a fault,
// a stop or a turn without room, and a summary; exit code 1 where a plan does not hold or a turn that is said
// to fit leaves the land.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

#include "real/real_fields.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {
namespace {

namespace fs = std::filesystem;

/// Points are so far apart on the path and on the bar, and so far off the land they count, m.
constexpr double kApart_m = 0.05, kOff_m = 0.005;

using Edge = std::array<Point, 2>;

/// A ring, with those of its edges that are near a turn, and that a ray from there to the right may cross.
class RingNearby {
 public:
  RingNearby(const Ring& ring, const Box& reach) {
    const Box right{reach.min_x, reach.min_y, std::numeric_limits<double>::infinity(), reach.max_y};
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Edge edge{ring[i], ring[(i + 1) % ring.size()]};
      const Box box = bounds(edge[0], edge[1]);
      if (intersects(box, reach)) near_.push_back(edge);
      if (intersects(box, right)) right_.push_back(edge);
    }
  }

  /// Of a point within reach.
  bool inside(Point p) const {
    bool in = false;
    for (const auto& [a, b] : right_)
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    return in;
  }

  bool any_near() const { return !near_.empty(); }

  double distance_m(Point p) const {
    double out = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : near_) out = std::min(out, distance_to_segment(p, a, b));
    return out;
  }

 private:
  std::vector<Edge> near_, right_;
};

/// The places of the axle on a path and its direction there, in steps of the midpoint rule far shorter than
/// any radius.
template <class See>
void each_place(const SteeredPath& path, const See& see) {
  constexpr int kStepsBetween = 10;
  for (const SteeredStretch& stretch : path) {
    const double sense = stretch.gear == Gear::kForward ? 1 : -1;
    const int steps = kStepsBetween * std::max(1, static_cast<int>(std::ceil(stretch.length_m / kApart_m)));
    const double step_m = stretch.length_m / steps;
    Point at = stretch.start.at;
    double heading = std::atan2(stretch.start.heading.unit().y, stretch.start.heading.unit().x);
    for (int i = 0; i <= steps; ++i) {
      if (i % kStepsBetween == 0) see(at, Point{std::cos(heading), std::sin(heading)});
      const double share = (i + 0.5) / steps;
      const double curvature =
          stretch.curvature_at_start + share * (stretch.curvature_at_end - stretch.curvature_at_start);
      const double turned = sense * step_m * curvature;
      at = at + sense * step_m * Point{std::cos(heading + 0.5 * turned), std::sin(heading + 0.5 * turned)};
      heading += turned;
    }
  }
}

/// How far a bar of the working width at the axle leaves the field, or gets into its obstacles, on a turn, m.
double off_the_land_m(const Plan& plan, const PlannedTurn& turn) {
  const double half_m = 0.5 * plan.machine.width_m;
  Box reach;
  each_place(turn.manoeuvre.path, [&](Point at, Point) { reach.extend(at); });
  reach = reach.grown(half_m + 1);
  double off_m = 0;
  const auto look = [&](const Ring& ring, bool land_inside) {
    const RingNearby nearby(ring, reach);
    // Far from all edges every point is on the side of the first one.
    if (!nearby.any_near()) {
      if (nearby.inside(turn.manoeuvre.path.front().start.at) != land_inside) off_m = half_m;
      return;
    }
    each_place(turn.manoeuvre.path, [&](Point at, Point ahead) {
      const int points = 1 + static_cast<int>(std::ceil(plan.machine.width_m / kApart_m));
      for (int i = 0; i < points; ++i) {
        const Point p = at + (2.0 * i / (points - 1) - 1) * half_m * Point{-ahead.y, ahead.x};
        if (nearby.inside(p) != land_inside) off_m = std::max(off_m, nearby.distance_m(p));
      }
    });
  };
  look(plan.field.outer, true);
  for (const Obstacle& obstacle : plan.field.obstacles) look(obstacle.shape.outer, false);
  return off_m;
}

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
    if (turn.state == TurnState::kFits && !turn.manoeuvre.path.empty() && off_the_land_m(plan, turn) > kOff_m)
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
    faults.emplace_back(std::string("the run failed: ") + error.what());
  }
  std::error_code ignored;
  fs::remove(file, ignored);
  out.faults = static_cast<int>(faults.size());
  for (const std::string& fault : faults) fmt::print("  {}: {}\n", field.id, fault);
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
  const std::string_view gears = count > 3 ? words[3] : "";
  if (gears != "forward" && gears != "reversing") {
    std::fprintf(stderr, "usage: automatic_headlands WIDTH RADIUS forward|reversing [PREFIX]\n");
    return 2;
  }
  tramline::Machine machine{"", std::atof(words[1]), std::atof(words[2]), -1};
  machine.turning.reverse = gears == "reversing";
  return tramline::testing::run(machine, count > 4 ? words[4] : "");
}
