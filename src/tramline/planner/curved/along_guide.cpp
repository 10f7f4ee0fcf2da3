#include "tramline/planner/curved/along_guide.h"

#include <cassert>
#include <vector>

#include "tramline/planner/candidate/anchored_guide.h"
#include "tramline/planner/curved/curved_candidate.h"
#include "tramline/planner/curved/zhou_plan.h"

namespace tramline {

Candidate along_guide(const SearchTask& task) {
  const std::vector<Point>& guide = task.settings.guide;
  assert(!guide.empty());
  if (task.settings.tracks == TrackConstruction::kPaper) return zhou_plan_along(task, anchored_guide(task));
  const Reference reference = reference_along(task, guide, 0);
  std::vector<LinedSubfield> lined_subfields;
  for (const Polygon& part : task.ground.plannable) {
    const auto subfield = subfield_along(task, part, reference);
    assert(subfield);  // Unmoved, the reference keeps the radii it was smoothed to.
    lined_subfields.push_back({*subfield, 0});
  }
  return candidate_on(task, lined_subfields);
}

}  // namespace tramline
