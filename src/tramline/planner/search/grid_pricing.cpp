#include "tramline/planner/search/grid_pricing.h"

#include <algorithm>
#include <cmath>

#include "tramline/cost/bound/best_offset.h"
#include "tramline/cost/bound/obstacle_edges.h"
#include "tramline/geometry/polygon/significant_vertices.h"
#include "tramline/planner/candidate/turned_ground.h"

namespace tramline {

namespace {

/// Of the working width; the cost of a grid over the outline differs by less than a wedge at each end of a
/// track.
constexpr double kOutline_share = 0.005;

Polygon outline_of(const Polygon& part, double width_m, const SearchContext& context) {
  return context.wants_bound() ? part : simplified(part, kOutline_share * width_m);
}

}  // namespace

GridPricing::GridPricing(const SearchTask& task, const Polygon& part, const SearchContext& context,
                         NearObstacles near)
    : task_(task),
      part_(outline_of(part, task.machine.width_m, context)),
      grid_{task.machine.width_m, min_length_m(task.machine),
            end_criterion(task.settings.end_rule, task.objective, task.machine.width_m)},
      soft_(task.objective),
      bound_{task.objective,
             bounds(part).centre(),
             std::max(task.machine.radius_m, 0.5 * task.machine.width_m),
             task.ground.plannable.size() == 1 ? DetoursOf::kThisGrid : DetoursOf::kAnyGrid,
             near,
             {},
             task.settings.avoid != Avoidance::kPaper} {
  soft_.stop = std::min(soft_.stop, soft_.turn);
  if (near == NearObstacles::kCharged)
    bound_.at_obstacle = edges_at_obstacles(rings_of({part_}), task.ground.hard);
}

GridTally GridPricing::tally(double angle) const {
  const TrackFrame frame = GridPricing::frame(angle);
  return {frame, part_, turned_ground(task_, frame), grid_};
}

GridPrices GridPricing::prices(const GridTally& tally, double offset_m) const {
  const Tally sum = tally.at(origin(tally, offset_m));
  return {separate_cost(task_.objective, sum), separate_cost(soft_, sum), sum.pieces > 0};
}

double GridPricing::least(const GridTally& tally, const PositionBox& box, double enough) const {
  return least_cost(tally, bound_, {origin(tally, box.middle.offset_m), box.half_offset_m, box.half_angle},
                    enough);
}

PricedGrid GridPricing::priced(const GridPosition& position, double cost) const {
  const TrackFrame frame = GridPricing::frame(position.angle);
  return {frame.direction(), frame.to_track(bound_.pivot).x + position.offset_m, cost};
}

double GridPricing::radius_m() const {
  const Box box = bounds(part_);
  return 0.5 * std::hypot(box.width(), box.height());
}

}  // namespace tramline
