#include "tramline/decomposition/decompose.h"

#include "tramline/decomposition/merge_equal_directions.h"
#include "tramline/decomposition/merge_similar_directions.h"
#include "tramline/decomposition/merge_small_cells.h"

namespace tramline {

std::vector<Subfield> decompose(const Region& plannable, Direction sweep, const PlanSettings& settings) {
  MergeGraph graph = merge_graph(sweep_cells(plannable, sweep, settings.decomposition_threshold,
                                             settings.cell_direction, settings.short_edge_m));
  merge_equal_directions(graph);
  merge_small_cells(graph, settings.small_cell_m2);
  merge_similar_directions(graph, settings.merge_threshold);
  return subfields_of(graph);
}

}  // namespace tramline
