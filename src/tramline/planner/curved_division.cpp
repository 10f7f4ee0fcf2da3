#include "tramline/planner/curved_division.h"

#include <limits>
#include <map>
#include <utility>

#include "tramline/geometry/boolean.h"
#include "tramline/planner/best_curved.h"

namespace tramline {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

struct PricedGround {
  LinedSubfield ground;
  double price = kNone;
};

/// Prices of subfields add up to what a plan costs, but for what their swaths work of one another and one
/// turn: a subfield has its own land missed, a turn to it from another, and the price of a further one.
double price_of(const SearchTask& task, const Candidate& alone) {
  const Objective& prices = task.objective;
  const double missed_elsewhere_m2 = task.body_m2 - area(alone.subfields.front().shape);
  return alone.cost() - prices.uncovered * missed_elsewhere_m2 + prices.turn + prices.subfield;
}

PricedGround priced(const SearchTask& task, const Candidate& alone) {
  return {grounds_of(alone).front(), price_of(task, alone)};
}

/// Infinitely dear where no curve has a track.
PricedGround along_curve(const SearchTask& task, const Polygon& shape, const SearchContext& context) {
  const std::optional<Candidate> best = best_along_own_edge(task, shape, context);
  return best ? priced(task, *best) : PricedGround{{{shape, {}, {}}, 0}};
}

class Division {
 public:
  Division(const SearchTask& task, const SearchContext& context) : task_(task), context_(context) {}

  void add(const LinedSubfield& straight, OtherSubfields others) {
    PricedGround best = along_curve(task_, straight.subfield.shape, context_);
    if (others == OtherSubfields::kStraight) {
      const Candidate as_it_is = candidate_on(task_, {straight});
      if (price_of(task_, as_it_is) <= best.price) best = priced(task_, as_it_is);
    }
    parts_.push_back({next_++, std::move(best)});
  }

  /// The pair that saves most first.
  void join_where_it_pays() {
    while (!context_.has_to_end()) {
      std::size_t first = 0, second = 0;
      double most_saved = 0;
      for (std::size_t i = 0; i < parts_.size(); ++i)
        for (std::size_t j = i + 1; j < parts_.size(); ++j)
          if (const double saved = parts_[i].is.price + parts_[j].is.price - joined(i, j).price;
              saved > most_saved) {
            first = i;
            second = j;
            most_saved = saved;
          }
      if (second == 0) return;
      parts_[first] = {next_++, joined(first, second)};
      parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(second));
    }
  }

  /// Empty where no subfield follows a curve. Those that have no tracks of their own go with the largest that
  /// does.
  std::vector<LinedSubfield> grounds() const {
    const Subfield* largest = nullptr;
    for (const Part& part : parts_) {
      const Subfield& subfield = part.is.ground.subfield;
      if (!subfield.reference.empty() && (largest == nullptr || area(subfield.shape) > area(largest->shape)))
        largest = &subfield;
    }
    std::vector<LinedSubfield> out;
    if (largest == nullptr) return out;
    for (const Part& part : parts_) {
      out.push_back(part.is.ground);
      if (part.is.price != kNone) continue;
      out.back().subfield.direction = largest->direction;
      out.back().subfield.reference = largest->reference;
    }
    return out;
  }

 private:
  struct Part {
    int number = 0;  ///< its own
    PricedGround is;
  };

  /// Both along one curve; infinitely dear where they do not lie side by side.
  const PricedGround& joined(std::size_t i, std::size_t j) {
    const auto [known, is_new] = joined_.try_emplace({parts_[i].number, parts_[j].number});
    if (!is_new) return known->second;
    const Polygon &a = parts_[i].is.ground.subfield.shape, &b = parts_[j].is.ground.subfield.shape;
    if (!intersects(bounds(a), bounds(b))) return known->second;
    const Region both = unite({a, b});
    if (both.size() == 1) known->second = along_curve(task_, both.front(), context_);
    return known->second;
  }

  const SearchTask& task_;
  SearchContext context_;
  std::vector<Part> parts_;
  int next_ = 0;
  std::map<std::pair<int, int>, PricedGround> joined_;  ///< by the numbers of both
};

std::optional<Candidate> divided_along_curves(const SearchTask& task,
                                              const std::vector<LinedSubfield>& division,
                                              OtherSubfields others, const SearchContext& context) {
  Division divided(task, context);
  for (const LinedSubfield& straight : division) divided.add(straight, others);
  divided.join_where_it_pays();
  const std::vector<LinedSubfield> grounds = divided.grounds();
  if (grounds.empty()) return std::nullopt;
  context.report();
  return candidate_on(task, grounds);
}

}  // namespace

std::optional<Candidate> best_division_along_curves(const SearchTask& task,
                                                    const std::vector<std::vector<LinedSubfield>>& divisions,
                                                    OtherSubfields others, const SearchContext& context) {
  std::optional<Candidate> best;
  for (const std::vector<LinedSubfield>& division : divisions) {
    // Ground that is not divided has its curve already.
    if (division.size() < 2 || context.has_to_end()) continue;
    std::optional<Candidate> found = divided_along_curves(task, division, others, context);
    if (found && (!best || is_better(found->avoided, best->avoided))) best = std::move(found);
  }
  return best;
}

std::vector<LinedSubfield> hopeful_division(const SearchTask& task, const std::vector<SweptGround>& swept) {
  const SweptGround* best = nullptr;
  for (const SweptGround& one : swept)
    if (one.grounds.size() > task.ground.plannable.size() &&
        (best == nullptr || one.outlook.soft < best->outlook.soft))
      best = &one;
  return best == nullptr ? std::vector<LinedSubfield>{} : best->grounds;
}

}  // namespace tramline
