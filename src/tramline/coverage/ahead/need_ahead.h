#pragma once
// How much of what each section comes to is still to be worked.

#include <vector>

#include "tramline/coverage/drive/motion.h"
#include "tramline/coverage/tiles/tile_coverage.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// Nearer than this to the machine nothing is asked: what it works right now ends there but for rounding.
inline constexpr double kUnderfoot_m = 1e-3;

/// Shares of a section's width over a stretch of way: linear in between.
struct NeedStretch {
  double from_m = 0;  ///< ahead of the place
  double to_m = 0;
  double share_from = 0;
  double share_to = 0;

  double at(double ahead_m) const;
};

/// Stretches that follow one another without a gap. The share may jump between two of them.
using Need = std::vector<NeedStretch>;

/// Of each section of the boom, the share of its width that lies over ground of the field (without a field:
/// any ground) not worked yet, from the place to `reach_m` ahead of it. Exact on the engine's cells. A
/// section without a width needs nothing. Precondition: reach_m > 0. O(c log c) for the c cells ahead.
std::vector<Need> need_ahead(const TileCoverage& coverage, const Motion& motion, const Boom& boom,
                             double reach_m);

}  // namespace tramline::coverage
