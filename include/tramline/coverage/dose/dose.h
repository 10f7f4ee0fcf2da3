#pragma once
// From a drive, or from what one covered, to how much was applied where (S3.16).

#include "tramline/coverage/dose/dose_settings.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/model/coverage.h"
#include "tramline/model/dose_map.h"

namespace tramline::coverage {

/// What a drive laid: every quad's amount (quad_amount.h) over its ground (slabs.h, lay_slab.h), so that the
/// sum of all cells is what was sprayed; ground worked twice gets twice as much. Field id, field, frame and
/// unit are the caller's. Throws kBadInput as evaluate() does, for a log with work and without rates where no
/// nominal one is given, for one without times where a nominal speed is, for a bad pattern, and for too many
/// cells. O(cells the quads meet, and evaluate()). The same whatever the threads.
DoseMap dose(WorkLog log, const Region& field, const DoseSettings& settings, const FixProgress& progress);

/// The same of ground whose drive is not known: the nominal rate as often as it was worked. Ground worked
/// three times or more counts as often as the areas say on average. Throws kBadInput without a nominal rate,
/// where it was not counted or not drawn how often ground was worked, and for too many cells.
DoseMap dose(const Coverage& coverage, const DoseSettings& settings);

}  // namespace tramline::coverage
