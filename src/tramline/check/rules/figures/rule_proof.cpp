#include <fmt/format.h>

#include <cmath>

#include "tramline/check/measure/comparison.h"
#include "tramline/check/rules/rules.h"

namespace tramline::check {
namespace {

/// A bound, and the cost of a known plan that it must not exceed.
void check_below(const char* bound_name, double bound, const char* cost_name, double cost, Point at,
                 Violations& out) {
  // Written so that NaN is a violation too.
  if (bound <= cost + rounding_of(cost)) return;
  out.push_back({Rule::kProof,
                 fmt::format("the {} is {:.6f}, above the {} of {:.6f}", bound_name, bound, cost_name, cost),
                 at, bound - cost});
}

void check_amount(const char* name, double amount, Point at, Violations& out) {
  if (amount >= 0 && std::isfinite(amount)) return;
  out.push_back({Rule::kProof, fmt::format("the {} is {:.6f}", name, amount), at, amount});
}

}  // namespace

void check_proof(const Plan& plan, Violations& out) {
  const Proof& proof = plan.proof;
  const Point at = plan.field.outer.front();
  check_amount("bound", proof.bound, at, out);
  check_amount("cost of the best plan with one direction", proof.one_direction_cost, at, out);
  check_amount("bound for one direction", proof.one_direction_bound, at, out);
  check_below("bound", proof.bound, "cost", plan.cost, at, out);
  check_below("bound for one direction", proof.one_direction_bound,
              "cost of the best plan found with one direction", proof.one_direction_cost, at, out);
  if (proof.one_direction_cost != 0)
    check_below("bound", proof.bound, "cost of the best plan found with one direction",
                proof.one_direction_cost, at, out);
  for (const FrontPoint& point : plan.front.points)
    check_below("bound", proof.bound, "cost of a plan in the front", point.cost, at, out);
  const Objective& prices = plan.objective;
  check_amount("price of overlap", prices.overlap, at, out);
  check_amount("price of uncovered land", prices.uncovered, at, out);
  check_amount("price of a turn", prices.turn, at, out);
  check_amount("price of a stop", prices.stop, at, out);
  check_amount("price of a subfield", prices.subfield, at, out);
}

}  // namespace tramline::check
