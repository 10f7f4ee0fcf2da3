#pragma once
// Maps of plans that are so small that several stand on one page.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/render/page/canvas.h"
#include "tramline/render/page/legend_content.h"

namespace tramline::render {

/// The symbols that occur in any of the plans, under one heading.
LegendBlock legend_of_all(const std::vector<Plan>& plans);

/// The box round everything that any of the plans draws, m.
Box drawn_box(const std::vector<Plan>& plans);

/// The height of a map of this width, px, for what is drawn, m.
double small_map_height(const Box& drawn_m, double width_px);

/// How many metres of the field are a pixel of a map of this size.
double small_map_scale(const Box& drawn_m, const Box& map_px, double k);

/// Where draw_small_map() puts a point of the field.
MapView small_map_view(const Box& drawn_m, const Box& map_px, double k);

/// Draws the plan into a box of the page, px: draw_plan()'s layers without numbers and arrow heads, for which
/// small maps have no room. `drawn_m` fills the box. `k` is the text scale of the page, which the canvas uses
/// again afterwards.
void draw_small_map(Canvas& canvas, const Plan& plan, const Box& drawn_m, const Box& map_px, double k);

}  // namespace tramline::render
