#include "tramline/planner/assembly/arc_slivers.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tramline/cost/tolerances.h"
#include "tramline/cost/worked/doubled_ground.h"
#include "tramline/geometry/index/box_grid.h"
#include "tramline/geometry/path/path.h"

namespace tramline {
namespace {

/// Chords of either swath deviate so far from the arc.
constexpr double kAlong_m = 2 * kLayerSagitta;

/// Both edges of the swath of an arc.
struct ArcEdges {
  Point centre;
  std::array<double, 2> radii_m;
};

class EdgesOfArcs {
 public:
  explicit EdgesOfArcs(const Plan& plan) : width_m_(plan.machine.width_m) {
    for (const TrackPiece& piece : plan.pieces) add(centre_line(piece));
    for (const HeadlandPass& pass : plan.headland.passes) add(pass.path);
    grid_ = BoxGrid(reaches_);
  }

  bool empty() const { return edges_.empty(); }

  bool pass_by(Point p) const {
    bool out = false;
    grid_.each_meeting({p.x, p.y, p.x, p.y}, [&](std::size_t i) {
      const double away_m = distance(p, edges_[i].centre);
      for (const double radius_m : edges_[i].radii_m) out = out || std::abs(away_m - radius_m) <= kAlong_m;
    });
    return out;
  }

 private:
  void add(const Path& path) {
    for (const PathSegment& segment : path) {
      if (segment.straight()) continue;
      const double half_m = 0.5 * width_m_, radius_m = radius(segment);
      edges_.push_back({centre(segment), {std::abs(radius_m - half_m), radius_m + half_m}});
      reaches_.push_back(reach_of({segment}, width_m_).grown(kAlong_m));
    }
  }

  double width_m_;
  std::vector<ArcEdges> edges_;
  std::vector<Box> reaches_;
  BoxGrid grid_;
};

}  // namespace

void drop_slivers_along_arcs(const Plan& plan, Region& land) {
  const EdgesOfArcs edges(plan);
  if (edges.empty()) return;
  std::erase_if(land, [&edges](const Polygon& part) {
    if (!is_sliver(part)) return false;
    if (area(part) < 0.5 * kThinnestOverlap_m * perimeter(part.outer)) return true;
    for (std::size_t i = 0; i < part.outer.size(); ++i) {
      const Point corner = part.outer[i], next = part.outer[(i + 1) % part.outer.size()];
      if (!edges.pass_by(corner) || !edges.pass_by(midpoint(corner, next))) return false;
    }
    return true;
  });
}

}  // namespace tramline
