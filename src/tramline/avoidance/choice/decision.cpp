#include "tramline/avoidance/choice/decision.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "tramline/avoidance/tolerances.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {

bool same_detours(const std::vector<TrackDetour>& a, const std::vector<TrackDetour>& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(),
                    [](const TrackDetour& x, const TrackDetour& y) { return x.path == y.path; });
}

bool same_drive(const WayRound& a, const WayRound& b) {
  return a.detour.side == b.detour.side && a.first_gap == b.first_gap && a.last_gap == b.last_gap &&
         std::abs(a.detour.from - b.detour.from) < kSameDistance_m &&
         std::abs(a.detour.to - b.detour.to) < kSameDistance_m &&
         std::abs(a.detour.length_m - b.detour.length_m) < kSameDistance_m;
}

bool has_option(const BlockedTrack& track, const WayRound& way) {
  return std::any_of(track.options.begin(), track.options.end(),
                     [&way](const TrackOption& option) { return same_drive(option.way, way); });
}

WayPast way_past(const BlockedTrack& track, const Forced& forced, const std::optional<TrackChoice>& choice,
                 double cost_of_cut, WaysPast ways) {
  if (choice) return {true, choice->cost - cost_of_cut, ""};
  const Construction by = ways == WaysPast::kPaper ? Construction::kPaper : Construction::kOwn;
  for (const RefusedWay& refused : track.refused)
    if (refused.by == by && refused.gap == forced.gap && refused.side == forced.way)
      return {false, 0, sentence(refused.why)};
  return {false, 0,
          sentence(by == Construction::kPaper ? Refusal::kVersleijenOtherSide : Refusal::kBesideOthers)};
}

std::vector<GapRow> rows_to_join(const std::vector<WayRound>& alone) {
  std::vector<GapRow> out;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    std::size_t end = i;
    while (end + 1 < alone.size() && alone[end + 1].detour.from < alone[end].detour.to) ++end;
    for (const std::size_t last : std::set{std::min(i + 1, end), std::min(i + 2, end), end})
      if (last > i) out.push_back({alone[i].first_gap, alone[last].last_gap});
  }
  return out;
}

}  // namespace tramline
