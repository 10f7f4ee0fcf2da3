#pragma once
// The look-ahead at present speed and heading: the land ahead and the switching of sections.

#include <cstddef>
#include <vector>

#include "tramline/coverage/ahead/need_ahead.h"
#include "tramline/coverage/ahead/section_ahead.h"
#include "tramline/coverage/ahead/section_switch.h"
#include "tramline/coverage/tiles/tile_coverage.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// Looks ahead for a boom, over rule.horizon_s. `field`: that of the engine. `states`: one for each section.
/// Preconditions: sensible rule; as many states as sections. O(c log c) for the c cells ahead.
std::vector<SectionAhead> look_ahead(const TileCoverage& coverage, const Region& field, const Motion& motion,
                                     const Boom& boom, const std::vector<SectionState>& states,
                                     const SwitchRule& rule);

}  // namespace tramline::coverage
