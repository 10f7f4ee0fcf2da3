#pragma once
// Headland passes on land with room for all ways.

#include <cstddef>
#include <utility>
#include <vector>

#include "tramline/route/build/lines_beside_boundaries.h"
#include "tramline/route/passes/worked_pass.h"

namespace tramline::testing {

/// A square of 600 m about the origin. Headland, `all` and `entries` are filled by whoever makes passes on
/// it.
struct OpenLand {
  explicit OpenLand(Machine of) : machine(std::move(of)) { field.outer = land.front().outer; }
  OpenLand(const OpenLand&) = delete;
  OpenLand& operator=(const OpenLand&) = delete;

  Machine machine;
  Headland headland{};
  std::vector<std::size_t> all{};  ///< indices of the passes
  Field field{};
  Region land{{{{-300, -300}, {300, -300}, {300, 300}, {-300, 300}}, {}}};
  AllowedLand allowed{land};
  EntriesByPass entries{};
  DrivingGround ground{allowed, field, machine, land};
  RoadmapOnDemand roadmap{[this] { return Roadmap(lines_beside_boundaries({}, field, ground), 3); }, ground};
  Connector connector{ground, roadmap, {}};
  LeastSeconds least{machine};
  PassTask task{headland, entries, all, PassSequence::kAny, connector, least};
};

}  // namespace tramline::testing
