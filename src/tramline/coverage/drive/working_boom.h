#pragma once
// Which stretches across the machine work at a fix.

#include <vector>

#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// Sections closer than this to one another are adjacent.
inline constexpr double kAdjacent_m = 1e-3;

/// Runs of adjacent working sections, from left to right; empty where nothing works. `boom`: the fix's;
/// states of sections that it does not have are ignored. `unknown_work`: what a fix that says nothing
/// counts as, on or off.
Boom working_boom(const Fix& fix, const Boom& boom, WorkState unknown_work);

}  // namespace tramline::coverage
