#include "tramline/planner/pareto/dominance.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace tramline {
namespace {

bool no_worse(const Criteria& a, const Criteria& b) {
  return a.overlap_milli_m2 <= b.overlap_milli_m2 && a.uncovered_milli_m2 <= b.uncovered_milli_m2 &&
         a.turns <= b.turns && a.stops <= b.stops && a.further_subfields <= b.further_subfields;
}

bool comes_first(const Criteria& a, const Criteria& b) {
  return std::tie(a.overlap_milli_m2, a.uncovered_milli_m2, a.turns, a.stops, a.further_subfields) <
         std::tie(b.overlap_milli_m2, b.uncovered_milli_m2, b.turns, b.stops, b.further_subfields);
}

}  // namespace

Criteria criteria_of(const Tally& tally) {
  return {std::llround(1e3 * tally.overlap_m2), std::llround(1e3 * tally.uncovered_m2), tally.turns,
          tally.stops, further_subfields(tally)};
}

bool dominates(const Tally& a, const Tally& b) {
  return no_worse(criteria_of(a), criteria_of(b)) && criteria_of(a) != criteria_of(b);
}

std::vector<std::size_t> undominated(const std::vector<Tally>& tallies) {
  std::vector<Criteria> criteria;
  for (const Tally& tally : tallies) criteria.push_back(criteria_of(tally));
  std::vector<std::size_t> order(tallies.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return comes_first(criteria[a], criteria[b]); });
  // In this order nothing is dominated by what comes later.
  std::vector<std::size_t> kept;
  for (const std::size_t i : order)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](std::size_t k) { return no_worse(criteria[k], criteria[i]); }))
      kept.push_back(i);
  return kept;
}

}  // namespace tramline
