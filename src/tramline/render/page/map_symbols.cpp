#include "tramline/render/page/map_symbols.h"

#include <string>

#include "tramline/render/page/text.h"

namespace tramline::render {

const Hatch& obstacle_hatch() {
  static const Hatch style{kObstacleHatch, 6, 1.4, true};
  return style;
}

const Hatch& passable_hatch() {
  static const Hatch style{kPassableHatch, 7, 1.3, false};
  return style;
}

const Hatch& given_up_hatch() {
  static const Hatch style{kGivenUpHatch, 6, 1.6, false};
  return style;
}

const Hatch& not_recorded_hatch() {
  static const Hatch style{kNotRecordedHatch, 7, 1.2, true};
  return style;
}

std::vector<double> reference_dashes(double scale) { return {12 * scale, 3 * scale, 2 * scale, 3 * scale}; }

std::vector<double> idle_dashes(double scale) { return {5 * scale, 4 * scale}; }

void draw_stop_mark(Canvas& canvas, Point at, double radius) {
  disc(canvas, at, radius, kBackgroundColour);
  disc(canvas, at, 0.72 * radius, kInk);
}

void draw_arrow_head(Canvas& canvas, Point tip, Point heading, double size, Colour colour) {
  const Point aside{-heading.y, heading.x};
  const Point tail = tip - size * heading;
  fill_shape(canvas,
             {tip, tail + (0.42 * size) * aside, tip - (0.75 * size) * heading, tail - (0.42 * size) * aside},
             colour);
}

void draw_route_mark(Canvas& canvas, Point at, Colour colour) {
  const double k = canvas.scale();
  disc(canvas, at, (kRouteMarkRadius + 1.5) * k, kDetourRim);
  disc(canvas, at, kRouteMarkRadius * k, colour);
}

void draw_gap_badge(Canvas& canvas, Point centre, int number) {
  const double r = kGapBadgeRadius * canvas.scale();
  disc(canvas, centre, r, kUncoveredColour);
  disc(canvas, centre, r - 2 * canvas.scale(), kBackgroundColour);
  draw_text(canvas, centre, std::to_string(number), {kSmallTextSize, true, Align::kCentre});
}

}  // namespace tramline::render
