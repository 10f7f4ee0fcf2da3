#include "tramline/decomposition/merge_equal_directions.h"

#include "tramline/decomposition/candidate_directions.h"
#include "tramline/decomposition/tolerances.h"

namespace tramline {

MergeRule equal_directions() {
  return {[](const MergeNode& a, const MergeNode& b) {
            return angle_between(a.direction, b.direction).radians() <= kSameDirectionRadians;
          },
          MergeRule::Opens::kWithDirection};
}

void merge_equal_directions(MergeGraph& graph) {
  merge_longest_edge_first(graph, Remember::kBoth, equal_directions());
}

}  // namespace tramline
