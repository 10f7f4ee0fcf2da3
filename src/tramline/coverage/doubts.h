#pragma once
// Figures of an evaluation that nobody should act on without asking why.

#include <string>
#include <vector>

#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// Beyond this share of the covered ground, repeated ground is more likely a wrong width than bad driving.
inline constexpr double kDoubtfulRepeat = 0.5;
/// The covered ground and the machine's own counter should be no further apart, as a share of the counter.
inline constexpr double kDoubtfulCounter = 0.2;

/// One sentence for each doubt: repeated ground beyond kDoubtfulRepeat, and covered ground further from the
/// machine's counter than kDoubtfulCounter. None where nothing was counted.
std::vector<std::string> doubts_on(const CoverageAreas& areas, const MachineCounters& counters,
                                   double width_m);

}  // namespace tramline::coverage
