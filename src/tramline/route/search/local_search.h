#pragma once
// Improves a tour about given lines until no move gains.

#include <cstddef>
#include <vector>

#include "tramline/route/search/closed_tour.h"
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
  struct NearEnd {
    End end = 0;
    double cost_s = 0;
  };
  struct FoundMove {
    double gain = 0;
    End a = 0, b = 0, c = 0;
    bool three = false;
  };
  double improve_at(End end);
  void look_past(End a, End b, double ahead_s);
  void look_past(End a, End b, End c, double ahead_s);

  ClosedTour& tour_;
  std::vector<std::vector<NearEnd>> near_;  ///< by end
  std::vector<std::size_t> waiting_;
  std::vector<bool> waits_;  ///< by line
  FoundMove best_;
};

}  // namespace tramline::order
