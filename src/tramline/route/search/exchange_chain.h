#pragma once
// The move of Lin and Kernighan (1973): a chain of exchanges, of which the first ones need not gain.

#include "tramline/route/search/closed_tour.h"
#include "tramline/route/search/neighbours.h"

namespace tramline::order {

/// Takes away the connection of an end, connects its mate with an end near it, takes away the connection of
/// that one, and so on, as long as what was taken away costs more than what was added; each time the two
/// loose ends could be connected, which makes it an exchange. Few ends are tried at each depth.
class ExchangeChain {
 public:
  /// All references outlive the chain.
  ExchangeChain(ClosedTour& tour, const Neighbours& neighbours) : tour_(tour), neighbours_(neighbours) {}

  /// Applies a chain from the connection of this end that gains, if there is one. What it gained, s, 0 if
  /// there is none; then the tour is what it was.
  double improve(End first);

 private:
  double extend(End first, End loose, double ahead_s, std::size_t depth);

  ClosedTour& tour_;
  const Neighbours& neighbours_;
};

}  // namespace tramline::order
