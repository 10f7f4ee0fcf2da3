#pragma once
// The order in which headland passes are worked, and from where.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/model/headland.h"
#include "tramline/model/route.h"
#include "tramline/route/connection/connector.h"
#include "tramline/route/connection/least_seconds.h"
#include "tramline/route/passes/pass_entries.h"

namespace tramline {

struct WorkedPass {
  std::size_t pass = 0;  ///< index into Headland::passes
  PassEntry entry;
  Way before;  ///< the way to it; without path where the route begins with it
};

/// What passes are chosen from. All references outlive the call.
struct PassTask {
  const Headland& headland;
  const EntriesByPass& entries;
  const std::vector<std::size_t>& passes;  ///< to be worked, indices into Headland::passes
  PassSequence sequence;
  const Connector& connector;
  const LeastSeconds& least;
};

/// These passes, each once, from where the route is (`left`: the way of the axle up to there; empty: nowhere
/// yet, then the first of them begins at its own beginning). The nearest pass in driving time comes next, of
/// those whose turn it is by `sequence`: of passes along one boundary by their numbers. Of the places of a
/// closed pass that is entered which is reached soonest with room. Where a way between them lacks room or is
/// backed along, in whatever order takes least of this one, outwards and inwards. O(p²) ways for p passes.
std::vector<WorkedPass> pass_tour(const PassTask& task, const SteeredPath& left);

/// The first of them, and the way there. Preconditions: there is a pass, and `left` is not empty.
WorkedPass nearest_pass(const PassTask& task, const SteeredPath& left);

}  // namespace tramline
