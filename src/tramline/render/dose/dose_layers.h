#pragma once
// The layers of the picture of a dose map, in the order they are drawn.

#include "tramline/model/dose_map.h"
#include "tramline/render/page/canvas.h"

namespace tramline::render {

/// The cells in the colours of their rates; for cells with ground, of the rates on their ground. Cells too
/// small to be visible are combined into blocks of half a pixel by their mean.
void draw_cells(Canvas& canvas, const DoseMap& map);
/// Outline and obstacles of the field.
void draw_dose_field(Canvas& canvas, const DoseMap& map);
/// The direction in which the wind blows, at the right end of the strip under the map; nothing without wind.
void draw_wind(Canvas& canvas, const Box& strip, const DoseMap& map);
/// The histogram: area of ground by rate, above the colours and their rates.
void draw_histogram(Canvas& canvas, const Box& box, const DoseMap& map);

}  // namespace tramline::render
