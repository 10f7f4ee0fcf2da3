#pragma once
// What logs say of a machine that cannot be meant so.

#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// No machine is wider, m.
inline constexpr double kWidestMachine_m = 60;

/// The log, with two faults mended that make it worthless otherwise, and noted:
/// - widths of elements that add up to more than kWidestMachine_m are copies of one: such a boom becomes one
///   section as wide as its widest;
/// - states of sections of which none ever works although the machine says that it does are no states.
/// O(fixes).
WorkLog plausible(WorkLog log);

}  // namespace tramline::coverage
