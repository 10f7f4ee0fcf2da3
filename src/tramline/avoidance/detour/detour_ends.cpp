#include "tramline/avoidance/detour/detour_ends.h"

namespace tramline {

Look look_at_ends(const Intervals& stretches, std::size_t gap, std::size_t last_gap,
                  const std::function<bool(const Interval&)>& add_gap, WayRound& way) {
  const TrackDetour& detour = way.detour;
  const std::size_t first = stretch_at(stretches, detour.from), last = stretch_at(stretches, detour.to);
  if (first < gap && last >= last_gap && last < stretches.size()) {
    way.first_gap = first + 1;
    way.last_gap = last;
    return Look::kDone;
  }
  bool grown = false;
  for (std::size_t i = 1; i < stretches.size(); ++i) {
    const Interval between{stretches[i - 1].to, stretches[i].from};
    if (between.from <= detour.to && between.to >= detour.from) grown = add_gap(between) || grown;
  }
  if (grown) return Look::kLookAgain;
  way.why_not = Refusal::kEndsBefore;
  return Look::kGaveUp;
}

}  // namespace tramline
