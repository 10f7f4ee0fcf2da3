#include "tramline/route/certificate/priced_bound.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

#include "tramline/route/certificate/near_joins.h"
#include "tramline/route/certificate/shortcuts.h"

namespace tramline::order {
namespace {

/// The cheapest join of two members under prices, s.
double least_between(std::size_t one, std::size_t other, const std::vector<double>& prices_s,
                     const ConnectionBounds& bounds) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t a : bounds.nodes_of(one))
    for (const std::size_t b : bounds.nodes_of(other))
      if (bounds.may_join(a, b)) least = std::min(least, bounds.between(a, b) + prices_s[a] + prices_s[b]);
  return least;
}

}  // namespace

std::vector<std::size_t> open_nodes(const std::vector<double>& prices_s, const ConnectionBounds& bounds) {
  assert(bounds.lines() + bounds.rings() >= 1 && bounds.gates() <= 2);
  std::vector<std::size_t> out;
  for (std::size_t node = 0; node < bounds.nodes(); ++node)
    if (!bounds.is_gate(node)) out.push_back(node);
  if (out.size() == 1) out.push_back(out.front());  // a ring alone, where the route starts and finishes
  const std::size_t count = 2 - bounds.gates();
  std::partial_sort(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count), out.end(),
                    [&](std::size_t a, std::size_t b) {
                      return prices_s[a] != prices_s[b] ? prices_s[a] < prices_s[b] : a < b;
                    });
  out.resize(count);
  return out;
}

double bound_with(double tree_s, const std::vector<double>& prices_s, const ConnectionBounds& bounds) {
  double paid_s = 0;
  for (std::size_t node = 0; node < prices_s.size(); ++node)
    paid_s += static_cast<double>(bounds.connections(node)) * prices_s[node];
  double out = tree_s - paid_s;
  for (const std::size_t node : open_nodes(prices_s, bounds)) out += prices_s[node];
  return out;
}

double bound_of(const std::vector<double>& prices_s, const ConnectionBounds& bounds) {
  assert(prices_s.size() == bounds.nodes());
  // The tree of Prim (1957), from the first line on.
  std::vector<double> key_s(bounds.members(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> outside(key_s.size());
  std::iota(outside.begin(), outside.end(), 0);
  double tree_s = 0;
  for (std::size_t joined = 0;;) {
    std::erase(outside, joined);
    if (outside.empty()) break;
    for (const std::size_t other : outside)
      key_s[other] = std::min(key_s[other], least_between(joined, other, prices_s, bounds));
    joined = *std::min_element(outside.begin(), outside.end(),
                               [&](std::size_t a, std::size_t b) { return key_s[a] < key_s[b]; });
    tree_s += key_s[joined];
  }
  return bound_with(tree_s, prices_s, bounds);
}

double bound_of_pruned(const std::vector<double>& prices_s, const ConnectionBounds& bounds) {
  assert(prices_s.size() == bounds.nodes());
  const JoinTree near = NearJoins(bounds).tree(prices_s);
  std::vector<NodeJoin> joins = shortcuts(near, prices_s, bounds);
  joins.insert(joins.end(), near.joins.begin(), near.joins.end());
  return bound_with(least_tree(std::move(joins), prices_s, bounds).sum_s, prices_s, bounds);
}

}  // namespace tramline::order
