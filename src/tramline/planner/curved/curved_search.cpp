#include "tramline/planner/curved/curved_search.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tramline/planner/curved/best_curved.h"
#include "tramline/planner/curved/curved_division.h"
#include "tramline/planner/curved/zhou_plan.h"
#include "tramline/planner/search/straight_search.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

bool same_shapes(const std::vector<LinedSubfield>& a, const std::vector<LinedSubfield>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const LinedSubfield& one, const LinedSubfield& other) {
                      return one.subfield.shape == other.subfield.shape;
                    });
}

std::vector<std::vector<LinedSubfield>> divisions_of(const SearchTask& task, const SearchResult& straight) {
  std::vector<std::vector<LinedSubfield>> out{lined_subfields_of(straight.best)};
  std::vector<LinedSubfield> swept = hopeful_division(task, straight.swept);
  if (!same_shapes(out.front(), swept)) out.push_back(std::move(swept));
  return out;
}

}  // namespace

bool costs_less(double divided, double whole) {
  return divided + kLeastSaving_share * std::abs(divided) < whole;
}

std::optional<Candidate> along_best_edge(const SearchTask& task, const SearchContext& context,
                                         double no_more_than) {
  if (task.settings.tracks == TrackConstruction::kPaper) return zhou_plan_along_best(task, context);
  if (std::optional<BestCurve> best = best_curved(task, context, no_more_than))
    return std::move(best->candidate);
  return std::nullopt;
}

std::optional<Candidate> curved_search(const SearchTask& task, const SearchContext& context) {
  std::optional<Candidate> whole = along_best_edge(task, context);
  if (!whole || task.settings.tracks == TrackConstruction::kPaper) return whole;
  const SearchResult straight = straight_search(task, context, whole->cost());
  std::optional<Candidate> divided =
      best_division_along_curves(task, divisions_of(task, straight), OtherSubfields::kCurved, context);
  // Subfields joined to the whole again equal it up to the rounding of boolean operations.
  return divided && costs_less(divided->cost(), whole->cost()) ? divided : whole;
}

std::optional<Candidate> mixed_search(const SearchTask& task, const SearchResult& straight,
                                      const SearchContext& context) {
  return best_division_along_curves(task, divisions_of(task, straight), OtherSubfields::kStraight, context);
}

}  // namespace tramline
