#pragma once
// The numbers in the map of a close-up. Each function avoids the boxes in `occupied`, stays within the map,
// hides no obstacle, and adds the boxes of its labels to `occupied`. All in pixels of the page.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/render/page/canvas.h"

namespace tramline::render {

/// The numbers of obstacles, from 1 in the order of Field::obstacles: in the obstacle where it has room, else
/// as near as possible to a point in it.
void draw_obstacle_numbers(Canvas& canvas, const Plan& near, const Box& map, std::vector<Box>& occupied);
/// The smallest radius of each detour round the obstacle, on its tightest arc's radius.
void draw_radii(Canvas& canvas, const Plan& near, std::size_t obstacle, const Box& map,
                std::vector<Box>& occupied);
/// strip_name() of each strip, once, on its track where that enters the map.
void draw_strip_numbers(Canvas& canvas, const Plan& near, const Box& map, std::vector<Box>& occupied);

}  // namespace tramline::render
