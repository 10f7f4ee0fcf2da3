#include "tramline/render/trade_off/draw_trade_off.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/geometry/error.h"
#include "tramline/render/page/legend.h"
#include "tramline/render/page/map_decorations.h"
#include "tramline/render/page/text.h"
#include "tramline/render/plan/small_map.h"
#include "tramline/render/trade_off/front_chart.h"

namespace tramline::render {
namespace {

constexpr double kMargin = 28;
constexpr double kTitleHeight = 62;
constexpr double kPanelWidth = 340;
constexpr double kChartHeight = 560;
constexpr double kCaptionHeight = 62;      ///< without its heading
constexpr double kHeadingLineHeight = 22;  ///< of one line
constexpr double kHeadingIndent = 36;
constexpr double kHeadingLetter = 10.6;  ///< room for one, on average
constexpr double kGap = 28;

/// The marks of a point, in as few lines as they go into.
std::vector<std::string> heading_lines(const Front& front, std::size_t point, double width, double k) {
  const auto most = static_cast<std::size_t>((width - kHeadingIndent * k) / (kHeadingLetter * k));
  std::vector<std::string> out;
  for (const char* mark : marks_of(front, point)) {
    const std::string word = mark;
    if (!out.empty() && out.back().size() + 2 + word.size() <= most)
      out.back() += ", " + word;
    else {
      if (!out.empty()) out.back() += ",";
      out.push_back(word);
    }
  }
  return out;
}

std::size_t most_heading_lines(const Front& front, double width, double k) {
  std::size_t out = 1;
  for (const std::size_t point : marked_points(front))
    out = std::max(out, heading_lines(front, point, width, k).size());
  return out;
}

/// The page from top to bottom: title, chart with the panel beside it, rows of small maps.
struct Layout {
  int width_px = 0, height_px = 0;
  double k = 1;
  Box title, chart, key;
  PageLayout panel;  ///< for draw_legend()
  int columns = 1;
  double cell_width = 0, caption_height = 0, map_height = 0, maps_top = 0;

  Box map(std::size_t index) const {
    const auto across = static_cast<std::size_t>(columns);
    const std::size_t row_number = index / across;
    const auto column = static_cast<double>(index % across), row = static_cast<double>(row_number);
    const double left = kMargin * k + column * (cell_width + kGap * k);
    const double top = maps_top + row * (map_height + caption_height + kGap * k) + caption_height;
    return {left, top, left + cell_width, top + map_height};
  }
  Box caption(std::size_t index) const {
    const Box below = map(index);
    return {below.min_x, below.min_y - caption_height, below.max_x, below.min_y};
  }
};

Layout lay_out(const Box& drawn_m, const Front& front, int width_px, double legend_height) {
  const std::size_t maps = marked_points(front).size();
  Layout out;
  out.width_px = width_px;
  out.k = std::max(1.0, width_px / 1600.0);
  const double k = out.k, left = kMargin * k, right = width_px - kMargin * k;
  const double top = (kMargin + kTitleHeight) * k;
  const double chart_height = std::max(kChartHeight, kColourKeyHeight + legend_height) * k;
  const double panel_left = right - std::min(kPanelWidth * k, 0.4 * width_px);
  out.title = {left, kMargin * k, right, top};
  out.chart = {left, top, panel_left - kGap * k, top + chart_height};
  out.key = {panel_left, top, right, top + kColourKeyHeight * k};
  out.panel.panel = {panel_left, out.key.max_y, right, top + chart_height};

  out.columns = maps > 4 ? 3 : std::max(3, static_cast<int>(maps));
  out.cell_width = (right - left - (out.columns - 1) * kGap * k) / out.columns;
  const auto headings = static_cast<double>(most_heading_lines(front, out.cell_width, k));
  out.caption_height = (kCaptionHeight + headings * kHeadingLineHeight) * k;
  out.map_height = small_map_height(drawn_m, out.cell_width);
  out.maps_top = out.chart.max_y + kGap * k;
  out.height_px = static_cast<int>(std::ceil(out.map(maps - 1).max_y + kMargin * k));
  return out;
}

std::string count_of(int count, const char* one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

void draw_caption(Canvas& canvas, const Box& box, const Front& front, std::size_t marked, std::size_t index) {
  const double k = canvas.scale();
  const FrontPoint& point = front.points[index];
  const Point badge{box.min_x + 13 * k, box.min_y + 14 * k};
  disc(canvas, badge, 13 * k, kInk);
  draw_text(canvas, badge, letter_of(marked), {kTextSize, true, Align::kCentre, kBackgroundColour});
  const TextStyle bold{kTextSize, true}, plain{kSmallTextSize, false, Align::kLeft, kFaintInk};
  double y = badge.y;
  for (const std::string& line : heading_lines(front, index, box.width(), k)) {
    const double room = box.width() - kHeadingIndent * k;
    draw_text(canvas, {box.min_x + kHeadingIndent * k, y}, fitted(canvas, line, bold, room), bold);
    y += kHeadingLineHeight * k;
  }
  const auto row = [&](const std::string& text) {
    draw_text(canvas, {box.min_x, y + 6 * k}, fitted(canvas, text, plain, box.width()), plain);
    y += 22 * k;
  };
  row(fmt::format("overlap {:.0f} m², uncovered {:.0f} m²", std::abs(point.tally.overlap_m2),
                  std::abs(point.tally.uncovered_m2)));
  row(fmt::format("{}, {}, cost {:.2f}", count_of(point.tally.turns, "turn"),
                  count_of(point.tally.stops, "stop"), point.cost));
}

std::string subtitle_of(const Front& front, const Plan& plan) {
  return fmt::format(
      "{} plans to choose from, working width {:g} m; cost {:g} per m² overlap, {:g} per m² "
      "uncovered, {:g} a turn, {:g} a stop",
      front.points.size(), plan.machine.width_m, front.prices.overlap, front.prices.uncovered,
      front.prices.turn, front.prices.stop);
}

}  // namespace

void draw_trade_off(const Front& front, const std::vector<Plan>& plans, const std::filesystem::path& path,
                    const PictureOptions& options) {
  assert(plans.size() == marked_points(front).size());
  const PictureFormat format = format_of(path);
  require_picture_width(options);
  if (front.points.empty() || plans.empty()) throw bad_input("the trade-off has no plan to draw");
  const std::vector<LegendBlock> legend{legend_of_all(plans)};
  const Box drawn = drawn_box(plans);
  const Layout page = lay_out(drawn, front, options.width_px, heights_of(legend).front());

  Canvas canvas(format, page.width_px, page.height_px);
  canvas.use({}, page.k);
  const std::string& id = plans.front().field.id;
  draw_title(canvas, page.title, id.empty() ? "field" : id, subtitle_of(front, plans.front()));
  draw_front_chart(canvas, front, page.chart);
  draw_colour_key(canvas, front, page.key);
  draw_legend(canvas, page.panel, legend);
  const std::vector<std::size_t> marked = marked_points(front);
  for (std::size_t i = 0; i < plans.size(); ++i) {
    draw_caption(canvas, page.caption(i), front, i, marked[i]);
    draw_small_map(canvas, plans[i], drawn, page.map(i), page.k);
  }
  write_whole(path, canvas.finish());
}

}  // namespace tramline::render
