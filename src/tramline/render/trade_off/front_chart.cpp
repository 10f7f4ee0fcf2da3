#include "tramline/render/trade_off/front_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "tramline/model/plain_zero.h"
#include "tramline/render/page/text.h"

namespace tramline::render {
namespace {

constexpr double kLeftRoom = 84;    ///< for the numbers of the upward axis
constexpr double kTopRoom = 44;     ///< for its name
constexpr double kBottomRoom = 66;  ///< for numbers and name of the other
constexpr double kInset = 22;       ///< from the axes to the least values
constexpr double kPointRadius = 6.5;
constexpr double kPointBadgeRadius = 13;
constexpr double kTickApart = 58;

/// Dark for few, light for many; ordered in lightness too, so that it can be read without hues.
constexpr std::array<Colour, 5> kRamp = {rgb(0x440154), rgb(0x3B528B), rgb(0x21918C), rgb(0x5EC962),
                                         rgb(0xFDE725)};

Colour ramp(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (kRamp.size() - 1);
  const auto index = std::min(static_cast<std::size_t>(place), kRamp.size() - 2);
  const double t = place - static_cast<double>(index);
  const Colour &a = kRamp[index], &b = kRamp[index + 1];
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green), a.blue + t * (b.blue - a.blue)};
}

std::pair<int, int> range_of_turns(const Front& front) {
  int least = turns_and_stops(front.points.front().tally), most = least;
  for (const FrontPoint& point : front.points) {
    least = std::min(least, turns_and_stops(point.tally));
    most = std::max(most, turns_and_stops(point.tally));
  }
  return {least, most};
}

struct Axes {
  FrontAxis overlap;
  FrontAxis uncovered;
  Point at(const Tally& tally) const {
    return {overlap.to_page(tally.overlap_m2), uncovered.to_page(tally.uncovered_m2)};
  }
};

Axes axes_in(const Front& front, const Box& plot, double k) {
  double overlap = 1, uncovered = 1;
  for (const FrontPoint& point : front.points) {
    overlap = std::max(overlap, point.tally.overlap_m2);
    uncovered = std::max(uncovered, point.tally.uncovered_m2);
  }
  return {{overlap, plot.min_x + kInset * k, plot.max_x - kInset * k},
          {uncovered, plot.max_y - kInset * k, plot.min_y + kInset * k}};
}

void draw_axes(Canvas& canvas, const Axes& axes, const Box& plot) {
  const double k = canvas.scale();
  const Stroke grid{kRule, 1 * k}, edge{kFaintInk, 1.3 * k};
  const TextStyle number{kSmallTextSize, false, Align::kCentre, kFaintInk};
  TextStyle beside = number;
  beside.align = Align::kRight;
  for (const double value : ticks_of(axes.overlap, kTickApart * k)) {
    const double x = axes.overlap.to_page(value);
    stroke_line(canvas, {{x, plot.min_y}, {x, plot.max_y}}, grid);
    draw_text(canvas, {x, plot.max_y + 16 * k}, fmt::format("{:g} m²", value), number);
  }
  for (const double value : ticks_of(axes.uncovered, 0.6 * kTickApart * k)) {
    const double y = axes.uncovered.to_page(value);
    stroke_line(canvas, {{plot.min_x, y}, {plot.max_x, y}}, grid);
    draw_text(canvas, {plot.min_x - 8 * k, y}, fmt::format("{:g} m²", value), beside);
  }
  stroke_line(canvas, {{plot.min_x, plot.min_y}, {plot.min_x, plot.max_y}, {plot.max_x, plot.max_y}}, edge);
  draw_text(canvas, {plot.min_x, plot.min_y - 18 * k}, "uncovered, square-root scale", {kTextSize, true});
  draw_text(canvas, {plot.max_x, plot.max_y + 46 * k}, "overlap, square-root scale",
            {kTextSize, true, Align::kRight});
}

void draw_point(Canvas& canvas, Point at, Colour colour) {
  const double k = canvas.scale();
  disc(canvas, at, (kPointRadius + 1) * k, kBackgroundColour);
  disc(canvas, at, kPointRadius * k, colour);
}

void draw_letters(Canvas& canvas, const Front& front, const Axes& axes, const Box& plot) {
  const double k = canvas.scale();
  std::vector<Point> marked, all;
  for (const FrontPoint& point : front.points) all.push_back(axes.at(point.tally));
  const std::vector<std::size_t> points = marked_points(front);
  for (const std::size_t point : points) marked.push_back(all[point]);
  const std::vector<Point> badges = place_badges_at(marked, all, kPointBadgeRadius * k, plot);
  for (std::size_t i = 0; i < marked.size(); ++i)
    stroke_line(canvas, {marked[i], badges[i]}, {kInk, 1.6 * k});
  for (std::size_t i = 0; i < marked.size(); ++i) {
    disc(canvas, marked[i], (kPointRadius + 3) * k, kInk);
    draw_point(canvas, marked[i], colour_of(front, turns_and_stops(front.points[points[i]].tally)));
    disc(canvas, badges[i], kPointBadgeRadius * k, kInk);
    draw_text(canvas, badges[i], letter_of(i), {kTextSize, true, Align::kCentre, kBackgroundColour});
  }
}

