#include "tramline/planner/search/sweep_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "tramline/decomposition/events.h"
#include "tramline/decomposition/sweep_directions.h"
#include "tramline/planner/for_each_index.h"

namespace tramline {
namespace {

/// The number of candidates whose detours are searched for in one batch, whatever the number of threads.
constexpr std::size_t kAtOnce = 8;

/// The number of candidates with the lowest outlook that are tried: with many edges and many obstacles most
/// candidates look alike until their detours are known. The best search tries the same ones, except those
/// that cannot be cheaper than its best plan. More are tried only while none of them has a track.
constexpr std::size_t kMostTried = 48;

/// The one construction of Versleijen takes so little time that every candidate has its detours.
std::size_t most_tried(const SearchTask& task, const std::vector<SweptCandidate>& swept) {
  return task.settings.avoid == Avoidance::kPaper ? swept.size() : kMostTried;
}

/// Where no corner splits the land, every direction leaves it whole.
bool is_cut_anywhere(const SearchTask& task) {
  const Region& ground = task.ground.plannable;
  return std::any_of(ground.begin(), ground.end(), [&](const Polygon& part) {
    return !split_events(part, task.settings.decomposition_threshold, task.short_edge_m).empty();
  });
}

SweptCandidate swept_ground(const SearchTask& task, Direction sweep) {
  SweptCandidate out{swept(task, sweep), {}};
  out.outlook = outlook_on(task, out.lined_subfields);
  return out;
}

/// The best outlook first.
std::vector<std::size_t> by_outlook(const std::vector<SweptCandidate>& swept) {
  std::vector<std::size_t> out(swept.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = i;
  std::stable_sort(out.begin(), out.end(), [&swept](std::size_t a, std::size_t b) {
    return swept[a].outlook.least < swept[b].outlook.least;
  });
  return out;
}

/// Puts the candidate of the least cost among the first ones, at the given rank, where it is behind it.
template <class Cost>
void bring_forward(std::vector<std::size_t>& order, std::size_t rank, const Cost& cost_of) {
  if (order.size() <= rank) return;
  std::vector<double> costs(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) costs[i] = cost_of(order[i]);
  const auto least = order.begin() + (std::min_element(costs.begin(), costs.end()) - costs.begin());
  const auto place = order.begin() + static_cast<std::ptrdiff_t>(rank);
  if (least > place) std::rotate(place, least, least + 1);
}

/// The candidates that are cheapest with all tracks cut and by the one rule of Versleijen are always among
/// those tried: otherwise a search for ways past obstacles could end in a more expensive plan than no search.
std::vector<std::size_t> order_of_trial(const SearchTask& task, const std::vector<SweptCandidate>& swept,
                                        double known) {
  constexpr std::size_t kBroughtForward = 2;
  std::vector<std::size_t> out = by_outlook(swept);
  bring_forward(out, kMostTried - kBroughtForward, [&](std::size_t i) { return swept[i].outlook.cut; });
  const bool meets_some = task.settings.avoid == Avoidance::kCheapest && !task.ground.hazards.empty();
  if (meets_some && swept.size() > kMostTried)
    bring_forward(out, kMostTried - kBroughtForward, [&](std::size_t i) {
      return swept[i].outlook.least <= known ? cost_by_rule(task, swept[i].lined_subfields)
                                             : std::numeric_limits<double>::infinity();
    });
  return out;
}

}  // namespace

std::vector<SweptCandidate> swept_candidates(const SearchTask& task, const SearchContext& context) {
  const std::vector<Direction> directions = sweep_directions(task.field);
  std::vector<SweptCandidate> out(directions.size());
  if (!directions.empty() && !is_cut_anywhere(task)) {
    std::fill(out.begin(), out.end(), swept_ground(task, directions.front()));
    context.count(static_cast<int>(out.size()), static_cast<int>(out.size()));
    return out;
  }
  std::mutex mutex;
  int done = 0;
  const std::vector<bool> made = for_each_index_until_end(directions.size(), context, [&](std::size_t i) {
    out[i] = swept_ground(task, directions[i]);
    const std::lock_guard lock(mutex);
    context.count(++done, static_cast<int>(directions.size()));
  });
  std::vector<SweptCandidate> kept;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (made[i]) kept.push_back(std::move(out[i]));
  return kept;
}

std::optional<Candidate> cheapest_swept(const SearchTask& task, const std::vector<SweptCandidate>& swept,
                                        double known, const SearchContext& context) {
  const std::vector<std::size_t> order = order_of_trial(task, swept, known);
  const std::size_t most = most_tried(task, swept);
  std::optional<Candidate> best;
  std::size_t best_index = 0;
  bool any_works = false;
  for (std::size_t first = 0; first < order.size() && (first < most || !any_works); first += kAtOnce) {
    const auto hopeful = [&](std::size_t rank) {
      return rank < order.size() && swept[order[rank]].outlook.least <= known;
    };
    std::vector<std::size_t> batch;
    for (std::size_t rank = first; rank < first + kAtOnce; ++rank)
      if (hopeful(rank)) batch.push_back(order[rank]);
    if (batch.empty() || (any_works && context.has_to_end())) break;
    std::vector<Candidate> candidates(batch.size());
    for_each_index(batch.size(), context, [&](std::size_t i) {
      candidates[i] = candidate_on(task, swept[batch[i]].lined_subfields);
    });
    for (std::size_t i = 0; i < batch.size(); ++i) {
      any_works = any_works || candidates[i].works();
      const bool as_cheap = best && candidates[i].cost() == known && batch[i] < best_index;
      if (!candidates[i].works() || (candidates[i].cost() >= known && !as_cheap)) continue;
      best = std::move(candidates[i]);
      known = best->cost();
      best_index = batch[i];
    }
  }
  return best;
}

SweepLimits sweep_limits(const SearchTask& task, const std::vector<SweptCandidate>& swept, double cost) {
  SweepLimits out;
  out.directions = static_cast<int>(candidate_directions(task.field).size());
  out.directions_left_out = out.directions - static_cast<int>(sweep_directions(task.field).size());
  const std::vector<std::size_t> order = by_outlook(swept);
  for (std::size_t rank = most_tried(task, swept); rank < order.size(); ++rank)
    out.without_detours += swept[order[rank]].outlook.least < cost ? 1 : 0;
  return out;
}

SearchResult sweep_search(const SearchTask& task, const SearchContext& context, double no_more_than) {
  SearchResult out;
  out.swept = swept_candidates(task, context);
  out.directions_tried = static_cast<int>(out.swept.size());
  if (auto best = cheapest_swept(task, out.swept, just_above(no_more_than), context))
    out.best = std::move(*best);
  if (out.best.works()) out.limits = sweep_limits(task, out.swept, out.best.cost());
  return out;
}

double just_above(double most) { return std::nextafter(most, std::numeric_limits<double>::infinity()); }

}  // namespace tramline
