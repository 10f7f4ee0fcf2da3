#pragma once
// A front as a chart: overlap across, uncovered land up, turns and stops as colour.

#include <string>
#include <vector>

#include "tramline/model/front.h"
#include "tramline/render/page/canvas.h"

namespace tramline::render {

/// One axis for values from 0, on a square-root scale, because plans crowd where both areas are small.
struct FrontAxis {
  double most = 1;      ///< the value at `end_px`
  double start_px = 0;  ///< position of value 0
  double end_px = 0;
  double to_page(double value) const;
};

/// The ticks: 0 and 1, 2 and 5 times powers of ten, ascending, at least `apart_px` from one another.
std::vector<double> ticks_of(const FrontAxis& axis, double apart_px);

/// The letters of marked_points(): "A", "B" …
std::string letter_of(std::size_t marked);

/// The colour for a number of turns and stops on this front, from few to many on a square-root scale, because
/// few plans need many.
Colour colour_of(const Front& front, int turns_and_stops);

/// Chart with axes, points and letters, within `box`, pixels of the page.
void draw_front_chart(Canvas& canvas, const Front& front, const Box& box);

/// Height of the key to the colours, px at text scale 1.
inline constexpr double kColourKeyHeight = 96;
void draw_colour_key(Canvas& canvas, const Front& front, const Box& box);

/// The positions of badges for `points`, within `room`, such that no badge hides one of the points or another
/// badge, and as few of `others` as possible; pixels of the page.
std::vector<Point> place_badges_at(const std::vector<Point>& points, const std::vector<Point>& others,
                                   double radius, const Box& room);

}  // namespace tramline::render
