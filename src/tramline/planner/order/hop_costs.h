#pragma once
// What hops between the ends of lines count when tours are compared.

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "tramline/planner/order/hop_ground.h"
#include "tramline/planner/order/lines.h"

namespace tramline::order {

/// What a hop counts besides its length, m.
struct HopPrices {
  bool way_round = true;  ///< its length is that of the way round
  double barred_m = 0;    ///< where it leads through an obstacle or far outside the field
  double leaving_m = 0;   ///< where it does not lead to a track beside the one it comes from
};

/// The hops of one set of lines. What has been looked at once is kept: one serves one thread.
class HopCosts {
 public:
  HopCosts(const std::vector<WorkedLine>& lines, const HopGround& ground);

  void set_prices(const HopPrices& prices) { prices_ = prices; }

  Point at(End end) const { return ends_[end]; }
  std::size_t lines() const { return tracks_.size(); }
  /// Along the straight line, m.
  double distance_m(End a, End b) const {
    // As a root where point.h takes a hypotenuse: tours are compared by millions of these.
    const Point way = ends_[b] - ends_[a];
    return std::sqrt(dot(way, way));
  }
  /// No more than cost(), without a look at the ground.
  double least(End a, End b) const;
  /// Symmetric.
  double cost(End a, End b);
  bool barred(End a, End b) { return hop(a, b).barred; }

 private:
  struct TrackNumber {
    std::size_t subfield = 0;
    int track = 0;
  };
  const Hop& hop(End a, End b);

  std::vector<Point> ends_;
  std::vector<TrackNumber> tracks_;  ///< by line
  const HopGround& ground_;
  HopPrices prices_;
  std::unordered_map<std::uint64_t, Hop> known_;
};

/// Of all hops of a tour.
double cost(const Tour& tour, HopCosts& costs);
double length_m(const Tour& tour, const HopCosts& costs);
int barred_hops(const Tour& tour, HopCosts& costs);

}  // namespace tramline::order
