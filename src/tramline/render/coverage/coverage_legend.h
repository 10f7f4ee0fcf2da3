#pragma once
// The legend of an evaluation as plain text.

#include <vector>

#include "tramline/model/coverage.h"
#include "tramline/render/page/legend_content.h"

namespace tramline::render {

/// Symbols that occur, areas with their shares, the work, and the largest gaps: kGapsNumbered of them.
/// Repeated land is a share of covered land (Zhang §3.1); missed, not recorded and covered land within it are
/// shares of the field.
std::vector<LegendBlock> legend_of(const Coverage& coverage);

/// "3:25 h".
std::string duration_text(double seconds);

}  // namespace tramline::render
