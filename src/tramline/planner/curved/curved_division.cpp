#include "tramline/planner/curved/curved_division.h"

#include <limits>
#include <utility>

#include "tramline/planner/curved/best_curved.h"
#include "tramline/planner/search/merge_pairs.h"

namespace tramline {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

struct PricedGround {
  LinedSubfield ground;
  double price = kNone;
};

/// What the price of a subfield is above the cost of a plan with its tracks alone.
double price_beyond_cost(const SearchTask& task, const Polygon& shape) {
  const Objective& prices = task.objective;
  return prices.turn + prices.subfield - prices.uncovered * (task.body_m2 - area(shape));
}

/// The prices of subfields add up to the cost of a plan, except for land of one that swaths of another work
/// and for one turn: each counts its own missed land, a turn to it, and the price of a further subfield.
double price_of(const SearchTask& task, const Candidate& alone) {
  return alone.cost() + price_beyond_cost(task, alone.subfields.front().shape);
}

bool follows_curve(const PricedGround& one) { return !one.ground.subfield.reference.empty(); }

/// Infinite cost where no curve has a track, or all are certain to cost more than the price.
PricedGround along_curve(const SearchTask& task, const Polygon& shape, const SearchContext& context,
                         double no_more_than = kNone) {
  const std::optional<Candidate> best =
      best_along_own_edge(task, shape, context, no_more_than - price_beyond_cost(task, shape));
  if (!best) return {{{shape, {}, {}}, 0}};
  return {lined_subfields_of(*best).front(), price_of(task, *best)};
}

PricedGround best_alone(const SearchTask& task, const LinedSubfield& straight, OtherSubfields others,
                        const SearchContext& context) {
  if (others == OtherSubfields::kCurved) return along_curve(task, straight.subfield.shape, context);
  const double price = price_of(task, candidate_on(task, {straight}));
  PricedGround curved = along_curve(task, straight.subfield.shape, context, price);
  return price <= curved.price ? PricedGround{straight, price} : curved;
}

/// Joins neighbours along one curve where that costs less than the tracks of both.
std::vector<PricedGround> joined_along_curves(const SearchTask& task, std::vector<PricedGround> grounds,
                                              const SearchContext& context) {
  using Pair = MergedPair<PricedGround>;
  const auto look = [&](const std::vector<PricedGround>& among, const std::vector<IndexPair>& index_pairs) {
    std::vector<std::optional<Pair>> found;
    for (const IndexPair& pair : index_pairs) {
      if (context.has_to_end()) break;
      const PricedGround &a = among[pair.first], &b = among[pair.second];
      // A search that proves nothing passes over neighbours that are both cheaper straight.
      if (!context.wants_bound() && !follows_curve(a) && !follows_curve(b)) continue;
      const auto whole = merged_shape(a.ground.subfield.shape, b.ground.subfield.shape);
      if (!whole) continue;
      PricedGround one = along_curve(task, *whole, context, a.price + b.price);
      const double saved = a.price + b.price - one.price;
      if (saved > 0) found.emplace_back(Pair{pair, std::move(one), saved});
    }
    return found;
  };
  return merge_pairs(std::move(grounds), look);
}

/// Empty where no subfield follows a curve. Subfields without tracks of their own are joined to the largest
/// that has some.
std::vector<LinedSubfield> lined(const std::vector<PricedGround>& grounds) {
  const Subfield* largest = nullptr;
  for (const PricedGround& one : grounds) {
    const Subfield& subfield = one.ground.subfield;
    if (follows_curve(one) && (largest == nullptr || area(subfield.shape) > area(largest->shape)))
      largest = &subfield;
  }
  std::vector<LinedSubfield> out;
  if (largest == nullptr) return out;
  for (const PricedGround& one : grounds) {
    out.push_back(one.ground);
    if (one.price != kNone) continue;
    out.back().subfield.direction = largest->direction;
    out.back().subfield.reference = largest->reference;
  }
  return out;
}

std::optional<Candidate> divided_along_curves(const SearchTask& task,
                                              const std::vector<LinedSubfield>& division,
                                              OtherSubfields others, const SearchContext& context) {
  std::vector<PricedGround> alone;
  for (const LinedSubfield& straight : division) alone.push_back(best_alone(task, straight, others, context));
  const std::vector<LinedSubfield> lined_subfields =
      lined(joined_along_curves(task, std::move(alone), context));
  if (lined_subfields.empty()) return std::nullopt;
  context.report();
  return candidate_on(task, lined_subfields);
}

}  // namespace

std::optional<Candidate> best_division_along_curves(const SearchTask& task,
                                                    const std::vector<std::vector<LinedSubfield>>& divisions,
                                                    OtherSubfields others, const SearchContext& context) {
  std::optional<Candidate> best;
  for (const std::vector<LinedSubfield>& division : divisions) {
    // Undivided land has its curve already.
    if (division.size() < 2 || context.has_to_end()) continue;
    std::optional<Candidate> found = divided_along_curves(task, division, others, context);
    if (found && (!best || is_better(found->avoided, best->avoided))) best = std::move(found);
  }
  return best;
}

std::vector<LinedSubfield> hopeful_division(const SearchTask& task,
                                            const std::vector<SweptCandidate>& swept) {
  const SweptCandidate* best = nullptr;
  for (const SweptCandidate& one : swept)
    if (one.lined_subfields.size() > task.ground.plannable.size() &&
        (best == nullptr || one.outlook.soft < best->outlook.soft))
      best = &one;
  return best == nullptr ? std::vector<LinedSubfield>{} : best->lined_subfields;
}

}  // namespace tramline
