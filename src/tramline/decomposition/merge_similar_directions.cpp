#include "tramline/decomposition/merge_similar_directions.h"

#include <algorithm>

#include "tramline/decomposition/tolerances.h"

namespace tramline {

MergeRule similar_directions(Angle threshold) {
  // "Equal to or between" (Versleijen §2.2.3) must not depend on the last bit of a rotation.
  const double limit = threshold.radians() + kInclusive_rad;
  // A history only grows: neighbours that it keeps apart stay apart.
  return {[limit](const MergeNode& a, const MergeNode& b) {
            return std::all_of(a.history.begin(), a.history.end(), [&](Direction one) {
              return std::all_of(b.history.begin(), b.history.end(), [&](Direction other) {
                return angle_between(one, other).radians() <= limit;
              });
            });
          },
          MergeRule::Opens::kNever};
}

void merge_similar_directions(MergeGraph& graph, Angle threshold) {
  merge_longest_edge_first(graph, Remember::kBoth, similar_directions(threshold));
}

}  // namespace tramline
