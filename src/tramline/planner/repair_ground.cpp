#include "tramline/planner/repair_ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tramline/headland/body.h"
#include "tramline/tracks/end_rule.h"

namespace tramline {
namespace {

double least_covered_m2(double ground_m2, double min_area_m2) {
  return std::max(kNoGround_m2, std::min(min_area_m2, ground_m2 - min_area_m2));
}

std::optional<GapChoice> best_of(const GapGround& part, const RepairGround& ground, GapEffort effort,
                                 double least_width_m) {
  return best_lines(part, gap_directions(part, ground.terms.machine.width_m, effort), ground.terms,
                    least_covered_m2(part.gaps_m2, ground.min_area_m2), least_width_m, ShortLines::kLeave);
}

}  // namespace

RepairGround repair_ground(const Field& field, const RepairTerms& terms, double min_area_m2) {
  RepairGround out{body_of(field), obstacle_shapes(field, ObstacleKind::kObstacle), terms, min_area_m2};
  for (Polygon& strip : obstacle_shapes(field, ObstacleKind::kPassable))
    out.obstacles.push_back(std::move(strip));
  for (Polygon& polygon : out.free) polygon = oriented(std::move(polygon));
  return out;
}

GapGround ground_of(Region region, const RepairGround& ground) {
  for (Polygon& polygon : region) polygon = oriented(std::move(polygon));
  return gap_ground(std::move(region), ground.free, ground.obstacles, ground.terms.machine.width_m);
}

std::optional<GapChoice> chosen_lines(const GapGround& part, const RepairGround& ground, GapEffort effort) {
  return best_of(part, ground, effort, kTail_m);
}

std::optional<GapChoice> lines_whatever_it_takes(const GapGround& part, const RepairGround& ground) {
  for (const double least_width_m : {kTail_m, kWidthTolerance})
    if (auto found = best_of(part, ground, GapEffort::kThorough, least_width_m)) return found;
  return std::nullopt;
}

std::string why_unreachable(const RepairGround& ground) {
  return fmt::format(
      "the machine cannot enter: no straight swath {:g} m wide that stays in the field and out of obstacles "
      "works as much of it as counts",
      ground.terms.machine.width_m);
}

Region sized(Region region, double least_m2) {
  std::erase_if(region, [&](const Polygon& polygon) { return area(polygon) < least_m2; });
  return region;
}

}  // namespace tramline
