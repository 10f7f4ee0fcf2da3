#include "tramline/check/measure/plan_facts.h"

#include <fmt/format.h>

#include <algorithm>

namespace tramline::check {

double least_radius_m(const Machine& machine) { return std::max(machine.radius_m, 0.5 * machine.width_m); }

std::string piece_name(std::size_t index) { return fmt::format("piece {}", index + 1); }

std::string pass_name(std::size_t index) { return fmt::format("headland pass {}", index + 1); }

std::string detour_name(std::size_t piece, std::size_t detour) {
  return fmt::format("detour {} of {}", detour + 1, piece_name(piece));
}

bool exist(const Plan& plan, const std::vector<std::size_t>& obstacles) {
  const std::size_t count = plan.field.obstacles.size();
  return std::all_of(obstacles.begin(), obstacles.end(), [count](std::size_t i) { return i < count; });
}

int passes_round(const Plan& plan, std::size_t obstacle) {
  const std::vector<int>& passes = plan.headland.obstacle_passes;
  return obstacle < passes.size() ? passes[obstacle] : 0;
}

bool follows_curve(const Plan& plan, std::size_t subfield) {
  if (subfield < plan.subfields.size() &&
      std::any_of(plan.subfields[subfield].reference.begin(), plan.subfields[subfield].reference.end(),
                  [](const PathSegment& segment) { return !segment.straight(); }))
    return true;
  return std::any_of(plan.pieces.begin(), plan.pieces.end(), [subfield](const TrackPiece& piece) {
    return piece.subfield == subfield && !piece.curve.empty();
  });
}

Point point_on_largest(const Region& region) {
  const auto largest = std::max_element(region.begin(), region.end(),
                                        [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
  return largest == region.end() ? Point{} : largest->outer.front();
}

}  // namespace tramline::check
