#pragma once
// Title, scale bar and north arrow.

#include <string>

#include "tramline/render/page/canvas.h"

namespace tramline::render {

void draw_title(Canvas& canvas, const Box& box, const std::string& title, const std::string& subtitle);

/// North arrow and scale bar, in the strip under the map.
void draw_scale_strip(Canvas& canvas, const Box& strip);

/// The longest of 1, 2 and 5 times a power of ten that is at most the given length.
double round_length(double at_most);

}  // namespace tramline::render
