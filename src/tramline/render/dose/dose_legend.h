#pragma once
// The legend of a dose map as plain text.

#include <vector>

#include "tramline/model/dose_map.h"
#include "tramline/render/page/legend_content.h"

namespace tramline::render {

/// First a block of empty rows over which the histogram is drawn; then the figures, and the wind where there
/// was any.
std::vector<LegendBlock> legend_of(const DoseMap& map);

}  // namespace tramline::render
