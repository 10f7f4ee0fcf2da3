#pragma once
// Plans of other kinds, for fields that hardly have room.

#include <functional>
#include <optional>
#include <variant>

#include "tramline/planner/whole/route_comparison.h"

namespace tramline {

/// The plan with headlands as the turns of the problem need them, wherever tracks end: of the layout of least
/// cost by the prices of its turns (track_prices()), or by the usual prices of tracks (Objective); or without
/// the headlands that follow from turns.
enum class LayoutBy { kTurns, kUsualPrices, kNoHeadland };
/// Finished, or with its route and still to be finished.
using OtherKind = std::variant<Plan, HeadlandTrial>;
using RoomForTurns = std::function<OtherKind(LayoutBy)>;

const Plan& plan_of(const OtherKind& other);
Plan& plan_of(OtherKind& other);

/// Plans of other kinds that cost less than the best one where that lacks room or hardly works, or where
/// there is none; nullopt where none does. Where there is none of these either the error of the last is
/// thrown.
std::optional<OtherKind> with_room(RouteComparison& plans, const RoomForTurns& room_for_turns);

}  // namespace tramline
