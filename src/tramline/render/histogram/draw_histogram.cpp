#include "tramline/render/histogram/draw_histogram.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/render/page/canvas.h"
#include "tramline/render/page/text.h"

namespace tramline::render {
namespace {

constexpr int kChartWidth_px = 1200, kChartHeight_px = 720;
constexpr Box kBarPlot{90, 130, 1150, 620};
constexpr int kMostBars = 30;

/// 1, 2 or 5 times a power of ten, at least `least`.
double round_step(double least) {
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= least) return factor * decade;
  return 10 * decade;
}

struct Bars {
  double step = 1;
  std::vector<std::size_t> counts;
  bool open_end = false;  ///< the last bar holds values beyond its end
};

Bars bars_of(std::vector<double> values) {
  Bars out;
  if (values.empty()) return out;
  std::sort(values.begin(), values.end());
  const double usual = values[static_cast<std::size_t>(0.99 * static_cast<double>(values.size() - 1))];
  out.step = usual > 0 ? round_step(usual / kMostBars) : 1;
  const auto bars = static_cast<std::size_t>(std::floor(usual / out.step)) + 1;
  out.counts.assign(bars, 0);
  for (const double value : values) {
    const double at = std::floor(value / out.step);
    const bool beyond = at >= static_cast<double>(bars);
    out.open_end = out.open_end || beyond;
    ++out.counts[beyond ? bars - 1 : static_cast<std::size_t>(at)];
  }
  return out;
}

void draw_counts(Canvas& canvas, double most) {
  const double step = std::max(1.0, round_step(most / 6));
  TextStyle beside;
  beside.align = Align::kRight;
  for (double count = 0; count <= most; count += step) {
    const double y = kBarPlot.max_y - count / most * (kBarPlot.max_y - kBarPlot.min_y);
    stroke_line(canvas, {{kBarPlot.min_x, y}, {kBarPlot.max_x, y}}, {kRule, 1});
    draw_text(canvas, {kBarPlot.min_x - 8, y}, fmt::format("{:g}", count), beside);
  }
}

void draw_bars(Canvas& canvas, const Bars& bars, double most) {
  const double width = (kBarPlot.max_x - kBarPlot.min_x) / static_cast<double>(bars.counts.size());
  TextStyle below;
  below.align = Align::kCentre;
  const std::size_t labelled = bars.counts.size() / 12 + 1;
  for (std::size_t i = 0; i < bars.counts.size(); ++i) {
    const double x = kBarPlot.min_x + static_cast<double>(i) * width;
    const double height = static_cast<double>(bars.counts[i]) / most * (kBarPlot.max_y - kBarPlot.min_y);
    fill_box(canvas, {x + 1, kBarPlot.max_y - height, x + width - 1, kBarPlot.max_y}, kTransitColour);
    if (i % labelled == 0)
      draw_text(canvas, {x, kBarPlot.max_y + 18}, fmt::format("{:g}", static_cast<double>(i) * bars.step),
                below);
  }
  if (bars.open_end) draw_text(canvas, {kBarPlot.max_x, kBarPlot.max_y + 18}, "and more", below);
}

}  // namespace

void draw_histogram(const Histogram& histogram, const std::filesystem::path& path) {
  const PictureFormat format = format_of(path);
  Canvas canvas(format, kChartWidth_px, kChartHeight_px);
  draw_text(canvas, {kBarPlot.min_x, 40}, printable(histogram.title), {26, true});
  draw_text(canvas, {kBarPlot.min_x, 78}, printable(histogram.subtitle), {});
  draw_text(canvas, {kBarPlot.min_x, 112}, "fields", {kTextSize, true});
  draw_text(canvas, {kBarPlot.max_x, kBarPlot.max_y + 56}, histogram.of, {kTextSize, true, Align::kRight});
  const Bars bars = bars_of(histogram.values);
  if (!bars.counts.empty()) {
    const auto most = static_cast<double>(*std::max_element(bars.counts.begin(), bars.counts.end()));
    draw_counts(canvas, most);
    draw_bars(canvas, bars, most);
  }
  write_whole(path, canvas.finish());
}

}  // namespace tramline::render
