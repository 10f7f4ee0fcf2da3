#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/edge_runs.h"
#include "tramline/check/measure/plan_facts.h"
#include "tramline/check/measure/sound_path.h"
#include "tramline/check/measure/swath_clearance.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The last metres before the end, seen along the heading there. No swath that lies flat turns by a right
/// angle on them.
SwathClearance end_clearance(const Path& path, double half_width_m) {
  const double part_m = 1.5 * half_width_m;
  const Path last = begun_later(path, std::max(0.0, length(path) - part_m));
  const Point end = last.back().to, along = direction_at_end(last.back());
  return {PieceFrame(end, end + along), last, half_width_m};
}

/// The swath of a headland pass as one or more swaths: a closed pass is one. An open one ends flat at both
/// ends, so its last metres there are swaths of their own. Precondition: the pass has no fault
/// (check_headland).
std::vector<SwathClearance> pass_clearances(const HeadlandPass& pass, double width_m) {
  assert(check::fault_of(pass.path).empty());
  const Path& path = pass.path;
  const double half_m = 0.5 * width_m;
  const auto as_a_whole = [&](const Path& part) {
    return SwathClearance(PieceFrame(part.front().from, part.front().to), part, half_m);
  };
  if (is_closed(pass)) return {as_a_whole(path)};
  std::vector<SwathClearance> out{end_clearance(path, half_m), end_clearance(reversed(path), half_m)};
  // The ends of the rest lie within the land of the pass.
  if (const Path middle = shortened(path, half_m); !middle.empty()) out.push_back(as_a_whole(middle));
  return out;
}

/// Places on a pass that are looked at.
constexpr double kLeastPlaces = 100;

/// Checks one pass against the boundaries of the field.
class PassCheck {
 public:
  PassCheck(const Case& c, std::size_t index, Violations& out)
      : c_(c),
        pass_(c.plan.headland.passes[index]),
        name_(pass_name(index)),
        clearances_(pass_clearances(pass_, c.plan.machine.width_m)),
        out_(out) {}

