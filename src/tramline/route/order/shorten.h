#pragma once
// Shortens a tour by local search.

#include <array>
#include <vector>

#include "tramline/route/order/hop_costs.h"

namespace tramline::order {

/// A unit that a tour keeps together: one line, or several driven one after the other.
struct Stretch {
  std::array<End, 2> ends{};  ///< it may be entered by either and is left by the other
};

/// Stretches in driving order: 2·i where stretch i is entered by its first end, 2·i + 1 where by its second.
using StretchTour = std::vector<std::size_t>;

/// For each end of a stretch the ends near it, nearest first; ends are numbered as in a tour.
using NearEnds = std::vector<std::vector<std::size_t>>;
NearEnds near_ends(const std::vector<Stretch>& stretches, const HopCosts& costs);

/// Exchanges two or three hops of the tour at a time, which reverses parts of it, moves them or both, as long
/// as that makes it cheaper; near ends first. The tour may begin and end anywhere. Deterministic. About O(n
/// log n) evaluations of hops, each exchange O(n).
void shorten(StretchTour& tour, const std::vector<Stretch>& stretches, const NearEnds& near, HopCosts& costs);

}  // namespace tramline::order
