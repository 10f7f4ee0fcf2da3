#include "tramline/model/explanation.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tramline {

const char* name(Cause cause) {
  switch (cause) {
    case Cause::kRowEnds:
      return "row ends";
    case Cause::kSides:
      return "sides";
    case Cause::kSeams:
      return "seams";
    case Cause::kDetours:
      return "detours";
    case Cause::kStops:
      return "stops";
    case Cause::kShortPieces:
      return "short pieces";
    case Cause::kGivenUp:
      return "given up";
    case Cause::kTurns:
      return "turns";
    case Cause::kSubfields:
      return "subfields";
    case Cause::kHeadland:
      return "headland";
  }
  return "";
}

CostDifference difference(const Objective& objective, const Tally& of, const Tally& from) {
  return {objective.overlap * (of.overlap_m2 - from.overlap_m2),
          objective.uncovered * (of.uncovered_m2 - from.uncovered_m2),
          objective.turn * (of.turns - from.turns), objective.stop * (of.stops - from.stops),
          objective.subfield * (further_subfields(of) - further_subfields(from))};
}

const char* main_reason(const CostDifference& more) {
  const std::array<std::pair<double, const char*>, 5> reasons{{{more.overlap, "overlap"},
                                                               {more.uncovered, "uncovered"},
                                                               {more.turns, "turns"},
                                                               {more.stops, "stops"},
                                                               {more.subfields, "subfields"}}};
  return std::max_element(reasons.begin(), reasons.end(),
                          [](const auto& a, const auto& b) { return a.first < b.first; })
      ->second;
}

}  // namespace tramline
