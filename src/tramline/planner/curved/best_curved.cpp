#include "tramline/planner/curved/best_curved.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <mutex>
#include <optional>

#include "tramline/planner/candidate/parallel_tracks.h"
#include "tramline/planner/candidate/reference_chains.h"
#include "tramline/planner/curved/curved_candidate.h"
#include "tramline/planner/for_each_index.h"

namespace tramline {
namespace {

constexpr std::size_t kMostChains = 8;
constexpr std::size_t kMoved = 3;  ///< references that are tried in other places
constexpr int kPlacesOfFamily = 8;
constexpr std::size_t kDetoursTried = 3;  ///< families whose detours are looked for, by either order

/// A reference at one sideways offset, and the cost of its tracks.
struct TriedCurve {
  const Reference* reference = nullptr;
  double right_m = 0;
  Candidate candidate;
};

/// References along the boundary of a piece of land.
std::vector<Reference> references_of(const SearchTask& task, const Region& ground,
                                     const SearchContext& context) {
  const double width_m = task.machine.width_m;
  const double corner_m = 2 * std::max(task.machine.radius_m, 0.5 * width_m);
  const double smoothing[] = {0.002 * width_m, 0.02 * width_m, 0.1 * width_m, 0.5 * width_m};
  const auto chains = reference_chains(ground, corner_m, 0.1 * width_m, kMostChains);
  std::vector<std::optional<Reference>> found(chains.size() * std::size(smoothing));
  for_each_index(found.size(), context, [&](std::size_t i) {
    found[i] =
        try_reference_along(task, chains[i / std::size(smoothing)], smoothing[i % std::size(smoothing)]);
  });
  std::vector<Reference> out;
  // Where a chain is smooth enough, less smoothing changes nothing.
  for (std::optional<Reference>& one : found)
    if (one && !(one->round && task.settings.tracks == TrackConstruction::kPaper) &&
        (out.empty() || one->path != out.back().path))
      out.push_back(std::move(*one));
  return out;
}

void sort_best_first(std::vector<TriedCurve>& tried) {
  std::stable_sort(tried.begin(), tried.end(), [](const TriedCurve& a, const TriedCurve& b) {
    return is_better(a.candidate.avoided, b.candidate.avoided);
  });
}

/// The cost with stops priced no higher than turns, as if most obstacles had a way round.
double soft_cost(const SearchTask& task, const Candidate& candidate) {
  Objective prices = task.objective;
  prices.stop = std::min(prices.stop, prices.turn);
  return cost(prices, candidate.avoided.tally);
}

/// The costs of the best few families so far, and, where detours may be looked for, what the best ones cost
/// if stops were cheap: a family that is certain to cost more need not be completed. A family abandoned
/// because of the last of these would not have been among them in any order.
class BestCosts {
 public:
  /// So many of them, none of which is more than what is known, and as many with cheap stops.
  explicit BestCosts(std::size_t count, double known = std::numeric_limits<double>::infinity(),
                     std::size_t soft_count = 0)
      : costs_(count, known), soft_costs_(soft_count, std::numeric_limits<double>::infinity()) {}

  CostLimits limits() {
    const std::lock_guard lock(mutex_);
    CostLimits out{costs_.back()};
    if (!soft_costs_.empty()) out.soft = soft_costs_.back();
    return out;
  }
  bool any() {
    const std::lock_guard lock(mutex_);
    return any_;
  }
  void offer(const SearchTask& task, const Candidate& candidate) {
    if (!candidate.works()) return;
    const std::lock_guard lock(mutex_);
    any_ = true;
    insert(candidate.cost(), costs_);
    if (!soft_costs_.empty()) insert(soft_cost(task, candidate), soft_costs_);
  }

 private:
  static void insert(double cost, std::vector<double>& costs) {
    costs.insert(std::upper_bound(costs.begin(), costs.end(), cost), cost);
    costs.pop_back();
  }