/// How much of a badge at `centre` is in the way: the worst is another badge or the edge of the chart.
double hindrance(Point centre, double radius, const std::vector<Point>& points,
                 const std::vector<Point>& badges, const Box& room) {
  double out = 0;
  if (centre.x - radius < room.min_x || centre.x + radius > room.max_x || centre.y - radius < room.min_y ||
      centre.y + radius > room.max_y)
    out += 100;
  for (const Point badge : badges) out += distance(badge, centre) < 2.2 * radius ? 50 : 0;
  for (const Point point : points) out += distance(point, centre) < 1.8 * radius ? 10 : 0;
  return out;
}

std::ptrdiff_t hidden(Point centre, double radius, const std::vector<Point>& points) {
  return std::count_if(points.begin(), points.end(),
                       [&](Point point) { return distance(point, centre) < 1.4 * radius; });
}

}  // namespace

double FrontAxis::to_page(double value) const {
  return start_px + std::sqrt(std::max(0.0, value) / most) * (end_px - start_px);
}

std::vector<double> ticks_of(const FrontAxis& axis, double apart_px) {
  std::vector<double> falling;
  double last_px = 2 * axis.end_px - axis.start_px;  // beyond the end
  for (double decade = std::pow(10.0, std::floor(std::log10(axis.most))); decade > 1e-3 * axis.most;
       decade /= 10)
    for (const double step : {5.0, 2.0, 1.0}) {
      const double value = step * decade, at = axis.to_page(value);
      if (value > axis.most || std::abs(at - last_px) < apart_px || std::abs(at - axis.start_px) < apart_px)
        continue;
      falling.push_back(value);
      last_px = at;
    }
  falling.push_back(0);
  return {falling.rbegin(), falling.rend()};
}

std::string letter_of(std::size_t marked) { return {static_cast<char>('A' + marked)}; }

Colour colour_of(const Front& front, int count) {
  const auto [least, most] = range_of_turns(front);
  return ramp(most > least ? std::sqrt(static_cast<double>(count - least) / (most - least)) : 0);
}

std::vector<Point> place_badges_at(const std::vector<Point>& points, const std::vector<Point>& others,
                                   double radius, const Box& room) {
  constexpr int kAngles = 16;
  std::vector<Point> out;
  for (const Point point : points) {
    Point best = point;
    double least = 1e9;
    for (const double reach : {2.4, 3.4, 4.6, 6.0})
      for (int i = 0; i < kAngles; ++i) {
        // To the upper right first: a front leaves that side free.
        const int steps = (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2);
        const double angle = (2.0 * steps / kAngles - 0.25) * std::numbers::pi;
        const Point at = point + reach * radius * Point{std::cos(angle), std::sin(angle)};
        const double in_the_way = hindrance(at, radius, points, out, room) +
                                  static_cast<double>(hidden(at, radius, others)) + 0.1 * reach + 0.01 * i;
        if (in_the_way >= least) continue;
        least = in_the_way;
        best = at;
      }
    out.push_back(best);
  }
  return out;
}

void draw_front_chart(Canvas& canvas, const Front& front, const Box& box) {
  const double k = canvas.scale();
  const Box plot{box.min_x + kLeftRoom * k, box.min_y + kTopRoom * k, box.max_x, box.max_y - kBottomRoom * k};
  const Axes axes = axes_in(front, plot, k);
  draw_axes(canvas, axes, plot);
  for (const FrontPoint& point : front.points)
    draw_point(canvas, axes.at(point.tally), colour_of(front, turns_and_stops(point.tally)));
  draw_letters(canvas, front, axes, plot);
}

void draw_colour_key(Canvas& canvas, const Front& front, const Box& box) {
  constexpr int kSteps = 64;
  const double k = canvas.scale();
  draw_text(canvas, {box.min_x, box.min_y + 10 * k}, "Turns and stops together", {kTextSize, true});
  const double top = box.min_y + 30 * k, step = box.width() / kSteps;
  const auto [least, most] = range_of_turns(front);
  for (int i = 0; i < kSteps; ++i)
    // Neighbours overlap: no seams in vector pictures.
    fill_box(canvas,
             {box.min_x + i * step, top, std::min(box.max_x, box.min_x + (i + 1.5) * step), top + 16 * k},
             most > least ? ramp((i + 0.5) / kSteps) : ramp(0));
  const double below = top + 30 * k;
  draw_text(canvas, {box.min_x, below}, std::to_string(least), {kSmallTextSize});
  if (most == least) return;
  draw_text(canvas, {box.max_x, below}, std::to_string(most), {kSmallTextSize, false, Align::kRight});
  // The colours follow the square root, as the axes do: half way along lies a quarter of the range.
  if (most - least >= 4)
    draw_text(canvas, {box.centre().x, below}, std::to_string(least + (most - least + 2) / 4),
              {kSmallTextSize, false, Align::kCentre});
}

}  // namespace tramline::render
