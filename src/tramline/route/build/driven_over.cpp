#include "tramline/route/build/driven_over.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tramline/geometry/index/box_grid.h"
#include "tramline/geometry/index/edge_index.h"

namespace tramline {
namespace {

/// Chords of swaths on arcs deviate by this at the most, m: nobody sees a centimetre in a metre.
constexpr double kSagitta_m = 0.01;

bool inside(const Ring& ring, Point p) {
  bool in = false;
  for (std::size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++) {
    const Point a = ring[before], b = ring[i];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
  }
  return in;
}

/// The land of every work and headland leg, by place.
class WorkedLand {
 public:
  explicit WorkedLand(const Plan& plan) {
    const double width_m = plan.machine.width_m;
    for (std::size_t leg = 0; leg < plan.route.legs.size(); ++leg) {
      const RouteLeg& worked = plan.route.legs[leg];
      if (!worked.work) continue;
      if (worked.piece)
        for (Ring& part : swath_parts(plan.pieces[*worked.piece], width_m, kSagitta_m))
          add(std::move(part), leg);
      else
        for (const PathSegment& segment : trace(worked.path, kSagitta_m))
          add(band({segment}, width_m, kSagitta_m), leg);
    }
    std::vector<Box> boxes;
    for (const Part& part : parts_) boxes.push_back(bounds(part.ring));
    grid_ = BoxGrid(boxes);
  }

  /// The first leg that works this place; none where it is never worked.
  std::size_t first_at(Point p) const {
    std::size_t out = kNever;
    grid_.each_meeting({p.x, p.y, p.x, p.y}, [&](std::size_t i) {
      if (parts_[i].leg < out && inside(parts_[i].ring, p)) out = parts_[i].leg;
    });
    return out;
  }

  static constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

 private:
  struct Part {
    Ring ring;
    std::size_t leg = 0;
  };
  void add(Ring ring, std::size_t leg) {
    if (ring.size() > 2) parts_.push_back({std::move(ring), leg});
  }

  std::vector<Part> parts_;
  BoxGrid grid_;
};

}  // namespace

void add_driven_over(Plan& plan) {
  const WorkedLand worked(plan);
  Region body;
  for (const Polygon& polygon : plan.body) body.push_back(oriented(polygon));
  const EdgeIndex tracks(body);
  Route& route = plan.route;
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    if (route.legs[i].work) continue;
    for (const SteeredStretch& stretch : route.legs[i].path) {
      const double steps = std::ceil(stretch.length_m / kDrivenOverStep_m);
      for (double step = 0; step < steps; ++step) {
        const double each_m = stretch.length_m / steps;
        const Point at = pose_after(stretch, (step + 0.5) * each_m).at;
        const std::size_t first = worked.first_at(at);
        if (first == WorkedLand::kNever) continue;
        (first < i ? route.over_worked_m : route.over_unworked_m) += each_m;
        if (tracks.contains(at)) route.over_tracks_m += each_m;
      }
    }
  }
}

}  // namespace tramline
