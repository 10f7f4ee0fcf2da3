#pragma once
// What the legend of a map of amounts says, as plain text.

#include <vector>

#include "tramline/model/dose_map.h"
#include "tramline/render/page/legend_content.h"

namespace tramline::render {

/// First the block over which the histogram is drawn, with rows that are empty; then the figures, and the
/// wind where there was one.
std::vector<LegendBlock> legend_of(const DoseMap& map);

}  // namespace tramline::render
