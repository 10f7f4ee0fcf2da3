#pragma once
// The layers of the picture of a map of amounts, in the order they are drawn.

#include "tramline/model/dose_map.h"
#include "tramline/render/page/canvas.h"

namespace tramline::render {

/// The cells in the colours of their rates, those of their ground where they have some. Cells too small to be
/// seen are drawn together, as many as make half a pixel, by their mean.
void draw_cells(Canvas& canvas, const DoseMap& map);
/// Outline and obstacles of the field.
void draw_dose_field(Canvas& canvas, const DoseMap& map);
/// Where the wind blows to, at the right end of the strip under the map; nothing where there is none.
void draw_wind(Canvas& canvas, const Box& strip, const DoseMap& map);
/// How much ground got how much, over the colours and their rates.
void draw_histogram(Canvas& canvas, const Box& box, const DoseMap& map);

}  // namespace tramline::render
