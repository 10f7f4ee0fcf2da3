#include "tramline/render/page/map_decorations.h"

#include <fmt/format.h>

#include <cmath>

#include "tramline/render/page/text.h"

namespace tramline::render {
namespace {

constexpr double kLongestBar = 300;
constexpr double kBarHeight = 9;

void draw_north_arrow(Canvas& canvas, Point centre) {
  const double k = canvas.scale();
  const Point tip = centre - Point{0, 24 * k};
  const Point foot = centre + Point{0, 8 * k};
  fill_shape(canvas, {tip, foot + Point{-10 * k, 8 * k}, foot}, kInk);
  stroke_line(canvas, {tip, foot + Point{10 * k, 8 * k}, foot, tip}, {kInk, 1.2 * k});
  draw_text(canvas, centre + Point{22 * k, 0}, "N", {kTextSize, true, Align::kCentre});
}

}  // namespace

double round_length(double at_most) {
  const double decade = std::pow(10.0, std::floor(std::log10(at_most)));
  for (const double step : {5.0, 2.0})
    if (step * decade <= at_most * (1 + 1e-12)) return step * decade;
  return decade;
}

void draw_title(Canvas& canvas, const Box& box, const std::string& title, const std::string& subtitle) {
  const double k = canvas.scale();
  const TextStyle large{26, true};
  const TextStyle small{kTextSize, false, Align::kLeft, kFaintInk};
  const double middle = box.min_y + 15 * k;
  const std::string shown = fitted(canvas, printable(title), large, 0.6 * box.width());
  draw_text(canvas, {box.min_x, middle}, shown, large);
  const double used = text_width(canvas, shown, large) + 20 * k;
  draw_text(canvas, {box.min_x + used, middle + 3 * k},
            fitted(canvas, printable(subtitle), small, box.width() - used), small);
  stroke_line(canvas, {{box.min_x, middle + 27 * k}, {box.max_x, middle + 27 * k}}, {kRule, 1.2 * k});
}

void draw_scale_strip(Canvas& canvas, const Box& strip) {
  const double k = canvas.scale();
  const double y = strip.centre().y + 2 * k;
  draw_north_arrow(canvas, {strip.min_x + 22 * k, y});
  const double px_per_m = canvas.view().px_per_m;
  const double length_m = round_length(kLongestBar * k / px_per_m);
  const double left = strip.min_x + 92 * k;
  const double half = 0.5 * length_m * px_per_m;
  const double high = kBarHeight * k;
  const TextStyle style{kSmallTextSize, false, Align::kCentre};
  fill_box(canvas, {left, y + 4 * k, left + half, y + 4 * k + high}, kInk);
  stroke_line(canvas,
              {{left, y + 4 * k},
               {left + 2 * half, y + 4 * k},
               {left + 2 * half, y + 4 * k + high},
               {left, y + 4 * k + high},
               {left, y + 4 * k}},
              {kInk, 1.2 * k});
  const double text_y = y - 10 * k;
  draw_text(canvas, {left, text_y}, "0", style);
  draw_text(canvas, {left + half, text_y}, fmt::format("{:g}", 0.5 * length_m), style);
  draw_text(canvas, {left + 2 * half, text_y}, fmt::format("{:g} m", length_m), style);
}

}  // namespace tramline::render
