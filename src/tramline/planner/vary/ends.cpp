#include "tramline/planner/vary/ends.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

#include "tramline/planner/whole/shorter_ends.h"

namespace tramline {
namespace {

/// Ends are shortened in so many plans at the most.
constexpr std::size_t kShortenedIn = 6;

/// A plan, and what it is expected to cost at least with shorter ends, EUR.
struct ShorterHope {
  double at_least = 0;
  std::size_t plan = 0;
};

std::vector<ShorterHope> hopes_of_shorter_ends(const RouteComparison& plans) {
  std::vector<ShorterHope> out;
  for (std::size_t i = 0; i < plans.plans().size(); ++i) {
    const ComparedPlan& entry = plans.plans()[i];
    if (!entry.price || entry.only_told_of) continue;
    const double at_least = *entry.price - most_saved_by_shorter_ends(entry.laid.trial);
    if (at_least < *entry.price && at_least < plans.least_price()) out.push_back({at_least, i});
  }
  std::ranges::stable_sort(out, {}, &ShorterHope::at_least);
  if (out.size() > kShortenedIn) out.resize(kShortenedIn);
  return out;
}

/// What the plan is expected to cost with these ends, EUR.
double expected(const ComparedPlan& entry, const std::vector<ShorterEnds>& ends) {
  double out = *entry.price;
  for (const ShorterEnds& one : ends) out -= one.saved;
  return out;
}

void shorten_ends_of(ComparedPlan entry, RouteComparison& plans) {
  for (int i = 0; i < kTimesShortened && !plans.has_to_end(); ++i) {
    const std::vector<ShorterEnds> ends = ends_worth_shortening(entry.laid.trial);
    if (ends.empty() || expected(entry, ends) >= plans.least_price()) break;
    ComparedPlan shorter = entry;
    shorter.laid.trial = shortened(ends, std::move(shorter.laid.trial));
    plans.plan_route(shorter);
    if (*shorter.price >= *entry.price) break;
    plans.tell_of(shorter);
    entry = std::move(shorter);
  }
  if (*entry.price < plans.least_price()) plans.take(std::move(entry));
}

}  // namespace

void shorten_ends(RouteComparison& plans) {
  assert(plans.has_best());
  for (const ShorterHope& hope : hopes_of_shorter_ends(plans))
    if (!plans.has_to_end() && hope.at_least < plans.least_price())
      shorten_ends_of(ComparedPlan(plans.plans()[hope.plan]), plans);
}

}  // namespace tramline
