#pragma once
// The panel beside or below the map.

#include <vector>

#include "tramline/render/page/canvas.h"
#include "tramline/render/page/legend_content.h"

namespace tramline::render {

/// Heights of the blocks, px at text scale 1, for lay_out_page().
std::vector<double> heights_of(const std::vector<LegendBlock>& blocks);

/// The boxes of the rows of each block without headings; pixels of the page.
std::vector<Box> rows_of_blocks(const PageLayout& page, const std::vector<LegendBlock>& blocks);

void draw_legend(Canvas& canvas, const PageLayout& page, const std::vector<LegendBlock>& blocks);

}  // namespace tramline::render
