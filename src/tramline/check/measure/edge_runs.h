#pragma once
// Runs of edges of the field with more headland passes than others, and the land beside them.

#include <vector>

#include "tramline/model/plan.h"

namespace tramline::check {

/// Consecutive edges of the field with the land on their left. At least two points.
using EdgeRun = std::vector<Point>;

/// The number of passes that go round the whole field.
int passes_round_field(const Plan& plan);
/// The largest number along any edge.
int passes_along_edges(const Plan& plan);

/// The longest runs of edges with at least `number` passes; none where all edges have as many. Precondition:
/// a number for each edge, or none at all.
std::vector<EdgeRun> edge_runs(const Plan& plan, int number);

/// The land of the field beside a run, by its definition: left of it and nearer than `depth_m`, and beyond
/// each of its ends a strip of that depth straight on to the boundary where that is no farther than twice the
/// depth. Only what adjoins the run. O(n log n) for n vertices where few strips overlap.
Region land_beside(const EdgeRun& run, const Ring& outer, double depth_m);

/// Total length of the arcs about corners of the run, m.
double arcs_beside_m(const EdgeRun& run, double depth_m);

/// Distance between a path and a run, m. O(n·m).
double distance_from(const EdgeRun& run, const Path& path);

}  // namespace tramline::check
