#pragma once
// Planning a field for a machine and an objective.

#include <optional>
#include <vector>

#include "tramline/model/explanation.h"
#include "tramline/model/plan.h"
#include "tramline/planner/progress.h"

namespace tramline {

/// Plans a field by the strategy of the settings. `threads` 0 uses all cores.
/// Errors: kBadInput where the machine or the objective is not a number or out of range, or where no
/// piece of the least length fits (the machine is too wide, or the field too small).
/// Deterministic: the plan is the same for any number of threads, unless the progress callback ends the
/// search early; the plan then says so (Proof::cut_short, and a warning).
Plan plan_field(const Field& field, const Machine& machine, const Objective& objective,
                const PlanSettings& settings, int threads = 0, const Progress& progress = {});

/// Why a plan was among those that were compared by their whole routes.
enum class Alternative {
  kSearched,       ///< its tracks are those of least cost by the rates of the machine (track_prices())
  kLongestSide,    ///< its tracks run along the longest side of the field
  kLength,         ///< along its length
  kUndivided,      ///< in one direction, where the searched ones have several
  kNoHeadland,     ///< without headland passes
  kAdjacent,       ///< in order, each track beside the one before
  kRoomForTurns,   ///< with headlands deepened where turns lacked room
  kMovedLines,     ///< on lines beside those of another plan, or in any direction, of few tracks
  kWorkedCorners,  ///< with headland passes driven on into corners, out of which the machine backs
};
/// "as searched", "along the longest side", "along the length", "undivided", "no headland", "adjacent order",
/// "room for turns", "on moved lines", "corners worked out"
const char* name(Alternative alternative);

/// A plan that was compared by its whole route.
struct RouteAlternative {
  Alternative kind = Alternative::kSearched;
  std::vector<Direction> directions;  ///< of its subfields
  int headlands = 0;                  ///< the most passes along an edge of the field
  bool all_round = true;              ///< as many along all edges
  WholeCost cost;
  std::size_t without_room = 0;  ///< legs that leave the land
  std::size_t dropped = 0;       ///< pieces that are not worth the way to them
};

struct ExplainedPlan {
  Plan plan;
  /// For straight tracks only: costs of curved tracks are not split into causes.
  std::optional<Explanation> why;
  /// With Aim::kWholeCost: plans whose routes were compared, the plan first, then from the cheapest. Of those
  /// of one kind and as many passes whose directions are about the same the cheapest alone.
  std::vector<RouteAlternative> routes{};
};

/// The same plan and, where its tracks are straight, the explanation why it was chosen. Takes longer:
/// runner-ups have to be laid out.
ExplainedPlan plan_and_explain(const Field& field, const Machine& machine, const Objective& objective,
                               const PlanSettings& settings, int threads = 0, const Progress& progress = {});

/// An edit of the plan `before`, of the same field: what the settings decide (a line to follow, drawn land)
/// as they say, and the rest as it was there. Headland passes that are left to turns are those of `before`;
/// tracks run along the line that is given, in drawn parts by given_search(), or else in the directions and
/// along the curves of `before`. One layout is laid and its route planned, so that it takes a fraction of the
/// time of plan_field(); no other is looked for and no bound is proven. Where the settings leave shapes to
/// the planner, drawn parts have straight tracks. Errors: as plan_field(); kBadInput where `before` is of
/// another shape of the field or has no subfield. Deterministic as plan_field().
Plan plan_edited(const Plan& before, const Field& field, const Machine& machine, const Objective& objective,
                 const PlanSettings& settings, int threads = 0, const Progress& progress = {});

}  // namespace tramline
