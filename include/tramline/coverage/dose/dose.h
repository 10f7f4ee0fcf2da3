#pragma once
// Dose maps: the amount applied by a drive, or on the land that one covered (Zhang §4).

#include "tramline/coverage/dose/dose_settings.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/model/coverage.h"
#include "tramline/model/dose_map.h"

namespace tramline::coverage {

/// The dose map of a drive: the amount of each quad (quad_amount.h) is spread over its land (slabs.h,
/// lay_slab.h), so that the sum of all cells is the amount sprayed; land worked twice gets twice as much. The
/// caller sets field id, field, frame and unit. Throws kBadInput as evaluate() does, for a log with work and
/// without rates where no nominal one is given, for one without times where a nominal speed is, for a bad
/// pattern, and for too many cells. O(cells that the quads overlap, and evaluate()). The result is the same
/// for any number of threads.
DoseMap dose(WorkLog log, const Region& field, const DoseSettings& settings, const FixProgress& progress);

/// The same where the drive is not known: the nominal rate as many times as land was worked. Land worked
/// three times or more counts with the average number that follows from the areas. Throws kBadInput without a
/// nominal rate, where the coverage lacks the areas or regions of how often land was worked, and for too many
/// cells.
DoseMap dose(const Coverage& coverage, const DoseSettings& settings);

}  // namespace tramline::coverage