  void run() const {
    for (const SwathClearance& swath : clearances_)
      if (const auto point = swath.point_outside(c_.plan.field.outer)) {
        out_.push_back({Rule::kSwaths, name_ + " leaves the field", *point, 0});
        return;
      }
    const int all_round = passes_round_field(c_.plan);
    const double room_m = kept_m(all_round);
    check_distance(
        nearest([&](const SwathClearance& swath) { return swath.to_ring(c_.plan.field.outer, room_m); }),
        room_m, "the boundary");
    const auto& obstacles = c_.plan.field.obstacles;
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      if (obstacles[k].kind != ObstacleKind::kObstacle) continue;
      const double kept = kept_m(passes_round(c_.plan, k)) + c_.plan.settings.clearance_m;
      check_distance(nearest([&](const SwathClearance& swath) {
                       return intersects(c_.obstacle_boxes[k], swath.field_box(kept))
                                  ? swath.to_land(obstacles[k].shape, kept)
                                  : Approach{};
                     }),
                     kept, fmt::format("obstacle {}", k + 1));
    }
    if (pass_.around_field && pass_.number > all_round) check_beside_edges();
    if (is_closed(pass_)) check_sense();
  }

 private:
  template <class Approaching>
  Approach nearest(Approaching to) const {
    Approach out;
    for (const SwathClearance& swath : clearances_)
      if (const Approach found = to(swath); found.gap_m < out.gap_m) out = found;
    return out;
  }

  /// The distance between the swath and a boundary with this number of passes.
  double kept_m(int passes) const {
    return pass_.number > passes ? 0 : (pass_.number - 1) * c_.plan.machine.width_m;
  }

  /// The longest part of the pass that keeps its distance from the run, where what is before and behind it is
  /// no longer than a pass may go straight on; else all of it. A closed pass does not go straight on.
  Path part_beside(const EdgeRun& run, double distance_m) const {
    if (is_closed(pass_)) return pass_.path;
    const double width_m = c_.plan.machine.width_m, length_m = length(pass_.path);
    const double step_m = std::min(0.25 * width_m, length_m / kLeastPlaces);
    const double most_on_m = 2 * (pass_.number + 1) * width_m;
    double best_from_m = 0, best_to_m = 0, from_m = 0;
    bool keeps = false;
    for (double at_m = 0; at_m <= length_m; at_m += step_m) {
      const Point at = point_on(pass_.path, at_m);
      if (distance_from(run, straight_path(at, at)) < distance_m - kLengthTolerance_m) {
        keeps = false;
        continue;
      }
      if (!keeps) from_m = at_m;
      keeps = true;
      if (at_m - from_m <= best_to_m - best_from_m) continue;
      best_from_m = from_m;
      best_to_m = at_m;
    }
    const double rest_m = length_m - best_to_m;
    if (best_from_m > most_on_m + step_m || rest_m > most_on_m + step_m || best_to_m == best_from_m)
      return pass_.path;
    return reversed(begun_later(reversed(begun_later(pass_.path, best_from_m)), rest_m));
  }

  /// A pass along some edges of the field keeps its distance from one run of them, or from an obstacle it
  /// names. Near its ends it may go straight on towards the next of these edges, where passes before do not
  /// get.
  void check_beside_edges() const {
    const double width_m = c_.plan.machine.width_m, distance_m = (pass_.number - 0.5) * width_m;
    double nearer_m = std::numeric_limits<double>::infinity();
    const double beside_m = distance_m + least_radius_m(c_.plan.machine) + width_m;
    const auto keeps_off = [&](const EdgeRun& run) {
      const double found_m = distance_from(run, part_beside(run, distance_m));
      if (found_m > beside_m) return false;  // it follows another one
      nearer_m = std::min(nearer_m, distance_m - found_m);
      return found_m >= distance_m - kLengthTolerance_m;
    };
    for (const EdgeRun& run : edge_runs(c_.plan, pass_.number))
      if (keeps_off(run)) return;
    for (const std::size_t k : pass_.obstacles) {
      EdgeRun round = c_.plan.field.obstacles[k].shape.outer;
      round.push_back(round.front());
      if (keeps_off(round)) return;
    }
    if (!std::isfinite(nearer_m)) return;
    out_.push_back({Rule::kHeadland,
                    fmt::format("{} is number {} and comes {:.4f} m nearer to edges of the field than it may",
                                name_, pass_.number, nearer_m),
                    pass_.path.front().from, nearer_m});
  }

  void check_distance(const Approach& found, double kept_m, const std::string& of_what) const {
    if (found.gap_m >= kept_m - kLengthTolerance_m) return;
    if (found.gap_m < -kLengthTolerance_m)
      out_.push_back({Rule::kSwaths,
                      fmt::format("the swath of {} reaches {:.4f} m beyond {}", name_, -found.gap_m, of_what),
                      found.at, -found.gap_m});
    else
      out_.push_back({Rule::kHeadland,
                      fmt::format("{} is number {} and comes {:.4f} m nearer to {} than it may", name_,
                                  pass_.number, kept_m - found.gap_m, of_what),
                      found.at, kept_m - found.gap_m});
  }

  /// Round the field it runs counter-clockwise and has the obstacles it follows outside; clockwise it goes
  /// round obstacles.
  void check_sense() const {
    std::vector<Point> ring = chords(pass_.path, kSenseSagitta_m);
    ring.pop_back();
    const bool counter_clockwise = signed_area(ring) > 0;
    bool right = counter_clockwise || !pass_.around_field;
    for (const std::size_t k : pass_.obstacles) {
      const Ring& outer = c_.plan.field.obstacles[k].shape.outer;
      right = right && contains(ring, outer.front()) != counter_clockwise;
    }
    if (!right)
      out_.push_back(
          {Rule::kHeadland, name_ + " does not have the land on its left", pass_.path.front().from, 1});
  }

  const Case& c_;
  const HeadlandPass& pass_;
  std::string name_;
  std::vector<SwathClearance> clearances_;
  Violations& out_;
};

}  // namespace

void check_passes(const Case& c, Violations& out) {
  for (std::size_t i = 0; i < c.plan.headland.passes.size(); ++i) PassCheck(c, i, out).run();
}

}  // namespace tramline::check
