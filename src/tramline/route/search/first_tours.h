#pragma once
// Tours to begin a search with.

#include <cstddef>
#include <vector>

#include "tramline/route/search/end_costs.h"
#include "tramline/route/search/neighbours.h"

namespace tramline::order {

/// Connects ends by the cheapest connections first, as long as every end has one connection and no ring
/// closes; the pieces of tour that are left are joined end to nearest end. Deterministic. O(n·k·log n) for k
/// neighbours of each end, and O(p²) costs for p pieces left. Precondition: neighbours are those of the ends
/// of the same lines.
Tour greedy_tour(const EndCosts& costs, const Neighbours& neighbours);

/// The same where a connection costs the prices of its ends besides (PricedBound): connections without which
/// some lines are hard to reach come first, so local search has less to do. A price for each end, more are
/// left aside.
Tour greedy_tour(const EndCosts& costs, const Neighbours& neighbours, const std::vector<double>& prices_s);

/// The tour that drives the lines in this order and enters each by the end that makes the whole cheapest.
/// O(n). Precondition: the order has every line of the costs once.
Tour entered_best(const std::vector<std::size_t>& order, const EndCosts& costs);

}  // namespace tramline::order
