#include "tramline/route/order/point_grid.h"
#include "tramline/route/order/tours.h"

namespace tramline::order {

Tour nearest_neighbour(const HopCosts& costs, End first) {
  std::vector<Point> points;
  for (End end = 0; end < 2 * costs.lines(); ++end) points.push_back(costs.at(end));
  PointGrid waiting(points);
  Tour out;
  for (std::vector<End> next{first}; !next.empty();
       next = waiting.nearest(points[other_end(out.back())], 1)) {
    out.push_back(next.front());
    waiting.remove(next.front());
    waiting.remove(other_end(next.front()));
  }
  return out;
}

}  // namespace tramline::order
