#pragma once
// Data derived from a problem once, before any search.

#include <cstdint>
#include <memory>

#include "tramline/avoidance/obstacles/obstacle_classification.h"
#include "tramline/model/headland.h"
#include "tramline/planner/given/prepared_land.h"
#include "tramline/route/build/lines_beside_boundaries.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline {

/// Whether a search may divide the land where that pays.
enum class MayDivide : std::uint8_t { kYes, kNo };

/// A field ready to be searched, with its obstacles sorted and its headlands cut off. Local metres.
struct PreparedField {
  ClassifiedGround ground;  ///< with headlands: the land inside them
  double body_m2 = 0;       ///< area of the ground's body
  Headland headland;        ///< empty without any
  /// Corners between two edges that are both shorter than this do not split a cell:
  /// PlanSettings::short_edge_m, or more where headlands have rounded corners.
  double short_edge_m = 0;
  /// The field where its boundary is hard and limits swaths; empty where the boundary is soft or has a
  /// headland all round. With such a headland, wherever a swath is driven it has body across it, which lies
  /// at least a width from the boundary, and so no swath, straight or curved, crosses the boundary however
  /// far its end rule lets it run on.
  Region hard_field;
  bool clearance_takes_all = false;  ///< there is land to work without the clearance, and none with it
  PreparedLand given;                ///< what the user decided about the land
  MayDivide may_divide = MayDivide::kYes;
  /// Where the machine may turn (turning_land()); shared by the parts of a divided field.
  std::shared_ptr<const AllowedLand> turning_land{};
  /// What its routes may follow where there is no headland pass; shared likewise.
  std::shared_ptr<const LinesBesideBoundaries> beside_boundaries = std::make_shared<LinesBesideBoundaries>();
};

}  // namespace tramline
