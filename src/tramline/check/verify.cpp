#include "tramline/check/verify.h"

#include <fmt/format.h>

#include <algorithm>

#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/boolean.h"

namespace tramline::check {

Case::Case(const Plan& of)
    : plan(of),
      obstacles(boxed_obstacles(of.field, ObstacleKind::kObstacle)),
      passables(boxed_obstacles(of.field, ObstacleKind::kPassable)),
      given_up(boxed(of.given_up)),
      area_tolerance_m2(
          std::max(kAreaShare * area(Polygon{of.field.outer, {}}), kGridSize * perimeter(of.field.outer))) {
  for (const Obstacle& obstacle : of.field.obstacles) obstacle_boxes.push_back(bounds(obstacle.shape));
}

std::string piece_name(std::size_t index) { return fmt::format("piece {}", index + 1); }

std::string detour_name(std::size_t piece, std::size_t detour) {
  return fmt::format("detour {} of {}", detour + 1, piece_name(piece));
}

bool exist(const Plan& plan, const std::vector<int>& obstacles) {
  const auto count = static_cast<int>(plan.field.obstacles.size());
  return std::all_of(obstacles.begin(), obstacles.end(), [count](int i) { return i >= 0 && i < count; });
}

Point place_on_largest(const Region& region) {
  const auto largest = std::max_element(region.begin(), region.end(),
                                        [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
  return largest == region.end() ? Point{} : largest->outer.front();
}

Verdict verify(const Plan& plan) {
  Verdict verdict;
  check_shapes(plan, verdict.violations);
  check_pieces(plan, verdict.violations);
  if (!verdict.violations.empty()) return verdict;

  const Case c(plan);
  check_body(c, verdict.violations);
  check_subfields(c, verdict.violations);
  check_swaths(c, verdict.violations);
  check_clearance(c, verdict.violations);
  check_drivable(c, verdict.violations);
  check_ends(c, verdict.violations);
  check_length(c, verdict.violations);
  const int stops = check_stops(c, verdict.violations);
  check_crossings(c, verdict.violations);
  check_encounters(c, verdict.violations);
  check_meetings(c, verdict.violations);
  check_ways(c, verdict.violations);
  check_avoidance(c, verdict.violations);
  verdict.recomputed = check_tally(c, stops, verdict.violations);
  verdict.complete = true;
  return verdict;
}

}  // namespace tramline::check
