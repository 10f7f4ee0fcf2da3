#pragma once
// The costs of hops between the ends of lines, by which tours are compared.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "tramline/route/order/hop_ground.h"
#include "tramline/route/order/lines.h"

namespace tramline::order {

/// The additions to the length of a hop, m.
struct HopPrices {
  bool way_round = true;  ///< its length is that of the way round obstacles, not of the straight line
  double barred_m = 0;    ///< added where it leads through an obstacle or far outside the field
  double leaving_m = 0;   ///< added where it does not lead to a track next to the one it comes from
};

/// The hops of one set of lines. Computed hops are cached, so one object serves one thread.
class HopCosts {
 public:
  HopCosts(const std::vector<WorkedLine>& lines, const HopGround& ground);

  void set_prices(const HopPrices& prices) { prices_ = prices; }

  Point at(End end) const { return ends_[end]; }
  std::size_t lines() const { return tracks_.size(); }
  /// Along the straight line, m.
  double distance_m(End a, End b) const { return distance(ends_[a], ends_[b]); }
  /// A lower bound of cost() that does not need the hop's way round.
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

/// The sum over all hops of a tour.
double cost(const Tour& tour, HopCosts& costs);
double length_m(const Tour& tour, const HopCosts& costs);
int barred_hops(const Tour& tour, HopCosts& costs);

}  // namespace tramline::order
