#pragma once
// Headland passes of a route, and what they are chosen from.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/model/headland.h"
#include "tramline/model/route.h"
#include "tramline/route/connection/connector.h"
#include "tramline/route/connection/least_seconds.h"
#include "tramline/route/connection/way.h"
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
  std::optional<Point>
      gate{};  ///< where the route goes once they are worked; none: it ends, or tracks follow
};

/// The straight way from where the last pass was left to the gate; 0 without one.
inline double to_gate_s(const PassTask& task, const Pose& left) {
  return task.gate ? task.least.to_gate(*task.gate, left) : 0;
}

}  // namespace tramline
