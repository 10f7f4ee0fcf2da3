#include "commands/plan_run_input.h"

#include "tramline/io/plan/path_text.h"
#include "tramline/io/plan/plan_metadata.h"

namespace tramline::app {
namespace {

void append(const Polygon& polygon, std::string& out) {
  for (const Ring& ring : rings_of({polygon})) out += io::points_text(ring, {}) + '\n';
}

}  // namespace

std::string made_from_text(const Plan& plan, const std::string& wanted) {
  std::string out = std::string(TRAMLINE_VERSION) + '\n' + wanted + '\n';
  for (const auto& [key, value] : io::metadata_of(plan)) out += key + '=' + value + '\n';
  append({plan.field.outer, {}}, out);
  for (const Obstacle& obstacle : plan.field.obstacles) {
    out += obstacle.origin + (obstacle.kind == ObstacleKind::kPassable ? " passable\n" : "\n");
    append(obstacle.shape, out);
  }
  return out;
}

}  // namespace tramline::app
