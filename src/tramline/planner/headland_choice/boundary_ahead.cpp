#include "tramline/planner/headland_choice/boundary_ahead.h"

#include <cmath>

namespace tramline {
namespace {

class NearestCrossing {
 public:
  NearestCrossing(const Pose& end, double behind_m, double ahead_m)
      : end_(end), along_(end.heading.unit()), behind_m_(behind_m), ahead_m_(ahead_m) {}

  /// `land_inside`: whether the land is inside the ring.
  void look_at(const Ring& ring, std::optional<std::size_t> obstacle, bool land_inside) {
    const bool anticlockwise = signed_area(ring) > 0;
    double ring_m = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()], edge = b - a;
      const double edge_m = length(edge), turn = cross(along_, edge);
      if (turn != 0) {
        const double ahead_m = cross(a - end_.at, edge) / turn, share = cross(a - end_.at, along_) / turn;
        if (share >= 0 && share <= 1 && ahead_m >= -behind_m_ && ahead_m <= ahead_m_ &&
            (!nearest_ || std::abs(ahead_m) < std::abs(nearest_->ahead_m))) {
          const Point right = (1 / edge_m) * right_of(edge);
          nearest_ = BoundaryPlace{obstacle, i, ring_m + share * edge_m, ahead_m,
                                   anticlockwise == land_inside ? right : -1.0 * right};
        }
      }
      ring_m += edge_m;
    }
  }

  const std::optional<BoundaryPlace>& nearest() const { return nearest_; }

 private:
  const Pose& end_;
  Point along_;
  double behind_m_, ahead_m_;
  std::optional<BoundaryPlace> nearest_;
};

}  // namespace

std::optional<BoundaryPlace> boundary_ahead(const Field& field, const Pose& end, double behind_m,
                                            double ahead_m) {
  NearestCrossing crossing(end, behind_m, ahead_m);
  crossing.look_at(field.outer, std::nullopt, true);
  for (std::size_t i = 0; i < field.obstacles.size(); ++i)
    if (field.obstacles[i].kind == ObstacleKind::kObstacle)
      crossing.look_at(field.obstacles[i].shape.outer, i, false);
  return crossing.nearest();
}

}  // namespace tramline
