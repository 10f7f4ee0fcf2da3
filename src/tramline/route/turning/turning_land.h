#pragma once
// The land that a machine may turn on.

#include <optional>

#include "tramline/model/plan.h"

namespace tramline {

/// The field without its obstacles, worked or not; passable ones are crossed straight on, not turned on.
/// Where the boundary is soft and has no headland also the land outside, as far as PlanSettings::turn_room_m
/// says or, where that is negative, as far as any manoeuvre leads; not at all where headlands were to be as
/// deep as turns need, and found no room. Local metres.
Region turning_land(const Field& field, const Machine& machine, const PlanSettings& settings);

/// How far beyond the boundary that land reaches, m; nullopt: as far as any manoeuvre.
std::optional<double> land_beyond_m(const PlanSettings& settings);

}  // namespace tramline
