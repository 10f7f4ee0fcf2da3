#pragma once
// What a plan is made of where the user does not say.

#include <vector>

#include "request/paper_conventions.h"
#include "request/plan_request.h"

namespace tramline::app {

/// Whether the options ask for tracks alone, priced by themselves or made as in a paper, rather than for a
/// plan to be driven from beginning to end: then PlanOptions as they are hold.
bool asks_for_tracks(const PlanOptions& options);

/// The options of a plan to be driven, where they are not given: headlands, curves and a route. A line to
/// follow decides about curves, and --turns about what is planned between tracks.
std::vector<Convention> whole_plan_defaults(const PlanOptions& options);

}  // namespace tramline::app
