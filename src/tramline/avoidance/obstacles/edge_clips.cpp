#include "tramline/avoidance/obstacles/edge_clips.h"

#include "tramline/avoidance/obstacles/bridge.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {

void clip_to_edge(std::vector<Cluster>& clusters, const Ring& outer, double width_m) {
  for (Cluster& cluster : clusters) {
    if (distance_to_ring(cluster.obstacles, outer) >= width_m) continue;
    const Region between = bridge(outer, cluster.obstacles, width_m);
    cluster.given_up.insert(cluster.given_up.end(), between.begin(), between.end());
  }
}

}  // namespace tramline
