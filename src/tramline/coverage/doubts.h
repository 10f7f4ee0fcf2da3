#pragma once
// Warnings about implausible figures of an evaluation.

#include <string>
#include <vector>

#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// A larger share of repeated land in the covered land is more likely due to a wrong width than to bad
/// driving.
inline constexpr double kDoubtfulRepeat = 0.5;
/// The largest plausible difference between the covered area and the machine's own counter, as a share of the
/// counter.
inline constexpr double kDoubtfulCounter = 0.2;

/// One sentence for each doubt: repeated land beyond kDoubtfulRepeat, and a covered area that differs from
/// the machine's counter by more than kDoubtfulCounter. The latter is not checked without a counter.
std::vector<std::string> doubts_on(const CoverageAreas& areas, const MachineCounters& counters,
                                   double width_m);

}  // namespace tramline::coverage
