#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// Costs of ways are differences of the costs of whole tracks, with the rounding of these.
double rounding_of_costs(const Plan& plan) {
  constexpr double kOfWays = 1e-6;
  return kOfWays + kRounding * std::abs(plan.cost);
}

/// The fault of the data of one way past, or "".
std::string fault_of(const WayPast& way, Passing side) {
  if (way.possible && !way.why_not.empty())
    return fmt::format("has a cost and a reason why not for passing {}", name(side));
  if (!way.possible && way.why_not.empty())
    return fmt::format("has neither a cost nor a reason why not for passing {}", name(side));
  if (way.possible && !std::isfinite(way.cost))
    return fmt::format("has a cost that is no number for passing {}", name(side));
  return "";
}

/// The data of the chosen way; nullptr for a cut, relative to which all costs are counted.
const WayPast* chosen_way(const Encounter& encounter) {
  if (encounter.chosen == Passing::kCut) return nullptr;
  return encounter.chosen == Passing::kLeft ? &encounter.left : &encounter.right;
}

/// The chosen way costs least. What the encounters of a track cost is that of the track's best choice with
/// this way here, all other tracks as they are, so that this holds for each of them whatever they were
/// decided together with.
std::string expensive_choice_fault(const Plan& plan, const Encounter& encounter) {
  const WayPast* way = chosen_way(encounter);
  const double cost = way == nullptr ? 0 : way->cost;
  const auto cheaper = [&](double other) { return other < cost - rounding_of_costs(plan); };
  const auto fault = [&](Passing other, double other_cost) {
    return fmt::format("was decided as {} at {:.4f}, and {} would cost {:.4f}", name(encounter.chosen), cost,
                       name(other), other_cost);
  };
  if (cheaper(0)) return fault(Passing::kCut, 0);
  if (encounter.left.possible && cheaper(encounter.left.cost))
    return fault(Passing::kLeft, encounter.left.cost);
  if (encounter.right.possible && cheaper(encounter.right.cost))
    return fault(Passing::kRight, encounter.right.cost);
  return "";
}

std::string fault_of(const Plan& plan, const Encounter& encounter) {
  if (std::string fault = fault_of(encounter.left, Passing::kLeft); !fault.empty()) return fault;
  if (std::string fault = fault_of(encounter.right, Passing::kRight); !fault.empty()) return fault;
  const WayPast* way = chosen_way(encounter);
  if (way != nullptr && !way->possible)
    return fmt::format("was to be passed {}, which is said not to be possible", name(encounter.chosen));
  if (plan.settings.avoid == Avoidance::kCheapest) return expensive_choice_fault(plan, encounter);
  return "";
}

}  // namespace

void check_ways(const Case& c, Violations& out) {
  for (std::size_t i = 0; i < c.plan.encounters.size(); ++i) {
    const std::string fault = fault_of(c.plan, c.plan.encounters[i]);
    if (!fault.empty())
      out.push_back(
          {Rule::kEncounters, fmt::format("encounter {} {}", i + 1, fault), c.plan.encounters[i].at, 1});
  }
}

}  // namespace tramline::check
