#pragma once
// The share of the land ahead of each section that still has to be worked.

#include <vector>

#include "tramline/coverage/drive/motion.h"
#include "tramline/coverage/tiles/tile_coverage.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// Land nearer than this to the machine is ignored: what it works right now ends there up to rounding.
inline constexpr double kUnderfoot_m = 1e-3;

/// The share of a section's width over a stretch of way; linear along the stretch.
struct NeedStretch {
  double from_m = 0;  ///< distance ahead
  double to_m = 0;
  double share_from = 0;
  double share_to = 0;

  double at(double ahead_m) const;
};

/// Stretches that follow one another without a gap. The share may jump between two of them.
using Need = std::vector<NeedStretch>;

/// For each section of the boom, the share of its width over land of the field (without a field: any land)
/// not worked yet, from the position of the machine to `reach_m` ahead of it. Exact on the engine's cells. A
/// section without a width needs nothing. Precondition: reach_m > 0. O(c log c) for the c cells ahead.
std::vector<Need> need_ahead(const TileCoverage& coverage, const Motion& motion, const Boom& boom,
                             double reach_m);

}  // namespace tramline::coverage
