#pragma once
// The numbers in the map of a close-up. Each function keeps off the boxes in `taken`, stays within the
// map, hides no obstacle, and adds the boxes of what it wrote. All in pixels of the page.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/render/page/canvas.h"

namespace tramline::render {

/// From 1, in the order of Field::obstacles: in the obstacle where it has room, else as near as may be to a
/// point in it.
void draw_obstacle_numbers(Canvas& canvas, const Plan& near, const Box& map, std::vector<Box>& taken);
/// The smallest radius of each detour round the obstacle, on its tightest arc's radius.
void draw_radii(Canvas& canvas, const Plan& near, std::size_t obstacle, const Box& map,
                std::vector<Box>& taken);
/// strip_name() of each strip, once, on its track where that enters the map.
void draw_strip_numbers(Canvas& canvas, const Plan& near, const Box& map, std::vector<Box>& taken);

}  // namespace tramline::render
