#pragma once
// Improves a tour about given lines until no move gains.

#include <vector>

#include "tramline/route/search/closed_tour.h"
#include "tramline/route/search/exchange_chain.h"
#include "tramline/route/search/neighbours.h"

namespace tramline::order {

/// Lines wait their turn; a line is looked at again only when one of its connections has changed (the
/// don't-look bits of Bentley 1992).
class LocalSearch {
 public:
  /// Neighbours are those of all ends of the tour, the outside included. Both references outlive the search.
  LocalSearch(ClosedTour& tour, const Neighbours& neighbours);

  void wait(End end);
  /// Until no line waits. What the tour costs less then, s. Each move gains, so it ends.
  double run();

 private:
  double improve_at(End end);
  double best_move(End end);

  ClosedTour& tour_;
  const Neighbours& neighbours_;
  ExchangeChain chain_;
  std::vector<std::size_t> waiting_;
  std::vector<bool> waits_;  ///< by line
};

}  // namespace tramline::order
