#include "tramline/planner/search/straight_search.h"

#include <cassert>

#include "tramline/planner/candidate/anchored_guide.h"
#include "tramline/planner/search/best_search.h"
#include "tramline/planner/search/sweep_search.h"

namespace tramline {

SearchResult straight_search(const SearchTask& task, const SearchContext& context, double no_more_than) {
  assert(task.settings.guide.empty() || task.settings.guide.size() == 2);
  if (area(task.ground.plannable) == 0) return {};
  context.report();
  if (!task.settings.guide.empty()) return guided_search(task);
  const auto search = task.settings.strategy == Strategy::kSweep ? sweep_search : best_search;
  return search(task, context, no_more_than);
}

SearchResult guided_search(const SearchTask& task) {
  const std::vector<Point> guide = anchored_guide(task);
  const Direction along = Direction::along(guide.front(), guide.back());
  const double origin_m = TrackFrame(along).to_track(guide.front()).x;
  std::vector<LinedSubfield> lined_subfields;
  for (const Polygon& part : task.ground.plannable) lined_subfields.push_back({{part, along}, origin_m});
  SearchResult out;
  out.best = candidate_on(task, lined_subfields);
  out.best.numbered_from_line_0 = true;
  out.directions_tried = 1;
  return out;
}

}  // namespace tramline
