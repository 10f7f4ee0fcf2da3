#pragma once
// The stretches across the machine that work at a fix.

#include <vector>

#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// Sections closer to one another than this are adjacent.
inline constexpr double kAdjacent_m = 1e-3;

/// Runs of adjacent working sections, from left to right; empty where nothing works. `boom`: that of the fix;
/// states of sections that it does not have are ignored. `unknown_work`: the state assumed for a fix that
/// does not give one, on or off.
Boom working_boom(const Fix& fix, const Boom& boom, WorkState unknown_work);

}  // namespace tramline::coverage
