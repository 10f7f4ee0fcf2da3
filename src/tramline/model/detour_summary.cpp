#include "tramline/model/detour_summary.h"

#include <algorithm>

namespace tramline {

DetourSummary summary_of_detours(const Plan& plan) {
  DetourSummary out;
  for (const TrackPiece& piece : plan.pieces) {
    for (const Detour& detour : piece.detours) {
      ++(detour.side == Passing::kLeft ? out.left : out.right);
      out.smallest_radius_m = std::min(out.smallest_radius_m, smallest_radius(detour.path));
    }
  }
  return out;
}

}  // namespace tramline