  std::mutex mutex_;
  std::vector<double> costs_;
  std::vector<double> soft_costs_;
  bool any_ = false;
};

/// Lays all of them and sorts them; those that are certain not to be among the best that `costs` holds may be
/// abandoned. A search that has to end stops once one of them works.
void try_all(const SearchTask& task, const Polygon& part, BestCosts& costs, std::vector<TriedCurve>& tried,
             const SearchContext& context) {
  const CurvedGround ground = curved_ground(task, part);
  for_each_index(tried.size(), context, [&](std::size_t i) {
    if (costs.any() && context.has_to_end()) return;
    const auto subfield = subfield_along(task, part, *tried[i].reference, tried[i].right_m);
    if (!subfield) return;
    tried[i].candidate = plain_candidate(task, ground, *subfield, costs.limits());
    costs.offer(task, tried[i].candidate);
  });
  sort_best_first(tried);
}

/// The families for which detours are worth a search: the cheapest as they are, and the cheapest of the rest
/// if stops were cheap. Precondition: sorted.
std::vector<TriedCurve> promising(const SearchTask& task, std::vector<TriedCurve> tried) {
  if (tried.size() > kDetoursTried)
    std::stable_sort(tried.begin() + kDetoursTried, tried.end(),
                     [&task](const TriedCurve& a, const TriedCurve& b) {
                       return soft_cost(task, a.candidate) < soft_cost(task, b.candidate);
                     });
  if (tried.size() > 2 * kDetoursTried) tried.erase(tried.begin() + 2 * kDetoursTried, tried.end());
  return tried;
}

/// The best curve for one part of the ground; nullopt where no track of any fits.
std::optional<TriedCurve> best_on(const SearchTask& task, const Polygon& part,
                                  const std::vector<Reference>& references, const SearchContext& context,
                                  double no_more_than) {
  std::vector<TriedCurve> all;
  for (const Reference& reference : references) {
    all.push_back({&reference, 0, {}});
    // The land lies to the left of a boundary. Moved out so far, the first swath covers all bends of the
    // boundary.
    if (reference.deviation_m > 0) all.push_back({&reference, reference.deviation_m, {}});
  }
  // With detours the cheapest ones may not be: those that promising() chooses have to be complete. Among
  // twice as many that cost least if stops are cheap, there are as many besides those that cost least.
  static_assert(kMoved <= kDetoursTried);
  const bool detours = asks_for_detours(task);
  BestCosts best_few(detours ? kDetoursTried : kMoved, kAnyCost, detours ? 2 * kDetoursTried : 0);
  try_all(task, part, best_few, all, context);
  if (all.empty()) return std::nullopt;
  std::vector<TriedCurve> moved;
  for (std::size_t i = 0; i < std::min(all.size(), kMoved); ++i)
    for (int k = 1; k < kPlacesOfFamily; ++k)
      moved.push_back({all[i].reference, all[i].right_m + task.machine.width_m * k / kPlacesOfFamily, {}});
  BestCosts best(1, no_more_than);
  best.offer(task, all.front().candidate);
  try_all(task, part, detours ? best_few : best, moved, context);
  all.insert(all.end(), std::make_move_iterator(moved.begin()), std::make_move_iterator(moved.end()));
  sort_best_first(all);
  std::erase_if(all, [](const TriedCurve& tried) { return !tried.candidate.works(); });
  if (all.empty()) return std::nullopt;
  if (!detours) return std::move(all.front());
  all = promising(task, std::move(all));
  for_each_index_until_end(all.size(), context, [&](std::size_t i) {
    all[i].candidate = candidate_on(task, lined_subfields_of(all[i].candidate));
  });
  sort_best_first(all);
  return std::move(all.front());
}

/// The cheaper of each part along its own curve and all parts along the curve of one of them: the land that
/// swaths work beyond their own part may decide.
Candidate best_together(const SearchTask& task, const std::vector<LinedSubfield>& lined_subfields,
                        const SearchContext& context) {
  context.report();
  Candidate best = candidate_on(task, lined_subfields);
  std::vector<Path> tried;
  for (const LinedSubfield& one : lined_subfields) {
    const Path& reference = one.subfield.reference;
    if (context.has_to_end() || std::find(tried.begin(), tried.end(), reference) != tried.end()) continue;
    tried.push_back(reference);
    std::vector<LinedSubfield> along = lined_subfields;
    for (LinedSubfield& ground : along) {
      ground.subfield.direction = one.subfield.direction;
      ground.subfield.reference = reference;
    }
    Candidate other = candidate_on(task, along);
    if (is_better(other.avoided, best.avoided)) best = std::move(other);
  }
  return best;
}

}  // namespace

std::optional<Candidate> best_along_own_edge(const SearchTask& task, const Polygon& ground,
                                             const SearchContext& context, double no_more_than) {
  std::optional<TriedCurve> best =
      best_on(task, ground, references_of(task, {ground}, context), context, no_more_than);
  if (!best) return std::nullopt;
  return std::move(best->candidate);
}

std::optional<BestCurve> best_curved(const SearchTask& task, const SearchContext& context,
                                     double no_more_than) {
  const std::vector<Reference> references = references_of(task, task.ground.plannable, context);
  const Region& parts = task.ground.plannable;
  const double known = parts.size() == 1 ? no_more_than : kAnyCost;
  std::vector<LinedSubfield> lined_subfields;
  BestCurve out;
  Subfield largest;
  double largest_m2 = 0;
  for (const Polygon& part : parts) {
    std::optional<TriedCurve> best = best_on(task, part, references, context, known);
    lined_subfields.push_back({best ? best->candidate.subfields.front() : Subfield{part, {}, {}}, 0});
    if (best && area(part) > largest_m2) {
      out.line = best->reference->line;
      largest = lined_subfields.back().subfield;
      largest_m2 = area(part);
    }
    if (best && parts.size() == 1) out.candidate = std::move(best->candidate);
  }
  if (largest_m2 == 0) return std::nullopt;
  // A part that no curve suits by itself follows the curve of the largest part.
  for (LinedSubfield& ground : lined_subfields)
    if (ground.subfield.reference.empty())
      ground.subfield = {ground.subfield.shape, largest.direction, largest.reference};
  if (parts.size() > 1) out.candidate = best_together(task, lined_subfields, context);
  return out;
}

}  // namespace tramline
