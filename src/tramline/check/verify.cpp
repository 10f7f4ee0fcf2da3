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
          std::max(kAreaShare * area(Polygon{of.field.outer, {}}), kGridSize * perimeter(of.field.outer))) {}

std::string piece_name(std::size_t index) { return fmt::format("piece {}", index + 1); }

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
  check_ends(c, verdict.violations);
  check_length(c, verdict.violations);
  const int stops = check_stops(c, verdict.violations);
  check_crossings(c, verdict.violations);
  verdict.recomputed = check_tally(c, stops, verdict.violations);
  verdict.complete = true;
  return verdict;
}

}  // namespace tramline::check
