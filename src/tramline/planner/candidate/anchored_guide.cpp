#include "tramline/planner/candidate/anchored_guide.h"

#include <cassert>

#include "tramline/tracks/envelope_side.h"

namespace tramline {

std::vector<Point> anchored_guide(const SearchTask& task) {
  const std::vector<Point>& guide = task.settings.guide;
  if (anchor_of(task.settings) != AbAnchor::kEnvelope) return guide;
  assert(guide.size() == 2 && !task.ground.plannable.empty());
  const auto [from, to] = envelope_side(guide.front(), guide.back(), task.ground.plannable);
  return {from, to};
}

}  // namespace tramline
