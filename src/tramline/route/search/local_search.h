#pragma once
// Improves a tour about given lines until no move gains.

#include <cstddef>
#include <optional>
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
  /// A move, by the ends whose connections it takes away (TwoOpt, ThreeOpt), and what it is rated by, s.
  struct RatedMove {
    double rate_s = 0;
    End a = 0, b = 0;
    std::optional<End> c{};
  };
  void add_near(End end, End near);
  double improve_at(End end);
  void look_from(End a, double ahead_s);
  void look_past(End a, End b, double ahead_s);
  void look_past(End a, End b, End c, double ahead_s);
  void apply(const RatedMove& move);

  ClosedTour& tour_;
  std::vector<std::vector<NearEnd>> near_;  ///< by end
  std::vector<std::size_t> waiting_;
  std::vector<bool> waits_;  ///< by line
  RatedMove best_;           ///< of those seen, by what the tour costs less
  RatedMove
      farthest_;  ///< by what was taken away less what was added, but for the connection that closes the ring
};

}  // namespace tramline::order
