#include "tramline/route/certificate/best_bound.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "tramline/route/certificate/near_joins.h"
#include "tramline/route/certificate/priced_bound.h"
#include "tramline/route/certificate/shortcuts.h"
#include "tramline/route/tolerances.h"

namespace tramline::order {
namespace {

/// How often the ascent goes on with joins that it lacked.
constexpr int kMostRounds = 3;
/// The step is halved after so many steps without a gain.
constexpr std::size_t kPatience = 15;
/// The part of the direction that is kept from the step before (Volgenant and Jonker 1982).
constexpr double kKept = 0.85;
constexpr double kFirstStep = 2;
constexpr double kLeastStep = 1e-3;

/// Prices that rise along the subgradient of the bound.
class Ascent {
 public:
  Ascent(NearJoins& near, const ConnectionBounds& bounds, const AscentEffort& effort)
      : near_(near),
        bounds_(bounds),
        known_s_(effort.known_s),
        enough_s_(std::max(kSameTime_s, effort.enough_s)),
        prices_s_(bounds.nodes(), 0),
        way_(bounds.nodes(), 0) {}

  /// From prices on; the best prices found over the near joins.
  std::vector<double> run(const std::vector<double>& from, std::size_t steps, double step) {
    prices_s_ = from;
    std::fill(way_.begin(), way_.end(), 0);
    PricedBound best{from, -std::numeric_limits<double>::max()};
    std::size_t idle = 0;
    for (std::size_t i = 0; i < steps && step > kLeastStep; ++i) {
      const JoinTree& tree = near_.tree(prices_s_);
      const double bound_s = bound_with(tree.sum_s, prices_s_, bounds_);
      if (bound_s > best.bound_s + kSameTime_s) {
        best = {prices_s_, bound_s};
        idle = 0;
      } else if (++idle == kPatience) {
        step /= 2;
        idle = 0;
      }
      if (!climb(tree, bound_s, step)) break;
    }
    return best.prices_s;
  }

 private:
  /// One step. False where these prices are the best, for every node is joined once, or the bound is near
  /// enough to the known route.
  bool climb(const JoinTree& tree, double bound_s, double step) {
    std::vector<double> excess(prices_s_.size());  // joins of each node beyond those it should have
    for (std::size_t node = 0; node < excess.size(); ++node)
      excess[node] = -static_cast<double>(bounds_.connections(node));
    for (const NodeJoin& join : tree.joins) {
      ++excess[join.a];
      ++excess[join.b];
    }
    for (const std::size_t node : open_nodes(prices_s_, bounds_)) ++excess[node];
    double square = 0;
    for (std::size_t node = 0; node < excess.size(); ++node) {
      way_[node] = (1 - kKept) * excess[node] + kKept * way_[node];
      square += excess[node] * excess[node];
    }
    if (square == 0 || known_s_ - bound_s <= enough_s_) return false;
    const double length = step * (known_s_ - bound_s) / square;
    for (std::size_t node = 0; node < excess.size(); ++node) prices_s_[node] += length * way_[node];
    return true;
  }

  NearJoins& near_;
  const ConnectionBounds& bounds_;
  double known_s_;
  double enough_s_;
  std::vector<double> prices_s_;
  std::vector<double> way_;
};

PricedBound best_over(NearJoins near, const ConnectionBounds& bounds, const AscentEffort& effort) {
  assert(bounds.lines() + bounds.rings() >= 1 && bounds.gates() <= 2 && effort.known_s >= 0);
  Ascent ascent(near, bounds, effort);
  std::size_t steps = effort.steps > 0 ? effort.steps : usual_steps(bounds.lines());
  std::vector<double> prices_s(bounds.nodes(), 0);
  PricedBound best{prices_s, -std::numeric_limits<double>::max()};
  double step = kFirstStep;
  for (int round = 0; round < kMostRounds; ++round) {
    prices_s = ascent.run(prices_s, steps, step);
    const JoinTree tree = near.tree(prices_s);
    const std::vector<NodeJoin> lacking = shortcuts(tree, prices_s, bounds);
    std::vector<NodeJoin> joins(tree.joins);
    joins.insert(joins.end(), lacking.begin(), lacking.end());
    const double bound_s = bound_with(least_tree(std::move(joins), prices_s, bounds).sum_s, prices_s, bounds);
    if (bound_s > best.bound_s) best = {prices_s, bound_s};
    if (lacking.empty()) break;
    near.add(lacking);
    steps = steps / 2;
    step = kFirstStep / 4;
  }
  return best;
}

}  // namespace

std::size_t usual_steps(std::size_t lines) { return 80 + 25000 / std::max<std::size_t>(lines, 50); }

PricedBound best_bound(const ConnectionBounds& bounds, const AscentEffort& effort) {
  return best_over(NearJoins(bounds), bounds, effort);
}

PricedBound best_bound(const ConnectionBounds& bounds, const Neighbours& near, const AscentEffort& effort) {
  return best_over(NearJoins(bounds, near), bounds, effort);
}

}  // namespace tramline::order
